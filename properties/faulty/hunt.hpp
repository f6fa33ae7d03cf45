// Hunting planted faults, and the table of what found them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/faulty/fault.hpp"

namespace circumspect::faulty {

// How many inputs it takes until a fault shows, and how small it can be made.

struct Catch {
  std::size_t inputs = 0;        // drawn, the last of which failed
  std::string family;            // of that one
  std::string rule;              // that it broke first, or "crash: " and what was thrown
  std::size_t points = 0;        // of it,
  std::size_t least_points = 0;  // and of what was left when it was minimised
  bool by_definition = false;    // does that break the claim by definition too?
};

struct HuntOptions {
  std::uint64_t seed = 20260101;  // the inputs follow from it and from the fault's name
  std::size_t most_inputs = 10000;
  std::size_t most_trials = 1000;  // of smaller inputs, while the same rule is broken
};

// The first of the random inputs on which the fault is found; nothing if it never is.
std::optional<Catch> hunt(const Fault& fault, const HuntOptions& options = {});

// The table of faults: what each is, and how it was found.

struct Found {
  const Fault* fault;
  std::optional<Catch> caught;
};

// Every fault, hunted.
std::vector<Found> hunt_all(const HuntOptions& options = {});

// As Markdown, with the sum of it. The same on every machine.
std::string table(const std::vector<Found>& all);

}  // namespace circumspect::faulty
