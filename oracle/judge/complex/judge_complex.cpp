#include "oracle/judge/complex/judge_complex.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

using definition::ListedComplex;

// Turns what was found into a verdict, whoever found it.
class Said {
 public:
  Said(const ListedComplex& listed, const Findings& found, Verdict& verdict)
      : listed_(listed), found_(found), verdict_(verdict) {}

  void each_simplex(std::size_t size) {
    const definition::SetApart& apart = found_.apart;
    for (const auto& [kept, again] : apart.equal_points) {
      verdict_.add(Rule::kPointsEqual, {.vertices = {kept, again}, .point = point(kept)});
    }
    for (const std::size_t s : apart.not_simplices) not_a_simplex(s, size);
    for (const std::size_t s : apart.repeating) {
      Witness witness = of_places({s});
      const Simplex ascending = sorted(apart.merged[s]);
      witness.vertices = {*std::adjacent_find(ascending.begin(), ascending.end())};
      verdict_.add(Rule::kRepeatedVertex, witness);
    }
    for (const std::size_t s : apart.flat) verdict_.add(Rule::kDegenerateSimplex, of_places({s}));
    std::map<Simplex, std::size_t> first;
    if (!apart.doubled.empty()) {
      for (const std::size_t s : apart.compared) first[sorted(apart.merged[s])] = s;
    }
    for (const std::size_t s : apart.doubled) {
      verdict_.add(Rule::kDuplicateSimplex, of_places({first.at(sorted(apart.merged[s])), s}));
    }
  }

  void vertex_set() {
    for (const Vertex v : found_.apart.unused_points) {
      verdict_.add(Rule::kUnusedPoint, {.vertices = {v}, .point = point(v)});
    }
  }

  void pairs(bool hanging_is_allowed) {
    for (const auto& [i, j] : found_.improper.overlaps) {
      if (!verdict_.keeps_more()) {
        Simplex both = listed_.simplices[i];
        both.insert(both.end(), listed_.simplices[j].begin(), listed_.simplices[j].end());
        verdict_.count(Rule::kOverlap, std::nullopt, std::move(both));
        continue;
      }
      Witness witness = of_places({i, j});
      witness.point = common_point(merged(i), merged(j));
      verdict_.add(Rule::kOverlap, witness);
    }
    for (const auto& [vertex, face] : found_.improper.hanging) {
      if (hanging_is_allowed) break;
      Witness witness = of_places({with(face), with({vertex})});
      witness.face = face;
      witness.vertices = {vertex};
      verdict_.add(Rule::kHangingVertex, witness);
    }
    for (const auto& [first, second] : found_.improper.crossing) {
      Witness witness = of_places({with(first), with(second)});
      witness.face = first;
      witness.vertices = second;
      witness.point = common_point(first, second);
      verdict_.add(Rule::kFacesCross, witness);
    }
  }

  void orientations(Orientations demanded) {
    if (demanded == Orientations::kAny) return;
    for (const Simplex& facet : found_.inconsistent) {
      Witness witness = of_places(all_with(facet));
      witness.face = facet;
      verdict_.add(Rule::kNotOriented, witness);
    }
    const int of_most = found_.positive >= found_.negative ? 1 : -1;
    const auto example = std::find(found_.signs.begin(), found_.signs.end(), of_most);
    for (std::size_t i = 0; i < found_.signs.size(); ++i) {
      const std::size_t s = found_.apart.compared[i];
      if (demanded != Orientations::kSame) {
        if (found_.signs[i] == (demanded == Orientations::kPositive ? 1 : -1)) continue;
        Witness witness = of_places({s});
        witness.values = {{"determinant of the edges from the first vertex", determinant_of(s)}};
        verdict_.add(Rule::kInverted, witness);
      } else if (found_.signs[i] != of_most) {
        const auto place = static_cast<std::size_t>(example - found_.signs.begin());
        Witness witness = of_places({found_.apart.compared[place], s});
        witness.values = {{"sign of most", of_most}, {"sign of the other", found_.signs[i]}};
        verdict_.add(Rule::kOrientation, witness);
      }
    }
  }

  // Do vertices hang, and has no part a simplex with such a vertex and one in which it hangs?
  bool only_parts_hang() {
    const auto parts_with = [&](const Simplex& face) {
      std::set<std::size_t> parts;
      for (const std::size_t s : all_with(face)) parts.insert(part_of(s));
      return parts;
    };
    for (const auto& [vertex, face] : found_.improper.hanging) {
      const std::set<std::size_t> of_face = parts_with(face);
      for (const std::size_t part : parts_with({vertex})) {
        if (of_face.contains(part)) return false;
      }
    }
    return !found_.improper.hanging.empty();
  }

