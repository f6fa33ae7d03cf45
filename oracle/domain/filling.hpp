// Which of the regions that walls enclose a domain fills, by the rules that programs have for it.
// Book: Section 4.5.1 ("the underlying space … the domain to be triangulated").
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/piecewise_linear/regions.hpp"

namespace circumspect {

// What is filled: all that is enclosed; of that, what is entered from outside by an odd number of
// walls; what the walls wind around, as they are listed, another number of times than 0; the convex
// hull.
enum class Fill { kEnclosed, kEvenOdd, kWinding, kHull };

// "enclosed", "even-odd", "winding", "hull"
std::string_view name(Fill fill);

inline DomainKind kind_of(Fill fill) {
  return fill == Fill::kHull ? DomainKind::kHull : DomainKind::kEnclosed;
}

// How few walls a way from the outside to each region has to cross: 0 for the unbounded one, and
// one more than the least of those beside it for each other. Where every way to a region crosses an
// even number of walls, or every way an odd one, the level is even, or odd, too.
struct NestingLevels {
  std::vector<std::size_t> of_region;
  // A wall between two regions of levels that are both even or both odd, if there is one: then
  // whether the number is even depends on the way.
  std::optional<std::size_t> wall_of_no_parity;
};
NestingLevels nesting_levels(const Regions& regions);

// How often each wall counts from its back to its front, by its place: 1 if it is listed so that
// its front is on the left of it (in the plane), or so that it turns clockwise seen from its front
// (in space); −1 if it is listed the other way about; the sum of these if a segment is listed
// several times. A polygon of several lines turns as that of the greatest area does.
// Requires: the regions of the complex, which is what `validated` or `assemble` made of the input.
std::vector<int> listed_directions(const PiecewiseLinearInput& input,
                                   const PiecewiseLinearComplex& complex, const Regions& regions);

// How often the walls wind around each region: 0 for the unbounded one, and going from the back of
// a wall to its front adds its direction. Walls with one region on both sides do not count.
// Errors: the place of a wall across which the numbers of two ways differ: the walls around a
// region are not listed as one surface that is turned one way.
tl::expected<std::vector<int>, std::size_t> winding_numbers(const Regions& regions,
                                                            const std::vector<int>& directions);

// A point in each region that is enclosed and, by a rule, not filled: seeds of holes. What of the
// regions is a hole already does not matter.
// Errors: those of winding_numbers. Requires: as listed_directions.
tl::expected<std::vector<Point>, std::size_t> seeds_of_unfilled(
    Fill fill, const PiecewiseLinearInput& input, const PiecewiseLinearComplex& complex,
    const Regions& regions);

// The same of regions that have none of these points in them.
// Errors: the place of a point that is in nothing enclosed, or on a wall.
tl::expected<std::vector<Point>, std::size_t> seeds_of_unnamed(const std::vector<Point>& named,
                                                               const Regions& regions);

// A point of each region but the unbounded one, by its number; for that one any point.
std::vector<Point> points_of_regions(const Regions& regions);

}  // namespace circumspect
