#include "oracle/report/wording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace circumspect::report {

std::string simplices_noun(int dimension) {
  switch (dimension) {
    case 0:
      return "vertices";
    case 1:
      return "edges";
    case 2:
      return "triangles";
    case 3:
      return "tetrahedra";
    default:
      return "simplices";
  }
}

std::string labels(const Mesh& mesh, const Simplex& simplex) {
  std::vector<Vertex> own;
  for (const Vertex v : simplex) own.push_back(mesh.label(v));
  return fmt::format("{}", fmt::join(own, " "));
}

std::string name(check::By by) { return by == check::By::kLemma ? "lemma" : "definition"; }

}  // namespace circumspect::report
