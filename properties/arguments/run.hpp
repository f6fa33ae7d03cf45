// Running a RapidCheck property a stated number of times inside a doctest case.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include <rapidcheck.h>

namespace circumspect::properties {

// The sanitizers look for faults of memory, and take ten times as long: a twelfth of the inputs
// will do. GCC says so by a macro, Clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
#define CIRCUMSPECT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CIRCUMSPECT_SANITIZED
#endif
#endif
#ifdef CIRCUMSPECT_SANITIZED
inline constexpr int kOneInputIn = 12;
#else
inline constexpr int kOneInputIn = 1;
#endif

// How many points a grid has along each axis: two fifths under the sanitizers, and where code that
// is not optimized counts what is run.
#ifdef CIRCUMSPECT_SMALL_GRIDS
inline constexpr bool kHasSmallGrids = true;
#else
inline constexpr bool kHasSmallGrids = kOneInputIn > 1;
#endif
constexpr std::size_t points_a_side(std::size_t side) {
  return kHasSmallGrids ? side * 2 / 5 : side;
}

// Does the property hold on `successes` random inputs? RapidCheck prints what fails, shrunk. Seed
// and sizes come from RC_PARAMS, as for every RapidCheck property. CIRCUMSPECT_ONE_INPUT_IN=4 in
// the environment tries a quarter of them, as `make test` does. Compiled once, in test_main.cpp:
// the templates behind it take RapidCheck's users a quarter of a second a property.
bool holds(const std::string& description, int successes, const std::function<void()>& property);
// The same on as many inputs as RapidCheck tries of itself (a hundred), whatever the environment
// says: for the laws of single functions. Both pass over the inputs for which no time is left.
bool holds(const std::string& description, const std::function<void()>& property);
bool holds(const std::function<void()>& property);

// How many inputs there are for each that is tried: CIRCUMSPECT_ONE_INPUT_IN, and more under the
// sanitizers.
int one_input_in();

// Has this program time for another input? A soak gives it seconds (CIRCUMSPECT_SECONDS), counted
// from its start; elsewhere it has all the time it takes.
bool has_time();
// Prints how many inputs were tried ("inputs: 12 of 500") if the program has been given seconds.
void say_inputs(int tried, int asked);

// Calls `test` with `count` seeds, as long as there is time: those from `first` on, and in a soak
// others each time, as its RC_PARAMS say. What follows from the number of inputs is to be asked
// of the number that comes back.
int try_seeds(std::uint64_t first, int count, const std::function<void(std::uint64_t)>& test);

// Has a kind of input been drawn, often enough for all its inputs, that a property must not do
// without? The fixed inputs of `make test` have all of them. A soak, which says so in its
// environment (CIRCUMSPECT_SOAK), draws new ones each round, where a rare kind may well be missing
// once: it does not ask. Nor do the sanitizers, which see fewer.
bool occurs(std::size_t often, std::size_t at_least = 1);

}  // namespace circumspect::properties
