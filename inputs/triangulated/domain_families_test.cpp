#include "inputs/triangulated/domain_families.hpp"

#include <doctest/doctest.h>

#include "inputs/in_doubles.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "reference/delaunay/simplex_predicates.hpp"

namespace circumspect::properties {
namespace {

TEST_CASE("families of domains: all of them, found by their names") {
  CHECK(domain_families().size() == generators::complex_families().size() + 4);
  for (const auto& family : domain_families()) {
    const generators::ComplexFamily* const found = find_domain_family(family.name);
    REQUIRE(found != nullptr);
    CHECK(found->name == family.name);
    CHECK(found == find_domain_family(family.name));
  }
  CHECK(find_domain_family("sphere") == nullptr);
}

TEST_CASE("protected families: valid also in doubles, and every segment is Delaunay") {
  for (const char* name : {"protected-polygons", "strongly-protected-polygons", "protected-solids",
                           "delaunay-polyhedra"}) {
    CAPTURE(name);
    const generators::ComplexFamily* family = find_domain_family(name);
    REQUIRE(family != nullptr);
    std::size_t segments = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      CAPTURE(seed);
      const auto made = generators::in_doubles(generators::drawn(*family, 9, seed));
      CHECK(validated(made.input, 1));
      const PiecewiseLinearComplex complex = made.complex();
      for (const Simplex& segment : complex.segments) {
        ++segments;
        CHECK(delaunay::is_delaunay(complex.points, segment));
      }
    }
    CHECK(segments > 20);
  }
}

}  // namespace
}  // namespace circumspect::properties
