#include "oracle/report/wording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace circumspect::report {

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
  if (count == 1) return fmt::format("1 {}", one);
  return several.empty() ? fmt::format("{} {}s", count, one) : fmt::format("{} {}", count, several);
}

std::string simplices_noun(int dimension, std::size_t count) {
  const bool one = count == 1;
  switch (dimension) {
    case 0:
      return one ? "vertex" : "vertices";
    case 1:
      return one ? "edge" : "edges";
    case 2:
      return one ? "triangle" : "triangles";
    case 3:
      return one ? "tetrahedron" : "tetrahedra";
    default:
      return one ? "simplex" : "simplices";
  }
}

std::string joined(const Simplex& indices) { return fmt::format("{}", fmt::join(indices, " ")); }
std::string counted_simplices(std::size_t count, int dimension) {
  return fmt::format("{} {}", count, simplices_noun(dimension, count));
}

NamedCells named_cells(const Witness& witness, const Mesh& mesh) {
  NamedCells named;
  std::map<Vertex, Vertex> in_face;  // the index of each vertex, by the first simplex that has it
  for (std::size_t i = 0; i < witness.simplices.size(); ++i) {
    const Simplex& simplex = witness.simplices[i];
    const bool has_place = i < witness.places.size();
    named.simplices.push_back(
        mesh.listed(simplex, has_place ? std::optional(witness.places[i]) : std::nullopt));
    for (std::size_t j = 0; j < simplex.size(); ++j) {
      const Vertex own = named.simplices.back()[j];
      in_face.emplace(simplex[j], own);
      if (own != mesh.label(simplex[j])) named.merged.emplace(own, mesh.label(simplex[j]));
    }
  }
  if (!witness.face) return named;
  named.face = mesh.listed(*witness.face);
  for (std::size_t i = 0; i < named.face->size(); ++i) {
    const Vertex v = (*witness.face)[i];
    const auto found = in_face.find(v);
    Vertex& own = (*named.face)[i];
    if (found != in_face.end()) own = found->second;
    if (own != mesh.label(v)) named.merged.emplace(own, mesh.label(v));
  }
  return named;
}

std::string name(check::By by) { return by == check::By::kLemma ? "lemma" : "definition"; }

// ---- Rounded up ----

std::string square_root_rounded_up(const Rational& squared) {
  if (sign(squared) == 0) return "0";
  int exponent = 0;
  Rational power = 1;  // of ten, squared
  for (; power > squared; power /= 100) --exponent;
  for (; Rational(100 * power) <= squared; power *= 100) ++exponent;
  long digits = 10;
  while (Rational(digits * digits) * power < 100 * squared) ++digits;
  if (digits == 100) {
    digits = 10;
    ++exponent;
  }
  return fmt::format("{}.{}e{:+03d}", digits / 10, digits % 10, exponent);
}

}  // namespace circumspect::report
