#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "oracle/picture/picture.hpp"

namespace circumspect::picture {
namespace {

using Place = std::vector<double>;

Place place(const Point& point) {
  Place rounded;
  for (const Rational& x : point) rounded.push_back(x.get_d());
  return rounded;
}

constexpr std::size_t kMostPlaces = 24;

// Where the witness is, besides at its vertices.
std::vector<Place> places_of(const Witness& witness, const Mesh& mesh, const Domain* domain) {
  std::vector<Place> found;
  if (witness.point) found.push_back(place(*witness.point));
  for (const Vertex v : witness.vertices) {
    if (mesh.names(v)) found.push_back(place(mesh.point(v)));
  }
  if (domain == nullptr) return found;
  const PointSet& points = domain->complex.points;
  if (witness.domain_cell) {
    const Point& first = points[witness.domain_cell->front()];
    const Point& last = points[witness.domain_cell->back()];
    for (long i = 1; i < 16; ++i) {
      found.push_back(place(first + Rational(i, 16) * (last - first)));
    }
  }
  if (witness.polygon) {
    for (const Simplex& triangle : domain->complex.polygons[*witness.polygon].triangles) {
      if (found.size() >= kMostPlaces) break;
      found.push_back(place(barycentre(points, triangle)));
    }
  }
  return found;
}

double coordinate(const Mesh& mesh, Vertex v, std::size_t axis) {
  const auto row = static_cast<std::size_t>(v);
  if (const auto* doubles = std::get_if<Rows<double>>(&mesh.coordinates)) {
    return doubles->row(row)[axis];
  }
  return std::get<Rows<Rational>>(mesh.coordinates).row(row)[axis].get_d();
}

// One violation, and the best that was found for it so far.
class Search {
 public:
  Search(const Witness& witness, const Mesh& mesh, const Domain* domain, std::size_t room)
      : places_(places_of(witness, mesh, domain)), room_(room) {
    for (const Simplex& simplex : witness.simplices) {
      own_.insert(sorted(simplex));
      vertices_.insert(simplex.begin(), simplex.end());
    }
    if (witness.face) vertices_.insert(witness.face->begin(), witness.face->end());
    vertices_.insert(witness.vertices.begin(), witness.vertices.end());
    if (witness.nearest) vertices_.insert(witness.nearest->vertex);
  }

  const std::set<Vertex>& vertices() const { return vertices_; }
  const std::vector<Place>& places() const { return places_; }

  void offer(const Simplex& simplex, std::size_t number) {
    std::size_t shared = 0;
    for (const Vertex v : simplex) shared += vertices_.count(v);
    if (own_.count(sorted(simplex)) > 0) return;
    ++offered_;
    best_.insert({simplex.size() - shared, number, simplex});
    if (best_.size() > room_) best_.erase(std::prev(best_.end()));
  }

  Surroundings found() const {
    Surroundings result;
    for (const auto& [strange, number, simplex] : best_) result.near.push_back(simplex);
    result.left_out = offered_ - best_.size();
    return result;
  }

 private:
  std::vector<Place> places_;
  std::size_t room_;
  std::set<Vertex> vertices_;
  std::set<Simplex> own_;
  std::set<std::tuple<std::size_t, std::size_t, Simplex>> best_;
  std::size_t offered_ = 0;
};

// Every simplex, and every face listed beside them, with a number.
template <class Visitor>
void for_each_cell(const Mesh& mesh, const Visitor& visitor) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < mesh.simplices.size(); ++i) visitor(mesh.simplices[i], number++);
  for (const Simplex& face : mesh.faces) visitor(face, number++);
}

// The places of all searches, by their first coordinate, and to which search each belongs.
class Places {
 public:
  explicit Places(const std::vector<Search>& searches) {
    for (std::size_t i = 0; i < searches.size(); ++i) {
      for (const Place& place : searches[i].places())
        by_first_.emplace(place.front(), Entry{place, i});
    }
  }

