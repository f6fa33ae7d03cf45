#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "oracle/judge/within/distance.hpp"
#include "oracle/judge/within/reach_search.hpp"

namespace circumspect::check {
namespace {

using Chain =
    std::map<std::pair<Vertex, Vertex>, int>;  // of directed edges, the lesser vertex first

void add_to(Chain& chain, Vertex from, Vertex to, int times) {
  chain[{std::min(from, to), std::max(from, to)}] += from < to ? times : -times;
}
Chain without_zeros(Chain chain) {
  std::erase_if(chain, [](const auto& term) { return term.second == 0; });
  return chain;
}

Point vector_product(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Twice the area of the projection on a plane with this normal, times the normal's length.
Rational area(const Point& normal, const std::vector<Point>& t) {
  return inner_product(normal, vector_product(t[1] - t[0], t[2] - t[0]));
}

// Do the projections on the plane have interior points in common? If so, and only then, there is no line
// between them, and one through an edge would do. Both counterclockwise.
bool project_on_each_other(const Point& normal, const std::vector<Point>& a,
                           const std::vector<Point>& b) {
  for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::size_t beyond = 0;
      for (const Point& p : *other) {
        beyond += sign(area(normal, {(*one)[i], (*one)[(i + 1) % 3], p})) <= 0 ? 1 : 0;
      }
      if (beyond == 3) return false;
    }
  }
  return true;
}

class Definition {
 public:
  Definition(const ExactMesh& mesh, const std::vector<bool>& used, const Cells& cells,
             const Regions& regions)
      : mesh_(mesh), used_(used), cells_(cells), complex_(cells.complex()), regions_(regions) {
    for (const std::vector<Simplex>* list : {&mesh.simplices, &mesh.faces}) {
      for (const Simplex& listed : *list) {
        const Simplex simplex = sorted(listed);
        for (const std::size_t size : {std::size_t{2}, std::size_t{3}}) {
          if (simplex.size() < size) continue;
          Simplex places = first_subset(size);
          do {
            Simplex face;
            for (const Vertex place : places) {
              face.push_back(simplex[static_cast<std::size_t>(place)]);
            }
            faces_.insert(face);
          } while (next_subset(places, simplex.size()));
        }
      }
    }
  }

  const Rational& distance(Vertex v, Cell cell) const {
    std::optional<Rational>& known = distances_[{v, cell}];
    if (!known) known = measured(v, cell);
    return *known;
  }
  Rational measured(Vertex v, Cell cell) const {
    std::optional<Rational> least;
    for (const Simplex& simplex : cells_.simplices(cell)) {
      const Rational found =
          squared_distance_to(coordinates(complex_.points, simplex), mesh_.points[v]);
      if (!least || found < *least) least = found;
    }
    return *least;
  }

  Carrier carrier(Vertex v, const Rational& squared) const {
    Carrier carrier;
    for (const Cell cell : cells_.all()) {
      if (carrier.cell && cell.dimension > carrier.cell->dimension) break;
      if (distance(v, cell) > squared) continue;
      if (!carrier.cell) {
        carrier.cell = cell;
      } else {
        carrier.second = cell;
      }
    }
    return carrier;
  }

  void set_reach(const Rational& squared) {
    squared_ = squared;
    carriers_.clear();
    for (Vertex v = 0; mesh_.points.names(v); ++v) {
      carriers_.push_back(used_[static_cast<std::size_t>(v)] ? carrier(v, squared) : Carrier{});
    }
  }
  const std::vector<Carrier>& carriers() const { return carriers_; }

  bool has_two_carriers() const {
    return std::any_of(carriers_.begin(), carriers_.end(),
                       [](const Carrier& carrier) { return carrier.second.has_value(); });
  }

  // Once it is so, it is so at all larger reaches.
  bool takes_cells_for_each_other() {
    std::set<Cell> vertices;
    for (const Carrier& carrier : carriers_) {
      if (!carrier.cell || carrier.cell->dimension > 0) continue;
      if (!vertices.insert(*carrier.cell).second) return true;
    }
    if (sign(squared_) == 0) return false;
    if (!is_apart_known_) measure_cells_apart();
    return apart_ && *apart_ <= 9 * squared_;
  }

