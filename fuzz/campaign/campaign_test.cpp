#include "fuzz/campaign/campaign.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {
namespace {

// There may be no memory for what is told, while the runners work.
TEST_CASE("what throws while progress is told ends the campaign, and is thrown") {
  const formats::ScratchFolder folder;
  Plan plan;
  plan.subject.command = {"/bin/sh", "-c", "sleep 60", "{points}", "{mesh}"};
  plan.replayed.push_back(
      {"tetrahedron", PointsCase{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}}});
  plan.jobs = 2;
  plan.goes_on = true;
  plan.output = folder.path("campaign");
  const std::atomic<bool> stop = false;
  const auto begun = std::chrono::steady_clock::now();
  const auto throws = [](const Progress&) { throw std::runtime_error("no room"); };
  CHECK_THROWS_WITH_AS(static_cast<void>(run(plan, stop, throws)), "no room", std::runtime_error);
  CHECK(std::chrono::steady_clock::now() - begun < std::chrono::seconds(30));
}

}  // namespace
}  // namespace circumspect::campaign
