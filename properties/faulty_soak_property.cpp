// Every planted fault is found, soon, and nothing is found in programs without one. The table of
// them is what comes out.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "properties/arguments/run.hpp"
#include "properties/faulty/hunt.hpp"

namespace circumspect::properties {
namespace {

using faulty::Fault;
using faulty::Found;

TEST_CASE("the planted faults are ninety at least, each with its own name and a description") {
  std::set<std::string> names;
  for (const Fault& fault : faulty::faults()) {
    CAPTURE(fault.name);
    CHECK(names.insert(fault.name).second);
    CHECK(fault.about.size() > 20);
    CHECK(fault.about.back() == '.');
    CHECK((fault.triangulate == nullptr) != (fault.mesh == nullptr));
  }
  CHECK(names.size() >= 90);
}

// Nothing is to be found in the programs without a fault that make the same claim, on the inputs
// that it took to find this one. Returns how many such programs there are.
std::size_t check_right_programs(const Fault& fault, std::size_t inputs) {
  std::size_t programs = 0;
  for (Fault right : faulty::right_programs()) {
    if (right.claim != fault.claim) continue;
    ++programs;
    CAPTURE(right.name);
    right.name = fault.name;
    right.dimensions = fault.dimensions;
    right.most_points = fault.most_points;
    right.needs_many = fault.needs_many;
    const auto caught = faulty::hunt(right, {.most_inputs = inputs});
    CHECK((caught ? caught->rule : "") == "");
  }
  return programs;
}

TEST_CASE("every planted fault is found, and on the same inputs nothing in right programs") {
  const std::vector<Found> all = faulty::hunt_all();
  const auto one_in = static_cast<std::size_t>(one_input_in());
  std::vector<std::size_t> inputs;
  for (const Found& found : all) {
    const Fault& fault = *found.fault;
    CAPTURE(fault.name);
    REQUIRE(found.caught.has_value());
    CHECK(found.caught->by_definition);
    CHECK(check_right_programs(fault, (found.caught->inputs + one_in - 1) / one_in) > 0);
    inputs.push_back(found.caught->inputs);
  }
  std::sort(inputs.begin(), inputs.end());
  CHECK(inputs[inputs.size() / 2] < 1000);
  std::ifstream readme(CIRCUMSPECT_CORPUS_DIR "/../properties/faulty/README.md");
  const std::string page{std::istreambuf_iterator<char>(readme), {}};
  INFO("`faulty_report properties/faulty/README.md` writes the table that comes out now");
  CHECK(page.find("\n" + faulty::table(all) + "\n") != std::string::npos);
}

}  // namespace
}  // namespace circumspect::properties