  std::optional<ImageSet> images() {
    ImageSet set;
    for (std::size_t v = 0; v < complex_.points.size(); ++v) {
      const std::vector<Vertex> found = carried_by({0, v});
      if (found.size() != 1) {
        return none(Rule::kDomainVertexMissing, {.domain_cell = Simplex{static_cast<Vertex>(v)}});
      }
      set.vertices.push_back(found.front());
    }
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      auto path = path_of(s, set);
      if (!path) return none(Rule::kSegmentMissing, {.domain_cell = complex_.segments[s]});
      set.paths.push_back(std::move(*path));
    }
    for (std::size_t p = 0; p < complex_.polygons.size(); ++p) {
      auto patch = patch_of(p, set);
      if (!patch) return none(Rule::kPolygonNotTiled, {.polygon = p});
      set.patches.push_back(std::move(*patch));
    }
    if (!share_only_common_faces(set)) return none(Rule::kImagesMeet, {});
    if (misplaced(set, mesh_, cells_))
      return none(Rule::kImagesMeet, {});  // the order about segments
    return set;
  }
  // Why there were no images when they were last asked for.
  const std::optional<Violation>& breach() const { return breach_; }

  std::vector<Simplex> candidates(std::size_t p) const {
    std::vector<Simplex> found;
    for (const Simplex& face : faces_) {
      if (face.size() == 3 && std::all_of(face.begin(), face.end(), [&](Vertex v) {
            const Carrier& of_v = carriers_[static_cast<std::size_t>(v)];
            return of_v.is_one() && cells_.is_in_closure(*of_v.cell, {2, p});
          })) {
        found.push_back(face);
      }
    }
    return found;
  }

 private:
  // How far two cells that do not meet are apart, at least.
  void measure_cells_apart() {
    is_apart_known_ = true;
    const std::vector<Cell> all = cells_.all();
    for (const Cell a : all) {
      for (const Cell b : all) {
        if (!(a < b) || cells_.meet(a, b)) continue;
        for (const Simplex& s : cells_.simplices(a)) {
          for (const Simplex& t : cells_.simplices(b)) {
            const auto of_s = coordinates(complex_.points, s),
                       of_t = coordinates(complex_.points, t);
            const Rational squared = squared_distance_between(of_s, of_t);
            if (!apart_ || squared < *apart_) apart_ = squared;
          }
        }
      }
    }
  }

  std::nullopt_t none(Rule rule, const Witness& witness) {
    breach_ = Violation{rule, witness};
    return std::nullopt;
  }

  std::vector<Vertex> carried_by(Cell cell) const {
    std::vector<Vertex> found;
    for (Vertex v = 0; mesh_.points.names(v); ++v) {
      if (carriers_[static_cast<std::size_t>(v)].is(cell)) found.push_back(v);
    }
    return found;
  }

