// Requirements as people write them: what they mean, and what is said of those that mean nothing.
#include "oracle/model/measure.hpp"

#include <doctest/doctest.h>

namespace circumspect {
namespace {

std::string fault_of(const char* text) {
  const auto requirement = read_requirement(text);
  return requirement ? "" : requirement.error();
}

Requirement required(const char* text) { return read_requirement(text).value(); }

bool mentions(const std::string& text, const char* part) { return text.find(part) != text.npos; }

TEST_CASE("measures: each is at its place, and its requirement is read back") {
  for (std::size_t i = 0; i < measures().size(); ++i) {
    const MeasureEntry& one = measures()[i];
    CHECK(static_cast<std::size_t>(one.measure) == i);
    CHECK(entry(one.measure).name == one.name);
    const Requirement read =
        required((std::string(one.name) + (one.is_angle ? ":100deg" : ":3")).c_str());
    CHECK(read.measure == one.measure);
    CHECK(read.bound == (one.is_angle ? 100 : 9));
    CHECK(read.text == std::string(one.name) + (one.is_at_least ? " >= " : " <= ") +
                           (one.is_angle ? "100deg" : "3"));
    CHECK(read.word() == std::string(one.name) + (one.is_angle ? ":100deg" : ":3"));
    CHECK(identifier(one.rule) == "quality." + std::string(one.name));
  }
}

TEST_CASE("requirements: numbers mean what is written") {
  CHECK(required(" min-angle  >=  20.7 deg ").bound == Rational(207, 10));
  CHECK(required(" min-angle  >=  20.7 deg ").word() == "min-angle:20.7deg");
  CHECK(required("min-angle:1/3deg").bound == Rational(1, 3));
  CHECK(required("radius-edge <= sqrt(2)").bound == 2);
  CHECK(required("radius-edge:sqrt( 9/4 )").bound == Rational(9, 4));
  CHECK(required("volume:0.1").bound == Rational(1, 100));
  CHECK(required("volume:1e-3").bound == Rational(1, 1000000));
}

TEST_CASE("requirements: what cannot be meant is refused, with what to do") {
  CHECK(mentions(fault_of("min-angle"), "unless it is quoted"));
  CHECK(mentions(fault_of("min-angle"), "takes >= "));
  CHECK(mentions(fault_of("max-angle"), "takes <= "));
  CHECK(mentions(fault_of("min-angel:20deg"), "min-angle, max-angle"));
  CHECK(mentions(fault_of(""), "min-angle:20.7deg"));
  CHECK(mentions(fault_of("min-angle <= 20deg"), "at least"));
  CHECK(mentions(fault_of("max-angle >= 20deg"), "at most"));
  CHECK(mentions(fault_of("edge > 3"), "expected 'edge <= …'"));
  CHECK(mentions(fault_of("min-angle:20"), "20.7deg"));
  CHECK(mentions(fault_of("min-angle:-1deg"), "20.7deg"));
  CHECK(mentions(fault_of("max-angle:180.1deg"), "at most 180deg"));
  CHECK(fault_of("max-angle:180deg").empty());
  CHECK(mentions(fault_of("edge:3deg"), "at least 0"));
  CHECK(mentions(fault_of("edge:-3"), "at least 0"));
  CHECK(mentions(fault_of("edge:sqrt(-3)"), "at least 0"));
  CHECK(mentions(fault_of("edge:"), "at least 0"));
}

TEST_CASE("requirements that contradict each other are refused, and those that nothing can keep") {
  const auto together = [](const char* a, const char* b) {
    return contradiction({required(a), required(b)});
  };
  CHECK(mentions(together("min-angle:50deg", "max-angle:49deg"), "contradict"));
  CHECK(mentions(together("max-dihedral:80deg", "min-dihedral:81deg"), "contradict"));
  CHECK(mentions(together("min-edge:2", "edge:1"), "contradict"));
  CHECK(together("min-edge:1", "edge:1").empty());
  CHECK(together("min-angle:30deg", "max-dihedral:20deg").empty());
  const auto of_dimension = [](const char* text, int dimension) {
    return fault_for_dimension({required(text)}, dimension);
  };
  CHECK(mentions(of_dimension("min-dihedral:20deg", 2), "measure of triangles (min-angle"));
  CHECK(mentions(of_dimension("area:2", 3), "measure of tetrahedra"));
  CHECK(mentions(of_dimension("min-angle:2deg", 1), "measure of edges (edge, min-edge)"));
  CHECK(mentions(of_dimension("edge:2", 4), "has none"));
  CHECK(of_dimension("edge:2", 3).empty());
  CHECK(of_dimension("min-angle:60deg", 2).empty());
  CHECK(mentions(of_dimension("min-angle:60.1deg", 2), "above 60deg"));
  CHECK(mentions(of_dimension("max-angle:59.9deg", 3), "below 60deg"));
  CHECK(of_dimension("min-dihedral:70.52deg", 3).empty());
  CHECK(mentions(of_dimension("min-dihedral:70.53deg", 3), "above 70.52"));
  CHECK(mentions(of_dimension("max-dihedral:70.52deg", 3), "below 70.52"));
  CHECK(of_dimension("radius-edge:sqrt(1/3)", 2).empty());
  CHECK(mentions(of_dimension("radius-edge:sqrt(1/3)", 3), "below 0.61237"));
  CHECK(mentions(of_dimension("aspect-ratio:1.15", 2), "below 1.1547"));
}

}  // namespace
}  // namespace circumspect
