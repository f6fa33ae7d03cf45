// Makes a failing input small: fewer points and cells, coordinates nearer to small integers, as long as
// it fails in the same way.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

#include "inputs/cases.hpp"
#include "inputs/updates.hpp"

namespace circumspect::generators {

// When to stop, if nothing simpler is found before. The time is there for programs that are slow: the
// result depends on it only if it runs out. The smallest input so far is returned, also where `stop` became true.
struct MinimiseLimits {
  std::size_t tries = 50'000;
  std::chrono::duration<double> time = std::chrono::seconds(120);
  const std::atomic<bool>* stop = nullptr;
};

// Chunks of points are dropped, half of all at first (delta debugging: Zeller and Hildebrandt,
// "Simplifying and isolating failure-inducing input", 2002), then coordinates and weights are moved:
// those of all points at once (ranks, coarser grids, the origin), then one by one. In the end no
// point can be left out alone. Equal points appear only if the input had some.
// `still_fails` is asked about inputs that are never the same twice in a row.
// Requires: it fails; still_fails(it) may be asked any number of times.
template <class Case>
using StillFails = std::function<bool(const Case&)>;

PointsCase minimised(PointsCase set, const StillFails<PointsCase>& still_fails,
                     const MinimiseLimits& limits = {});

// The same for domains: polygons, segments and hole seeds are dropped, then vertices that no cell uses,
// then coordinates are moved. `still_fails` is asked about valid inputs only, if it is one.
ComplexCase minimised(ComplexCase whole, const StillFails<ComplexCase>& still_fails,
                      const MinimiseLimits& limits = {});

// The same for points that come and go: points go with all that happens to them, then updates, then coordinates are
// moved. A point whose insertion is left out is there from the beginning.
UpdatesCase minimised(UpdatesCase whole, const StillFails<UpdatesCase>& still_fails,
                      const MinimiseLimits& limits = {});

// ---- Shorter numbers ----
// Coordinates that say the same in fewer digits.

// How long it takes to write the number down, in bits; a sign counts as half a bit more. Returned in
// half bits.
std::size_t length(const Rational& value);
std::size_t length(const PointsCase& set);

// Moves the coordinates and the weights of all points at once, then one by one, to numbers that are
// shorter, as long as `accepts` takes them, until `is_over`. Returns whether anything became shorter. Doubles
// whose magnitude is not near the largest become doubles.
bool simplify_numbers(PointsCase& set, const std::function<bool(const PointsCase&)>& accepts,
                      const std::function<bool()>& is_over);

}  // namespace circumspect::generators