  std::optional<std::vector<Vertex>> path_of(std::size_t s, const ImageSet& set) const {
    const Simplex& ends = complex_.segments[s];
    const Point along = complex_.points[ends[1]] - complex_.points[ends[0]];
    const auto before = [&](Vertex a, Vertex b) {
      return inner_product(mesh_.points[a], along) < inner_product(mesh_.points[b], along);
    };
    std::vector<Vertex> path = carried_by({1, s});
    std::sort(path.begin(), path.end(), before);
    path.insert(path.begin(), set.vertices[static_cast<std::size_t>(ends[0])]);
    path.push_back(set.vertices[static_cast<std::size_t>(ends[1])]);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      if (!before(path[i], path[i + 1])) return std::nullopt;
      if (!faces_.contains(sorted({path[i], path[i + 1]}))) return std::nullopt;
    }
    return path;
  }

  // Those that the program lists with the marker of the polygon.
  std::vector<Simplex> named_triangles(std::size_t p) const {
    std::vector<Simplex> named = candidates(p);
    std::erase_if(named, [&](const Simplex& t) { return !cells_.is_marked(t, p); });
    return named;
  }

  // Those that are named, if they are an image. Of all sets of triangles that are images the one that leaves what is flat on the right side.
  std::optional<Patch> patch_of(std::size_t p, const ImageSet& set) const {
    const Polygon& polygon = complex_.polygons[p];
    const Point normal = normal_of(complex_, p);
    const auto upwards = [&](const PointSet& points, Simplex t) {
      if (sign(area(normal, coordinates(points, t))) < 0) std::swap(t[1], t[2]);
      return t;
    };
    std::vector<Simplex> own;
    for (const Simplex& t : polygon.triangles) own.push_back(upwards(complex_.points, t));
    std::vector<Simplex> all;
    for (const Simplex& t : candidates(p)) {
      if (sign(area(normal, coordinates(mesh_.points, t))) != 0) {
        all.push_back(upwards(mesh_.points, t));
      }
    }
    const Chain boundary = boundary_of(p, own, set);
    if (const auto named = named_triangles(p); !named.empty()) {
      std::vector<Simplex> some;
      for (const Simplex& t : named) some.push_back(upwards(mesh_.points, t));
      const bool is_flat = std::any_of(some.begin(), some.end(), [&](const Simplex& t) {
        return sign(area(normal, coordinates(mesh_.points, t))) == 0;
      });
      if (!is_flat && is_image(p, normal, some, boundary, set)) {
        return Patch{some, std::vector<Simplex>(some.size(), own.front())};
      }
    }
    const OrientedFacet down = OrientedFacet::of(own.front());
    const bool below = regions_.where(regions_.in_front_of(down)) == Where::kInside;
    const bool above = regions_.where(regions_.in_front_of(down.reverse())) == Where::kInside;
    const bool wants_lowest = above || !below;
    std::optional<Rational> best;
    std::vector<Simplex> chosen;
    for (std::size_t bits = 0; bits < (std::size_t{1} << all.size()); ++bits) {
      std::vector<Simplex> some;
      for (std::size_t i = 0; i < all.size(); ++i) {
        if ((bits >> i) % 2 == 1) some.push_back(all[i]);
      }
      if (!is_image(p, normal, some, boundary, set)) continue;
      Rational volume = 0;
      for (const Simplex& t : some) {
        const auto corners = coordinates(mesh_.points, t);
        volume += area(normal, corners) * inner_product(normal, barycentre(corners));
      }
      if (!wants_lowest) volume = -volume;
      if (best && *best <= volume) continue;
      best = volume;
      chosen = some;
    }
    if (!best) return std::nullopt;
    return Patch{chosen, std::vector<Simplex>(chosen.size(), own.front())};
  }

  Chain boundary_of(std::size_t p, const std::vector<Simplex>& own, const ImageSet& set) const {
    Chain of_domain;
    for (const Simplex& t : own) {
      for (std::size_t i = 0; i < 3; ++i) add_to(of_domain, t[i], t[(i + 1) % 3], 1);
    }
    Chain boundary;
    for (const std::size_t s : cells_.segments_of(p)) {
      const Simplex& ends = complex_.segments[s];
      const auto times = of_domain.find({ends[0], ends[1]});
      if (times == of_domain.end()) continue;
      const std::vector<Vertex>& path = set.paths[s];
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        add_to(boundary, path[i], path[i + 1], times->second);
      }
    }
    return without_zeros(boundary);
  }

  bool is_image(std::size_t p, const Point& normal, const std::vector<Simplex>& some,
                const Chain& boundary, const ImageSet& set) const {
    Chain found;
    std::set<Simplex> edges;
    std::set<Vertex> vertices;
    for (const Simplex& t : some) {
      for (std::size_t i = 0; i < 3; ++i) {
        add_to(found, t[i], t[(i + 1) % 3], 1);
        edges.insert(sorted({t[i], t[(i + 1) % 3]}));
        vertices.insert(t[i]);
      }
    }
    if (without_zeros(found) != boundary) return false;
    for (const std::size_t s : cells_.segments_of(p)) {
      const std::vector<Vertex>& path = set.paths[s];
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (!edges.contains(sorted({path[i], path[i + 1]}))) return false;
      }
    }
    for (const Vertex v : complex_.polygons[p].vertices) {
      if (!vertices.contains(set.vertices[static_cast<std::size_t>(v)])) return false;
    }
    for (const Vertex v : carried_by({2, p})) {
      if (!vertices.contains(v)) return false;
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      for (std::size_t j = i + 1; j < some.size(); ++j) {
        if (project_on_each_other(normal, coordinates(mesh_.points, some[i]),
                                  coordinates(mesh_.points, some[j]))) {
          return false;
        }
      }
    }
    return true;
  }

  std::set<Simplex> simplices_of(Cell cell, const ImageSet& set) const {
    if (cell.dimension == 0) return {{set.vertices[cell.place]}};
    std::set<Simplex> found;
    const auto add = [&](const Simplex& simplex) {
      for (const Vertex v : simplex) found.insert({v});
      found.insert(sorted(simplex));
    };
    if (cell.dimension == 1) {
      const std::vector<Vertex>& path = set.paths[cell.place];
      for (std::size_t i = 0; i + 1 < path.size(); ++i) add({path[i], path[i + 1]});
      return found;
    }
    for (const Simplex& t : set.patches[cell.place].triangles) {
      add(t);
      for (std::size_t i = 0; i < 3; ++i) add(facet_opposite(t, i));
    }
    return found;
  }

  bool share_only_common_faces(const ImageSet& set) const {
    const std::vector<Cell> all = cells_.all();
    std::map<Cell, std::set<Simplex>> image;
    for (const Cell cell : all) image[cell] = simplices_of(cell, set);
    for (const Cell a : all) {
      for (const Cell b : all) {
        if (!(a < b)) continue;
        for (const Simplex& simplex : image[a]) {
          if (!image[b].contains(simplex)) continue;
          const bool is_in_common_face = std::any_of(all.begin(), all.end(), [&](const Cell& c) {
            return cells_.is_in_closure(c, a) && cells_.is_in_closure(c, b) &&
                   image[c].contains(simplex);
          });
          if (!is_in_common_face) return false;
        }
      }
    }
    return true;
  }

  const ExactMesh& mesh_;
  const std::vector<bool>& used_;
  const Cells& cells_;
  const PiecewiseLinearComplex& complex_;
  const Regions& regions_;
  std::set<Simplex> faces_;  // edges and triangles
  mutable std::map<std::pair<Vertex, Cell>, std::optional<Rational>> distances_;
  bool is_apart_known_ = false;
  std::optional<Rational> apart_;
  Rational squared_ = 0;
  std::vector<Carrier> carriers_;
  std::optional<Violation> breach_;
};

}  // namespace

