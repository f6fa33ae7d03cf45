// Points, and what is said of them, as they stand in the file of a certificate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/certificate/scaled_points.hpp"

namespace circumspect::certificate {

// Its coordinates as integers, and then their denominator.
std::string text_of(const Point& point);

// Weights of the corners of a triangle in space and of a point in its plane, as they stand in a
// file: integers that sum up to nothing, as the points times them do; the last, that of the point,
// is positive.
std::string balance(const std::vector<Point>& triangle, const Point& point);

// The way from one point to another through triangles of a plane in space, as it stands in a file:
// how many times it goes from one into the next, each time out of which and where, and the last
// one; counted from 1. Nothing if they do not cover it.
std::optional<std::string> way_through(const std::vector<std::vector<Point>>& triangles,
                                       const Point& from, const Point& to);

}  // namespace circumspect::certificate
