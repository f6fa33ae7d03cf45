// The points of a family, for tests that draw inputs by themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <circumspect/subject.hpp>

namespace circumspect {

// The families of the dimension whose points are distinct doubles without weights, by the names
// that `circumspect generate --list` prints. Empty: there is none in the dimension.
std::vector<std::string> families(std::size_t dimension);

// At most `max_points` points, the same on every machine: those of `circumspect generate FAMILY
// --fewer --points MAX --dimension D --seed SEED`. Throws std::invalid_argument: a family that is
// unknown, or does not exist in the dimension; no points.
PointArray drawn_points(const std::string& family, std::size_t dimension, std::size_t max_points,
                        std::uint64_t seed);

// Do the points span only a flat of lower dimension? There, rows of fewer indices are the answer,
// if a program has one.
bool are_flat(const PointArray& points);

}  // namespace circumspect
