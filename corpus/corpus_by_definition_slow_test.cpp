// Judges the meshes of the corpus from the definitions, those with many simplices left out: the
// time grows with the square of their number.
#include <doctest/doctest.h>

#include "corpus/expected_table.hpp"

namespace circumspect::corpus {

constexpr std::size_t kTooManyByDefinition = 150;

TEST_CASE("by definition, each mesh holds or fails as expected.tsv says") {
  std::size_t judged = 0;
  for (Row row : expected_rows()) {
    INFO(row.text);
    const ExactMesh mesh = mesh_of(row);
    if (mesh.simplices.size() > kTooManyByDefinition) continue;
    row.options.by = check::By::kDefinition;
    CHECK(check::judge_points(row.claim, mesh, row.options).holds() == row.broken.empty());
    ++judged;
  }
  CHECK(judged > 250);
}

}  // namespace circumspect::corpus