  // Counts what overlaps of different parts.
  void overlaps_of_parts(ComplexFacts& facts) const {
    std::set<std::array<std::size_t, 2>> pairs;
    for (const auto& [i, j] : found_.improper.overlaps) {
      const std::size_t one = part_of(i), other = part_of(j);
      if (one == other) continue;
      ++facts.overlaps_of_parts;
      pairs.insert({std::min(one, other), std::max(one, other)});
    }
    facts.overlapping_parts = pairs.size();
  }

  void boundary(const ComplexDemands& demands) {
    if (demands.closed) {
      for (const Simplex& facet : found_.open_facets) add_face(Rule::kNotClosed, facet);
    }
    for (const Simplex& facet : found_.not_manifold.facets) add_face(Rule::kNotManifold, facet);
    for (const Simplex& ridge : found_.not_manifold.ridges) add_face(Rule::kNotManifold, ridge);
    for (const Vertex v : found_.not_manifold.vertices) add_face(Rule::kNotManifold, {v});
    if (!demands.connected || found_.parts < 2) return;
    Witness witness = of_places(in_two_parts());
    witness.values = {{"parts", found_.parts}};
    verdict_.add(Rule::kNotConnected, witness);
  }

 private:
  // Requires: the simplex is compared.
  std::size_t part_of(std::size_t s) const {
    const auto& compared = found_.apart.compared;
    const auto place = std::lower_bound(compared.begin(), compared.end(), s);
    return found_.part_of[static_cast<std::size_t>(place - compared.begin())];
  }
  const Point& point(Vertex v) const { return listed_.points[static_cast<std::size_t>(v)]; }
  const Simplex& merged(std::size_t s) const { return found_.apart.merged[s]; }

  Witness of_places(const std::vector<std::size_t>& places) const {
    Witness witness{.places = places};
    for (const std::size_t s : places) witness.simplices.push_back(listed_.simplices[s]);
    return witness;
  }

  void not_a_simplex(std::size_t s, std::size_t size) {
    Witness witness = of_places({s});
    const Simplex& simplex = listed_.simplices[s];
    const auto names_none = [&](Vertex v) { return v < 0 || v >= std::ssize(listed_.points); };
    const auto none = std::find_if(simplex.begin(), simplex.end(), names_none);
    if (none != simplex.end()) {
      witness.vertices = {*none};
      verdict_.add(Rule::kUnknownVertex, witness);
      return;
    }
    witness.values = {{"vertices", simplex.size()}, {"vertices expected", size}};
    verdict_.add(Rule::kWrongDimension, witness);
  }

  // The compared simplices with this face.
  std::vector<std::size_t> all_with(const Simplex& face) {
    if (at_vertex_.empty()) {
      for (const std::size_t s : found_.apart.compared) {
        for (const Vertex v : merged(s)) at_vertex_[v].push_back(s);
      }
    }
    std::vector<std::size_t> found;
    for (const std::size_t s : at_vertex_.at(face.front())) {
      if (has_face(merged(s), face)) found.push_back(s);
    }
    return found;
  }
  std::size_t with(const Simplex& face) { return all_with(face).front(); }

  void add_face(Rule rule, const Simplex& face) {
    if (!verdict_.keeps_more()) {
      verdict_.count(rule);
      return;
    }
    Witness witness;
    if (!face.empty()) witness = of_places(all_with(face));
    witness.face = face;
    verdict_.add(rule, witness);
  }

  // The first simplex, and the first that facets do not connect with it.
  std::vector<std::size_t> in_two_parts() const {
    std::size_t other = 0;
    while (found_.part_of[other] == found_.part_of[0]) ++other;
    return {found_.apart.compared[0], found_.apart.compared[other]};
  }

  // A point of both that is not in their common face.
  std::optional<Point> common_point(const Simplex& a, const Simplex& b) const {
    const auto corners = [&](const Simplex& simplex) {
      std::vector<Point> all;
      for (const Vertex v : simplex) all.push_back(point(v));
      return all;
    };
    return improper_intersection(corners(a), corners(b));
  }

  Rational determinant_of(std::size_t s) const {
    std::vector<Point> corners;
    for (const Vertex v : merged(s)) corners.push_back(point(v));
    const Configuration points(corners);
    std::vector<std::size_t> axes;
    for (std::size_t axis = 0; axis + 1 < corners.size(); ++axis) axes.push_back(axis);
    const Rational of_last = orientation_determinant(points, axes, first_subset(corners.size()));
    return axes.size() % 2 == 0 ? of_last : Rational(-of_last);
  }

