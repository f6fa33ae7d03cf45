#include "oracle/judge/voronoi/judge_structure.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "kernel/exact/number_text.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"

namespace circumspect::check {
namespace {

using definition::VoronoiStructure;

// A listed or an exact vertex in the box.
struct Place {
  Point point;
  bool is_listed = false;
  std::size_t index = 0;  // among the listed vertices
};
// What was joined is named by the first of its places; all that is outside, and what is joined with
// it, is one end.
using End = std::size_t;
constexpr End kOutside = ~std::size_t{0};
using Ends = std::set<End>;
using Pair = std::array<Vertex, 2>;

// The least distance of a point from what is outside of the box, squared; nothing if it is outside.
std::optional<Rational> squared_depth(const JudgedBox& box, const Point& point) {
  Rational least = box.high[0] - box.low[0];
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    least = std::min<Rational>(least, point[axis] - box.low[axis]);
    least = std::min<Rational>(least, box.high[axis] - point[axis]);
  }
  if (sign(least) < 0) return std::nullopt;
  return Rational(least * least);
}

// The places within a distance of each other are joined, and whatever is joined with them.
class Parts {
 public:
  Parts(const VoronoiDiagram& diagram, const JudgedBox& box, const Rational& squared_distance,
        const VoronoiStructure& exact, bool tries_all)
      : of_listed_(diagram.vertices.size(), kOutside) {
    for (const auto& [centre, nearest] : exact.vertices) places_.push_back({centre});
    for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
      if (squared_depth(box, diagram.vertices[v]))
        places_.push_back({diagram.vertices[v], true, v});
    }
    std::stable_sort(places_.begin(), places_.end(),
                     [](const Place& a, const Place& b) { return a.point < b.point; });
    join(squared_distance, tries_all);
    std::set<End> outside;
    for (std::size_t p = 0; p < places_.size(); ++p) {
      if (*squared_depth(box, places_[p].point) <= squared_distance) outside.insert(part_[p]);
    }
    for (std::size_t p = 0; p < places_.size(); ++p) {
      if (outside.contains(part_[p])) part_[p] = kOutside;
      const Place& place = places_[p];
      if (place.is_listed) {
        of_listed_[place.index] = part_[p];
      } else {
        of_exact_[place.point] = part_[p];
      }
    }
  }

  const std::vector<Place>& places() const { return places_; }
  End part(std::size_t place) const { return part_[place]; }
  End of_exact(const Point& centre) const { return of_exact_.at(centre); }
  End of_listed(Vertex v) const { return of_listed_[static_cast<std::size_t>(v)]; }

 private:
  void join(const Rational& squared, bool tries_all) {
    DisjointSets joined(places_.size());
    for (std::size_t p = 0; p < places_.size(); ++p) {
      for (std::size_t q = p + 1; q < places_.size(); ++q) {
        const Rational along = places_[q].point[0] - places_[p].point[0];
        if (!tries_all && along * along > squared) break;
        if (squared_distance(places_[p].point, places_[q].point) <= squared) joined.unite(p, q);
      }
    }
    std::map<std::size_t, End> first;
    for (std::size_t p = 0; p < places_.size(); ++p) {
      part_.push_back(first.emplace(joined.find(p), p).first->second);
    }
  }

  std::vector<Place> places_ = {};
  std::vector<End> part_ = {};
  std::vector<End> of_listed_;
  std::map<Point, End> of_exact_ = {};
};

class StructureJudge {
 public:
  StructureJudge(const VoronoiDiagram& diagram, const VoronoiStructure& exact, const Parts& parts,
                 Verdict& verdict)
      : diagram_(diagram), exact_(exact), parts_(parts), verdict_(verdict) {}

  void count() {
    std::set<End> vertices;
    for (std::size_t p = 0; p < parts_.places().size(); ++p) vertices.insert(parts_.part(p));
    vertices.erase(kOutside);
    verdict_.voronoi->structure = StructureFacts{.vertices = vertices.size()};
    for (const auto& [pair, ridge] : exact_.ridges) {
      verdict_.voronoi->structure->ridges += ends_of(ridge).size() < 2 ? 0 : 1;
    }
  }

  // Has each part a vertex of either kind?
  bool judge_vertices() {
    std::map<End, std::array<bool, 2>> has;
    for (std::size_t p = 0; p < parts_.places().size(); ++p) {
      has[parts_.part(p)][parts_.places()[p].is_listed ? 1 : 0] = true;
    }
    has.erase(kOutside);
    bool are_all = true;
    for (const auto& [part, kinds] : has) {
      if (kinds[0] && kinds[1]) continue;
      are_all = false;
      add_unmatched(parts_.places()[part]);
    }
    return are_all;
  }

  void judge_ridges() {
    std::map<Pair, Ends> own;
    for (const auto& [pair, ridge] : exact_.ridges) own[pair] = ends_of(ridge);
    std::map<Pair, std::set<Ends>> listed;
    for (std::size_t r = 0; r < diagram_.ridges.size(); ++r) {
      listed[pair_of(r)].insert(ends_of(diagram_.ridges[r]));
    }
    const std::size_t fewest = diagram_.sites.ambient_dimension();  // of a ridge that is listed
    for (const auto& [pair, ends] : own) {
      if (ends.size() < fewest || listed.contains(pair)) continue;
      add(Rule::kRidgeMissing, pair, ends, {});
    }
    for (std::size_t r = 0; r < diagram_.ridges.size(); ++r) {
      const Ends ends = ends_of(diagram_.ridges[r]);
      const auto exact = own.find(pair_of(r));
      const Ends of_exact = exact == own.end() ? Ends() : exact->second;
      if (ends == of_exact) continue;
      const bool is_small = ends.size() < fewest && of_exact.size() < fewest;
      if (is_small && (ends.size() < 2 || are_corners_of_both(pair_of(r), ends))) continue;
      add(Rule::kRidgeDiffers, pair_of(r), of_exact, ends, r);
    }
  }