  // Calls `visitor` with the number of each search one of whose places the box of the simplex
  // holds.
  template <class Visitor>
  void in_box(const Mesh& mesh, const Simplex& simplex, const Visitor& visitor) const {
    if (by_first_.empty() || simplex.empty()) return;
    const auto range = [&](std::size_t axis) {
      std::pair<double, double> ends = {coordinate(mesh, simplex.front(), axis),
                                        coordinate(mesh, simplex.front(), axis)};
      for (const Vertex v : simplex) {
        ends.first = std::min(ends.first, coordinate(mesh, v, axis));
        ends.second = std::max(ends.second, coordinate(mesh, v, axis));
      }
      return ends;
    };
    const auto [low, high] = range(0);
    for (auto it = by_first_.lower_bound(low); it != by_first_.end() && it->first <= high; ++it) {
      bool inside = true;
      for (std::size_t axis = 1; axis < it->second.place.size() && inside; ++axis) {
        const auto [below, above] = range(axis);
        inside = below <= it->second.place[axis] && it->second.place[axis] <= above;
      }
      if (inside) visitor(it->second.search);
    }
  }

 private:
  struct Entry {
    Place place;
    std::size_t search;
  };
  std::multimap<double, Entry> by_first_;
};

}  // namespace

std::vector<Surroundings> surroundings(std::span<const Witness> witnesses, const Mesh& mesh,
                                       const Domain* domain, std::size_t room) {
  std::vector<Search> searches;
  std::unordered_map<Vertex, std::vector<std::size_t>> searches_of;
  for (const Witness& witness : witnesses) {
    searches.emplace_back(witness, mesh, domain, room);
    for (const Vertex v : searches.back().vertices()) {
      searches_of[v].push_back(searches.size() - 1);
    }
  }
  const Places places(searches);
  std::set<std::size_t> wanted;
  for_each_cell(mesh, [&](const Simplex& simplex, std::size_t number) {
    if (!std::all_of(simplex.begin(), simplex.end(), [&](Vertex v) { return mesh.names(v); })) {
      return;
    }
    wanted.clear();
    for (const Vertex v : simplex) {
      const auto found = searches_of.find(v);
      if (found != searches_of.end()) wanted.insert(found->second.begin(), found->second.end());
    }
    places.in_box(mesh, simplex, [&](std::size_t search) { wanted.insert(search); });
    for (const std::size_t search : wanted) searches[search].offer(simplex, number);
  });
  std::vector<Surroundings> found;
  for (const Search& search : searches) found.push_back(search.found());
  return found;
}

std::vector<Simplex> boundary(const Mesh& mesh, std::size_t at_once) {
  // A pass takes the facets whose least vertex falls to it. −1 stands for no vertex.
  using Facet = std::array<Vertex, 3>;
  const auto passes = static_cast<Vertex>(4 * mesh.simplices.size() / at_once + 1);
  std::vector<Simplex> found;
  for (Vertex pass = 0; pass < passes; ++pass) {
    std::vector<Facet> facets;
    for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
      const Simplex simplex = sorted(mesh.simplices[i]);
      if (simplex.size() < 2 || simplex.size() > 4 || has_repeated_vertex(simplex)) continue;
      if (!mesh.names(simplex.front()) || !mesh.names(simplex.back())) continue;
      for (std::size_t left_out = 0; left_out < simplex.size(); ++left_out) {
        Facet facet = {-1, -1, -1};
        std::size_t size = 0;
        for (std::size_t place = 0; place < simplex.size(); ++place) {
          if (place != left_out) facet[size++] = simplex[place];
        }
        if (facet[0] % passes == pass) facets.push_back(facet);
      }
    }
    std::sort(facets.begin(), facets.end());
    for (auto facet = facets.begin(); facet != facets.end();) {
      const auto next =
          std::find_if(facet, facets.end(), [&](const Facet& one) { return one != *facet; });
      if (next == facet + 1) {
        found.emplace_back(facet->begin(), std::find(facet->begin(), facet->end(), -1));
      }
      facet = next;
    }
  }
  return found;
}

}  // namespace circumspect::picture
