// The meshes of the corpus as arrays: whatever the checkers say of the files, `judge` says of the arrays.
#include <circumspect/check.hpp>
#include <doctest/doctest.h>

#include "corpus/expected_table.hpp"
#include "oracle/judge/arrays/arrays_of_test.hpp"

namespace circumspect::corpus {

TEST_CASE("arrays are judged as files are, and by the fast judge wherever they hold") {
  std::size_t fast = 0, rejected = 0;
  for (const Row& row : expected_rows()) {
    const ExactMesh mesh = mesh_of(row);
    const auto arrays = arrays::arrays_of(mesh);
    if (!arrays) continue;
    INFO(row.text);
    const MeshJudgement judgement = judge(std::string(name(row.claim)), arrays->view());
    CHECK(arrays::difference_from_slow(row.claim, mesh, judgement) == "");
    const bool is_handled = arrays->dimension == 2 || arrays->dimension == 3;
    if (is_handled && judgement.holds) CHECK(judgement.counts.fast);
    fast += judgement.counts.fast ? 1 : 0;
    rejected += judgement.holds ? 0 : 1;
  }
  CHECK(fast > 100);
  CHECK(rejected > 100);
}

}  // namespace circumspect::corpus