  const ListedComplex& listed_;
  const Findings& found_;
  Verdict& verdict_;
  std::map<Vertex, std::vector<std::size_t>> at_vertex_;
};

// Each of the two edges that cross is in two facets, with a vertex of the other each, which are in
// one simplex only.
std::size_t crossed_quadrilaterals(const Findings& found) {
  std::size_t count = 0;
  const auto is_open = [&](Simplex edge, Vertex apex) {
    edge.push_back(apex);
    std::sort(edge.begin(), edge.end());
    return std::binary_search(found.open_facets.begin(), found.open_facets.end(), edge);
  };
  for (const auto& [first, second] : found.improper.crossing) {
    if (first.size() != 2 || second.size() != 2) continue;
    count += is_open(first, second[0]) && is_open(first, second[1]) && is_open(second, first[0]) &&
                     is_open(second, first[1])
                 ? 1
                 : 0;
  }
  return count;
}

ComplexFacts facts_of(const Findings& found, const ComplexDemands& demands, std::size_t size) {
  ComplexFacts facts;
  facts.dimension = static_cast<int>(size) - 1;
  facts.set_apart = found.apart.merged.size() - found.apart.compared.size();
  facts.is_complex = found.improper.overlaps.empty() && found.improper.crossing.empty() &&
                     (found.improper.hanging.empty() || demands.allow_hanging);
  facts.are_counts_cut = found.improper.is_cut;
  facts.parts = found.parts;
  facts.boundary_facets = found.boundary_facets;
  facts.hanging_vertices = found.improper.hanging.size();
  facts.positive = found.positive;
  facts.negative = found.negative;
  return facts;
}

}  // namespace

std::string fault_of_demands(const ComplexDemands& demands, std::size_t size,
                             std::size_t dimension) {
  if (size == 0) return "expected simplices, found none: a complex is made of some";
  const std::string found = ", found simplices of dimension " + std::to_string(size - 1);
  if (demands.manifold && size > 4) {
    return "expected simplices of dimension 3 at most for --manifold" + found;
  }
  const bool asks_sign =
      demands.oriented == Orientations::kPositive || demands.oriented == Orientations::kNegative;
  if (asks_sign && size != dimension + 1) {
    return "expected simplices of dimension " + std::to_string(dimension) +
           ", as the points have, where their sign is demanded" + found +
           "; --oriented=same asks whether they fit together";
  }
  if (demands.closed && size == dimension + 1) {
    return "expected simplices of a lower dimension than the points for --closed" + found +
           ": what they fill has a boundary";
  }
  return "";
}

std::string fault_of_demands(const Mesh& mesh, const ComplexDemands& demands) {
  std::size_t size = mesh.simplices.columns();
  for (std::size_t i = 0; size == 0 && i < mesh.simplices.size(); ++i) {
    size = std::max(size, mesh.simplices[i].size());
  }
  if (demands.faces && mesh.faces.empty()) {
    return "expected triangles or edges listed beside the simplices for --faces (those of an .ele "
           "file are in the .face and the .edge file), found none";
  }
  return fault_of_demands(demands, size, mesh.dimension());
}

void add_findings(const ListedComplex& listed, const Findings& found, const ComplexDemands& demands,
                  std::size_t size, Verdict& verdict) {
  Said said(listed, found, verdict);
  said.each_simplex(size);
  said.pairs(demands.allow_hanging);
  said.orientations(demands.oriented);
}

Verdict judge_complex(const ListedComplex& listed, const ComplexDemands& demands,
                      bool by_definition, std::size_t max_violations, const ImproperAmong& among) {
  return verdict_of_findings(listed,
                             by_definition ? findings_by_definition(listed, demands)
                                           : findings_by_lemma(listed, demands, among),
                             demands, max_violations);
}

Verdict verdict_of_findings(const ListedComplex& listed, const Findings& found,
                            const ComplexDemands& demands, std::size_t max_violations) {
  const std::size_t size = size_of_simplices(listed);
  Verdict verdict(Claim::kComplex, max_violations);
  verdict.points = listed.points.size();
  verdict.simplices = listed.simplices.size();
  verdict.dimension = affine_hull(listed.points).dimension;
  add_findings(listed, found, demands, size, verdict);
  Said said(listed, found, verdict);
  if (!demands.allow_unused) said.vertex_set();
  said.boundary(demands);
  verdict.complex = facts_of(found, demands, size);
  verdict.complex->crossed_quadrilaterals = crossed_quadrilaterals(found);
  verdict.complex->only_parts_hang = said.only_parts_hang();
  said.overlaps_of_parts(*verdict.complex);
  return verdict;
}

}  // namespace circumspect::check