ReachAnswer least_reach_by_definition(const ExactMesh& mesh, const std::vector<bool>& used,
                                      const Cells& cells, const Regions& regions,
                                      const Rational& squared_limit) {
  Definition definition(mesh, used, cells, regions);
  std::set<Rational> candidates = {0, squared_limit};
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (!used[static_cast<std::size_t>(v)]) continue;
    for (const Cell cell : cells.all()) {
      const Rational squared = definition.distance(v, cell);
      if (squared <= squared_limit) candidates.insert(squared);
    }
  }
  bool passed_over = false;
  for (const Rational& squared : candidates) {
    definition.set_reach(squared);
    if (definition.takes_cells_for_each_other()) {
      passed_over = true;
      break;
    }
    auto images = definition.images();
    if (images && definition.has_two_carriers()) {
      passed_over = true;
    } else if (images) {
      return {.kind = ReachAnswer::Kind::kFound,
              .squared_reach = squared,
              .images = std::move(*images),
              .carriers = definition.carriers(),
              .moved = std::vector<bool>(mesh.points.size(), true)};
    }
  }
  if (passed_over) {
    return {.kind = ReachAnswer::Kind::kAmbiguous, .squared_reach = squared_limit};
  }
  return {.kind = ReachAnswer::Kind::kNone,
          .squared_reach = squared_limit,
          .breaches = {*definition.breach()}};
}

bool is_small_enough_for_definition(const ExactMesh& mesh, const std::vector<bool>& used,
                                    const Cells& cells, const Rational& squared_limit,
                                    std::size_t most) {
  const Regions regions(cells.complex());
  Definition definition(mesh, used, cells, regions);
  definition.set_reach(squared_limit);
  for (std::size_t p = 0; p < cells.complex().polygons.size(); ++p) {
    if (definition.candidates(p).size() > most) return false;
  }
  return true;
}

}  // namespace circumspect::check
