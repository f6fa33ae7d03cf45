// What is no value of an option is answered with those that are, not in the words of CLI11.
#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

TEST_CASE("counts and words that are none: what was expected, and what was found") {
  const std::vector<std::string> steiner = {"build", "conforming-delaunay", "x.poly", "-o",
                                            "y.ele"};
  const auto said = [](std::vector<std::string> arguments, const std::string& option,
                       const std::string& value) {
    arguments.insert(arguments.end(), {option, value});
    const Run result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    return result.err.substr(0, result.err.find('\n'));
  };
  const std::string any = ": expected a whole number from 0 to 2^64 - 1, found ";
  CHECK(said({"inspect", "x.node"}, "--subsets", "-1") == "--subsets" + any + "-1");
  CHECK(said({"inspect", "x.node"}, "--subsets", "1e3") == "--subsets" + any + "1e3");
  CHECK(said({"inspect", "x.poly"}, "--max-errors", "foo") == "--max-errors" + any + "foo");
  CHECK(said({"inspect", "x.poly"}, "--search-vertices", "-1") == "--search-vertices" + any + "-1");
  CHECK(said({"inspect", "x.poly"}, "--search-conflicts", "") == "--search-conflicts" + any);
  CHECK(said(steiner, "--steiner-points", "-1") == "--steiner-points" + any + "-1");
  CHECK(said({"build", "all-triangulations", "x"}, "--max-points", "-1") ==
        "--max-points" + any + "-1");
  CHECK(said({"build", "delaunay", "x", "-o", "-"}, "--seed", "foo") == "--seed" + any + "foo");
  CHECK(said({"build", "delaunay-subdivision", "x"}, "--algorithm", "magic") ==
        "--algorithm: expected by-definition|gift-wrapping-cells|lifted-hull, found magic");
  CHECK(said({"generate", "integers"}, "--points", "0") ==
        "--points: expected a whole number from 1 to 1000000, found 0");
  CHECK(said({"generate", "integers"}, "--coordinates", "float") ==
        "--coordinates: expected double|exact, found float");
  CHECK(said({"campaign"}, "--jobs", "0") ==
        "--jobs: expected a whole number from 1 to 256, found 0");
  CHECK(said({"campaign"}, "--first-index", "2") ==
        "--first-index: expected a whole number from 0 to 1, found 2");
  CHECK(said({"campaign"}, "--dimension", "9") ==
        "--dimension: expected a whole number from 1 to 8, found 9");
}

}  // namespace
}  // namespace circumspect::cli
