// Makes a failing input small: fewer points and cells, coordinates nearer to small integers, as
// long as it fails in the same way.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

#include "inputs/cases.hpp"
#include "inputs/updates.hpp"

namespace circumspect::generators {

// Limits on the search. The time limit is meant for slow programs: the result depends on it only if
// it runs out. The smallest input so far is returned, even if `stop` became true.
struct MinimiseLimits {
  std::size_t tries = 50'000;
  std::chrono::duration<double> time = std::chrono::seconds(120);
  const std::atomic<bool>* stop = nullptr;
};

// Chunks of points are dropped, half of all at first (delta debugging: Zeller and Hildebrandt,
// "Simplifying and isolating failure-inducing input", 2002), then coordinates and weights are
// moved: those of all points at once (ranks, coarser grids, the origin), then one by one. In the
// end, no single point can be left out. Equal points appear only if the input had some.
// `still_fails` is never asked about the same input twice in a row. Requires: it fails;
// still_fails(it) may be asked any number of times.
template <class Case>
using StillFails = std::function<bool(const Case&)>;

PointsCase minimised(PointsCase set, const StillFails<PointsCase>& still_fails,
                     const MinimiseLimits& limits = {});

// The same for domains: polygons, segments and hole seeds are dropped, then vertices that no cell
// uses, then coordinates are moved. If the input is valid, `still_fails` is asked only about valid
// inputs.
ComplexCase minimised(ComplexCase whole, const StillFails<ComplexCase>& still_fails,
                      const MinimiseLimits& limits = {});

// The same for points that come and go: points are dropped with everything that happens to them,
// then updates are dropped, then coordinates are moved. A point whose insertion is left out is
// there from the beginning.
UpdatesCase minimised(UpdatesCase whole, const StillFails<UpdatesCase>& still_fails,
                      const MinimiseLimits& limits = {});

// Simpler coordinates, with fewer digits.

// The length of the number in bits; a sign counts as half a bit more. Returned in half bits.
std::size_t length(const Rational& value);
std::size_t length(const PointsCase& set);

// Moves the coordinates and the weights of all points at once, then one by one, to shorter numbers,
// as long as `accepts` accepts them, until `is_over`. Returns whether anything became shorter.
// Doubles whose magnitude is not near the largest become doubles.
bool simplify_numbers(PointsCase& set, const std::function<bool(const PointsCase&)>& accepts,
                      const std::function<bool()>& is_over);

}  // namespace circumspect::generators
