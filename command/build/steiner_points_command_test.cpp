// build steiner-cdt: which algorithm makes it, and how many Steiner points it takes.
#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

const std::string kDomains = std::string(CIRCUMSPECT_CORPUS_DIR) + "/domains/";

}  // namespace

TEST_CASE("build steiner-cdt: all algorithms give the same files") {
  const ScratchFolder folder;
  const std::string domain = kDomains + "figure-4-13-chazelle-2.poly";
  const std::string usual = folder.path("usual.ele");
  CHECK(run({"build", "steiner-cdt", domain, "-o", usual}).exit_code == 0);
  for (const std::string algorithm : {"gift-wrapping", "polygon-flips", "polygon-cavities"}) {
    const std::string mesh = folder.path(algorithm + ".ele");
    CHECK(run({"build", "steiner-cdt", domain, "--algorithm", algorithm, "-o", mesh}).exit_code ==
          0);
    CHECK(contents(mesh) == contents(usual));
  }
}

TEST_CASE("build steiner-cdt: a needle takes few Steiner points, and a limit ends in exit code 4") {
  const ScratchFolder folder;
  const std::string domain = kDomains + "needle.poly";
  const std::string mesh = folder.path("needle.1.ele");
  const std::vector<std::string> build = {"build", "steiner-cdt", domain, "--domain-kind",
                                          "hull",  "-o",          mesh,   "--steiner-points"};
  const auto with_limit = [&](const std::string& limit) {
    std::vector<std::string> arguments = build;
    arguments.push_back(limit);
    return run(arguments);
  };
  const Run limited = with_limit("1");
  CHECK(limited.exit_code == 4);
  CHECK(limited.out == "undecided: steiner-cdt " + domain +
                           ": 1 Steiner points do not suffice; --steiner-points allows more\n");
  CHECK(!std::filesystem::exists(mesh));
  const Run built = with_limit("8");
  CHECK_MESSAGE(built.exit_code == 0, built.out);
  const Run checked =
      run({"check", mesh, "--domain", domain, "--domain-kind", "hull", "--claim", "steiner-cdt"});
  CHECK_MESSAGE(checked.exit_code == 0, checked.out);
}

}  // namespace circumspect::cli
