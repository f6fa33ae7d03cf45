// The meshes of domains/, judged with what the fast judge knows of their simplices and without: the same
// word for word.
#include <doctest/doctest.h>

#include "corpus/domain_table.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::corpus {

TEST_CASE("what is known of the simplices changes no word about a mesh of a domain") {
  std::size_t known = 0, wrong = 0;
  for (const DomainRow& row : domain_rows()) {
    INFO(row.text);
    const Mesh mesh = read_mesh_with_faces(kDomainFolder + row.mesh);
    const ExactMesh exact_mesh = exact(mesh);
    const Domain domain = domain_of(kDomainFolder + row.domain, row.kind);
    check::Options options = row.options;
    options.threads = 2;
    options.max_violations = 0;
    for (const bool oriented : {false, true}) {
      options.oriented = oriented;
      const Verdict slow = check::judge_domain(row.claim, exact_mesh, domain, options);
      const Verdict quick = check::judge(row.claim, mesh, &domain, options).value();
      CHECK(check::text_of(quick) == check::text_of(slow));
      CHECK(report::verdict_line(quick, mesh, row.mesh, &domain) ==
            report::verdict_line(slow, mesh, row.mesh, &domain));
      CHECK(report::explanation(quick, mesh, &domain) == report::explanation(slow, mesh, &domain));
    }
    if (!check::facts_of_simplices(row.claim, mesh, domain.complex.kind, row.options)) continue;
    ++known;
    wrong += row.broken.empty() ? 0 : 1;
  }
  CHECK(known > 100);
  CHECK(wrong > 20);
}

}  // namespace circumspect::corpus
