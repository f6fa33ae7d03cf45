// Judges the meshes of the corpus from the definitions, those with many simplices left out: the
// time grows with the square of their number. `make test`, which tries a third of all inputs, leaves out more.
#include <doctest/doctest.h>

#include "corpus/domain_table.hpp"
#include "corpus/expected_table.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::corpus {

std::size_t too_many_by_definition() { return properties::one_input_in() > 1 ? 50 : 100; }
// Of a domain, definitions look at visibility, too.
std::size_t too_many_in_domain() { return properties::one_input_in() > 1 ? 15 : 30; }

TEST_CASE("by definition, each mesh holds or fails as expected.tsv says") {
  std::size_t judged = 0;
  for (Row row : expected_rows()) {
    INFO(row.text);
    const ExactMesh mesh = mesh_of(row);
    if (mesh.simplices.size() > too_many_by_definition()) continue;
    row.options.by = check::By::kDefinition;
    CHECK(check::judge_points(row.claim, mesh, row.options).holds() == row.broken.empty());
    ++judged;
  }
  CHECK(judged > 250);
}

TEST_CASE("by definition, each small mesh of a domain holds or fails as its table says") {
  std::size_t judged = 0;
  for (DomainRow row : domain_rows()) {
    INFO(row.text);
    if (mesh_with_faces(kDomainFolder + row.mesh).simplices.size() > too_many_in_domain()) continue;
    row.options.by = check::By::kDefinition;
    CHECK(judge(row).holds() == row.broken.empty());
    ++judged;
  }
  CHECK(judged > 150);
}

}  // namespace circumspect::corpus
