#include "oracle/model/verdict.hpp"

#include <algorithm>

namespace circumspect {
namespace {

// An index that names no point of the part names none of the whole either.
void rename(const std::vector<Vertex>& places, Simplex& vertices) {
  for (Vertex& v : vertices) {
    if (v >= 0 && v < static_cast<Vertex>(places.size())) v = places[static_cast<std::size_t>(v)];
  }
}

Simplex named_by(const Witness& witness) {
  Simplex all = witness.vertices;
  for (const Simplex& simplex : witness.simplices) {
    all.insert(all.end(), simplex.begin(), simplex.end());
  }
  if (witness.face) all.insert(all.end(), witness.face->begin(), witness.face->end());
  return all;
}

}  // namespace

Verdict::Verdict(Claim claim, const ExactMesh& mesh, std::size_t max_violations)
    : points(mesh.points.size()),
      simplices(mesh.simplices.size()),
      dimension(mesh.points.dimension()),
      claim_(claim),
      max_violations_(max_violations) {}

void Verdict::add(Rule rule, const Witness& witness, const std::optional<Rational>& margin) {
  if (keeps_more()) violations_.push_back({rule, witness});
  count(rule, margin, named_by(witness));
}

void Verdict::name_in_whole(const std::vector<Vertex>& vertex_of,
                            const std::vector<std::size_t>& simplex_of) {
  for (Violation& violation : violations_) {
    Witness& witness = violation.witness;
    for (Simplex& simplex : witness.simplices) rename(vertex_of, simplex);
    for (std::size_t& place : witness.places) place = simplex_of[place];
    if (witness.face) rename(vertex_of, *witness.face);
    rename(vertex_of, witness.vertices);
    if (witness.nearest) {
      witness.nearest->vertex = vertex_of[static_cast<std::size_t>(witness.nearest->vertex)];
    }
  }
  for (auto& [rule, tally] : tallies_) {
    Simplex in_all(tally.in_all.begin(), tally.in_all.end());
    rename(vertex_of, in_all);
    tally.in_all = {in_all.begin(), in_all.end()};
  }
}

void Verdict::count(Rule rule, const std::optional<Rational>& margin, Simplex named) {
  Tally& tally = tallies_[rule];
  if (tally.count == 0) tally.in_all = {named.begin(), named.end()};
  std::erase_if(tally.in_all,
                [&](Vertex v) { return std::find(named.begin(), named.end(), v) == named.end(); });
  ++tally.count;
  if (!margin) return;
  if (!tally.worst_margin || *tally.worst_margin < *margin) tally.worst_margin = margin;
}

}  // namespace circumspect
