// The table of faults: what each is, and how it was found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "properties/faulty/hunt.hpp"

namespace circumspect::faulty {

struct Found {
  const Fault* fault;
  std::optional<Catch> caught;
};

// Every fault, hunted.
std::vector<Found> hunt_all(const HuntOptions& options = {});

// As Markdown, with the sum of it. The same on every machine.
std::string table(const std::vector<Found>& all);

}  // namespace circumspect::faulty