 private:
  Pair pair_of(std::size_t ridge) const {
    const auto& [a, b] = diagram_.neighbors[ridge];
    return {std::min(a, b), std::max(a, b)};
  }

  Ends ends_of(const definition::VoronoiRidge& ridge) const {
    Ends ends;
    for (const Point& end : ridge.ends) ends.insert(parts_.of_exact(end));
    if (ridge.leaves_box) ends.insert(kOutside);
    return ends;
  }
  Ends ends_of(const ListedCell& ridge) const {
    Ends ends;
    for (const Vertex v : ridge.corners) ends.insert(parts_.of_listed(v));
    if (ridge.is_unbounded) ends.insert(kOutside);
    return ends;
  }

  // Has the Voronoi cell of either site all these ends, but for what is outside?
  bool are_corners_of_both(const Pair& pair, const Ends& ends) {
    if (corners_.empty()) {
      for (const auto& [centre, nearest] : exact_.vertices) {
        for (const Vertex site : nearest) corners_.emplace(site, parts_.of_exact(centre));
      }
    }
    return std::all_of(ends.begin(), ends.end(), [&](End end) {
      return end == kOutside ||
             (corners_.contains({pair[0], end}) && corners_.contains({pair[1], end}));
    });
  }

  void add_unmatched(const Place& place) {
    Witness witness{.point = place.point};
    std::optional<Rational> nearest;
    for (const Place& other : parts_.places()) {
      if (other.is_listed == place.is_listed) continue;
      const Rational squared = squared_distance(place.point, other.point);
      if (!nearest || squared < *nearest) nearest = squared;
    }
    if (place.is_listed) {
      witness.values.push_back({"index among the finite vertices, from 0", place.index});
    } else {
      witness.vertices = exact_.vertices.at(place.point);
    }
    if (nearest) {
      witness.values.push_back({place.is_listed ? "squared distance of the nearest Voronoi vertex"
                                                : "squared distance of the nearest listed vertex",
                                *nearest});
      witness.rounded.push_back({"distance", square_root_to_decimal(*nearest)});
    }
    verdict_.add(Rule::kVertexUnmatched, witness);
  }

  void add(Rule rule, const Pair& pair, const Ends& exact, const Ends& listed,
           std::optional<std::size_t> index = {}) {
    Witness witness{.vertices = {pair[0], pair[1]}};
    if (index) witness.values.push_back({"index among the listed ridges, from 0", *index});
    witness.values.push_back({"different ends of the Voronoi ridge", exact.size()});
    if (index) witness.values.push_back({"different ends of the listed ridge", listed.size()});
    Ends of_one;
    std::set_symmetric_difference(exact.begin(), exact.end(), listed.begin(), listed.end(),
                                  std::inserter(of_one, of_one.end()));
    if (!of_one.empty() && *of_one.begin() != kOutside) {
      witness.point = parts_.places()[*of_one.begin()].point;
    }
    verdict_.add(rule, witness);
  }

  const VoronoiDiagram& diagram_;
  const VoronoiStructure& exact_;
  const Parts& parts_;
  Verdict& verdict_;
  std::set<std::pair<Vertex, End>> corners_ = {};
};

// True if every end of a ridge names a vertex.
bool name_vertices(const VoronoiDiagram& diagram, Verdict& verdict) {
  bool do_all = true;
  for (std::size_t r = 0; r < diagram.ridges.size(); ++r) {
    for (const Vertex v : diagram.ridges[r].corners) {
      if (v >= 0 && v < std::ssize(diagram.vertices)) continue;
      do_all = false;
      verdict.add(Rule::kVoronoiUnknownVertex,
                  {.vertices = {diagram.neighbors[r][0], diagram.neighbors[r][1]},
                   .values = {{"index among the finite vertices, from 0", v}}});
      break;
    }
  }
  return do_all;
}

}  // namespace

std::string fault_of_structure(const VoronoiDiagram& diagram) {
  const bool are_listed = diagram.ridges.size() == diagram.neighbors.size() &&
                          (!diagram.ridges.empty() || diagram.sites.size() < 2);
  if (are_listed) return "";
  return "expected ridges with their ends for --structure, found none: run qvoronoi with both o "
         "and Fv";
}

void judge_structure(const VoronoiDiagram& diagram, const JudgedBox& box,
                     const Rational& squared_distance, const VoronoiStructure& exact,
                     bool tries_all, Verdict& verdict) {
  if (!name_vertices(diagram, verdict)) return;
  const Parts parts(diagram, box, squared_distance, exact, tries_all);
  StructureJudge judge(diagram, exact, parts, verdict);
  judge.count();
  if (judge.judge_vertices()) judge.judge_ridges();
}

}  // namespace circumspect::check
