#include "oracle/judge/stray_faces.hpp"

#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "oracle/judge/definition/complex.hpp"
#include "oracle/judge/points/cells.hpp"

namespace circumspect::check {
namespace {

// For each point the one that counts: the first of those that are equal.
std::vector<Vertex> first_equals(const Mesh& mesh, const Verdict& verdict) {
  std::vector<Vertex> first(mesh.points());
  std::iota(first.begin(), first.end(), Vertex{0});
  if (!verdict.tallies().contains(Rule::kPointsEqual)) return first;
  for (const auto& [kept, again] : equal_points(mesh))
    first[static_cast<std::size_t>(again)] = kept;
  return first;
}

Simplex renamed(const Mesh& mesh, const std::vector<Vertex>& first, Simplex simplex) {
  for (Vertex& v : simplex) {
    if (mesh.names(v)) v = first[static_cast<std::size_t>(v)];
  }
  return simplex;
}

std::vector<std::size_t> stray_by_lemma(const Mesh& mesh, const Verdict& verdict) {
  const std::vector<Vertex> first = first_equals(mesh, verdict);
  std::vector<Simplex> faces;
  faces.reserve(mesh.faces.size());
  for (const Simplex& face : mesh.faces) faces.push_back(renamed(mesh, first, face));
  const auto each_simplex = [&](const auto& visit) {
    for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
      visit(renamed(mesh, first, mesh.simplices[s]));
    }
  };
  return stray_faces(faces, each_simplex, mesh.points());
}

// "edges": what a listed face of so many vertices is one of.
std::string noun(std::size_t size) {
  if (size == 2) return "edges";
  return size == 3 ? "triangles" : "faces of " + std::to_string(size) + " vertices";
}

}  // namespace

void judge_listed_faces(const Mesh& mesh, By by, Verdict& verdict) {
  const std::vector<std::size_t> stray =
      by == By::kDefinition
          ? definition::stray_faces({mesh.exact_points(), mesh.simplices.lists()}, mesh.faces)
          : stray_by_lemma(mesh, verdict);
  std::map<std::size_t, Vertex> index;  // of the next face of so many vertices
  auto next = stray.begin();
  for (std::size_t i = 0; i < mesh.faces.size() && next != stray.end(); ++i) {
    const Simplex& face = mesh.faces[i];
    const Vertex own = mesh.first_index + index[face.size()]++;
    if (i != *next) continue;
    ++next;
    if (!verdict.keeps_more()) {
      verdict.count(Rule::kStrayFace, std::nullopt, face);
      continue;
    }
    verdict.add(Rule::kStrayFace,
                {.face = face, .values = {{"index among the listed " + noun(face.size()), own}}});
  }
  verdict.complex->listed_faces = mesh.faces.size();
}

bool are_faces_if_shifted(const Mesh& mesh, Vertex shift) {
  std::vector<Simplex> faces = mesh.faces;
  for (Simplex& face : faces) {
    for (Vertex& v : face) {
      if (__builtin_add_overflow(v, shift, &v)) return false;
    }
  }
  const auto each_simplex = [&mesh](const auto& visit) {
    for (std::size_t s = 0; s < mesh.simplices.size(); ++s) visit(mesh.simplices[s]);
  };
  return stray_faces(faces, each_simplex, mesh.points()).empty();
}

}  // namespace circumspect::check
