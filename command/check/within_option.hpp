// --within DISTANCE: how far the cells of a domain may have been moved.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "kernel/exact/number.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::cli {

// An exact number: a distance, or how many times the longest side of the bounding box of the
// domain.
struct Distance {
  Rational number = 0;
  bool relative = false;

  Rational squared(const PiecewiseLinearComplex& complex) const;
  Rational squared(const std::vector<Point>& points) const;
};

// Adds --within; nothing if it is not given.
void add_within_option(CLI::App& command, std::optional<Distance>& distance);

// Is all that is wrong that vertices, segments and polygons of the domain are not in the mesh, or
// that it is not its convex hull, if it is to be? Then they may have been rounded.
bool may_be_rounded(const Verdict& verdict, DomainKind kind);
// What to say of such a mesh, if its cells were moved by no more than this: the number of breaches,
// and what is left of them. `moved` is the verdict under --within.
inline constexpr long kRoundedParts = 1'000'000'000;  // of the longest side of the bounding box
std::string rounding_note(const Verdict& exact, const Verdict& moved);
// The same if polygons of one plane are joined, and cells moved as far as `merged` says, if it
// does.
std::string merging_note(const Verdict& exact, const Verdict& merged);
// The same if polygons of nearly one plane are joined, which are flat up to the square root of
// `squared_height`.
inline constexpr long kBentParts = 100'000;  // of the longest side of the bounding box
inline const Rational kUsualSlope =
    Rational(to_integer(1745329251994329), to_integer(1'000'000'000'000'000'000));  // of 0.1deg
std::string bending_note(const Verdict& exact, const Verdict& bent, const Rational& squared_height);

}  // namespace circumspect::cli
