// What is required of the shape of simplices, through the C header.
#include <array>

#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

const std::vector<std::int32_t> kHalves = {0, 1, 2, 0, 2, 3};

Checked required(std::vector<const char*> texts, const char* except_sharp = nullptr,
                 const char* within = nullptr) {
  const circumspect_mesh mesh = mesh_of(kCorners, kHalves);
  const circumspect_domain domain = square();
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.require_count = static_cast<std::int64_t>(texts.size());
  options.require = texts.data();
  options.except_sharp = except_sharp;
  options.within = within;
  return check("cdt", &mesh, &domain, &options);
}

}  // namespace

TEST_CASE("requirements are judged, with a domain that is moved or not") {
  for (const char* const within : {static_cast<const char*>(nullptr), "0.001"}) {
    const Checked kept = required({"min-angle:45deg", "area <= 1/2"}, nullptr, within);
    REQUIRE(kept.status == CIRCUMSPECT_OK);
    CHECK(circumspect_verdict_holds(kept.verdict.get()) == 1);
    CHECK(has(circumspect_verdict_text(kept.verdict.get()), " min-angle:45deg area:1/2"));
    const Checked broken = required({"max-angle:89deg"}, nullptr, within);
    REQUIRE(broken.status == CIRCUMSPECT_OK);
    std::int64_t count = 0;
    CHECK(std::string(circumspect_verdict_rule(broken.verdict.get(), 0, &count)) ==
          "quality.max-angle");
    CHECK(count == 2);
    circumspect_violation shown;
    REQUIRE(circumspect_verdict_violation(broken.verdict.get(), 0, &shown, sizeof shown) ==
            CIRCUMSPECT_OK);
    CHECK(std::string(shown.values[0].exact) == "0");
    const Checked aside = required({"max-angle:89deg"}, "91deg", within);
    CHECK(has(circumspect_verdict_text(aside.verdict.get()), " except-sharp:91deg 2 set-aside"));
  }
}

TEST_CASE("requirements that make no sense are wrong arguments") {
  const auto refused = [](std::vector<const char*> texts, const char* except_sharp,
                          const char* part) {
    CHECK(required(std::move(texts), except_sharp).status == CIRCUMSPECT_INVALID_ARGUMENT);
    CHECK(has(circumspect_last_error(), part));
  };
  refused({"min-angle"}, nullptr, "min-angle:20.7deg");
  refused({nullptr}, nullptr, "a requirement");
  refused({"volume:1"}, nullptr, "expected a measure of triangles");
  refused({"min-edge:2", "edge:1"}, nullptr, "contradict");
  refused({"edge:1"}, "200deg", "at most 180deg");
  refused({}, "60deg", "beside `except_sharp`");
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.require_count = 1;
  const circumspect_mesh mesh = mesh_of(kCorners, kHalves);
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  options.require_count = -1;
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  // The options of an earlier version end before the requirements.
  options.struct_size = offsetof(circumspect_options, require_count);
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_OK);
}

}  // namespace circumspect::c
