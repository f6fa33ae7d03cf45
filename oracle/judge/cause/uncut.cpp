#include "oracle/judge/cause/uncut.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "kernel/exact/point.hpp"
#include "oracle/judge/cause/bare_facets.hpp"

namespace circumspect::check {
namespace {

constexpr std::size_t kMostBare = 300'000;
// Several vertices may lie beside one edge: each round finds those next to an end.
constexpr int kMostRounds = 16;
// How near to the face, and how far from its boundary, in parts of its size. What is found is
// checked by the facets; this only parts it from holes that have the shape of a simplex.
constexpr double kNear = 1e-3;

using Place = std::array<double, 3>;

Place between(const Place& a, const Place& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
double product(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Is the point next to a segment or triangle, away from its boundary?
bool is_beside(const Place& point, const std::vector<Place>& corners) {
  const Place w = between(corners[0], point);
  const Place a = between(corners[0], corners[1]);
  const Place b = corners.size() == 3 ? between(corners[0], corners[2]) : Place{};
  const double aa = product(a, a), ab = product(a, b), bb = product(b, b);
  const double wa = product(w, a), wb = product(w, b);
  double s = wa / aa, t = 0;
  if (corners.size() == 3) {
    const double determinant = aa * bb - ab * ab;
    s = (bb * wa - ab * wb) / determinant;
    t = (aa * wb - ab * wa) / determinant;
    if (!(t > kNear)) return false;
  }
  if (!(s > kNear) || !(1 - s - t > kNear)) return false;
  Place off = w;
  for (std::size_t i = 0; i < off.size(); ++i) off[i] -= s * a[i] + t * b[i];
  return product(off, off) < kNear * kNear * std::max(aa, bb);
}

Rational squared_distance_to(const Mesh& mesh, Vertex vertex, const Simplex& face) {
  const Point p = mesh.point(vertex), a = mesh.point(face[0]), b = mesh.point(face[1]);
  if (face.size() == 2) return squared_distance_to_segment(p, a, b);
  const Point normal = cross_product(b - a, mesh.point(face[2]) - a);
  const Rational height = inner_product(p - a, normal);
  return height * height / squared_length(normal);
}

// In which faces of the mesh the vertices lie that a facet was cut at.
using Carriers = std::map<Vertex, Simplex>;

// Facets modulo two: one that is put in again goes.
class Chain {
 public:
  explicit Chain(const Mesh& mesh) : mesh_(mesh) {}

  void put(const Simplex& facet, const Carriers& carriers = {}) {
    const bool is_new = facets_.insert(facet).second;
    if (!is_new) facets_.erase(facet);
    if (is_new && !carriers.empty()) {
      carriers_[facet] = carriers;
    } else {
      carriers_.erase(facet);
    }
    for (const Vertex v : facet) {
      if (is_new) {
        at_[v].insert(facet);
      } else {
        at_[v].erase(facet);
      }
    }
  }
  bool has(const Simplex& facet) const { return facets_.contains(facet); }
  const std::set<Simplex>& facets() const { return facets_; }
  Carriers carriers(const Simplex& facet) const {
    const auto known = carriers_.find(facet);
    return known == carriers_.end() ? Carriers() : known->second;
  }

  // Those that have the face.
  std::vector<Simplex> with(const Simplex& face) {
    std::vector<Simplex> found;
    for (const Simplex& facet : at_[face.front()]) {
      if (has_face(facet, face)) found.push_back(facet);
    }
    return found;
  }
  // The vertices of facets at the corners of this one, but for its own.
  std::set<Vertex> around(const Simplex& facet) {
    std::set<Vertex> found;
    for (const Vertex v : facet) {
      for (const Simplex& other : at_[v]) found.insert(other.begin(), other.end());
    }
    for (const Vertex v : facet) found.erase(v);
    return found;
  }
  const Place& place(Vertex v) {
    const auto [known, is_new] = places_.emplace(v, Place{});
    if (is_new) {
      const Point point = mesh_.point(v);
      for (std::size_t i = 0; i < point.size(); ++i) known->second[i] = point[i].get_d();
    }
    return known->second;
  }
  bool is_beside_face(Vertex vertex, const Simplex& face) {
    std::vector<Place> corners;
    for (const Vertex v : face) corners.push_back(place(v));
    return is_beside(place(vertex), corners);
  }

 private:
  const Mesh& mesh_;
  std::set<Simplex> facets_ = {};
  std::map<Simplex, Carriers> carriers_ = {};
  std::map<Vertex, std::set<Simplex>> at_ = {};
  std::map<Vertex, Place> places_ = {};
};

// The edges first, then the facet itself.
std::vector<Simplex> faces_of(const Simplex& facet) {
  if (facet.size() == 2) return {facet};
  return {facet_opposite(facet, 0), facet_opposite(facet, 1), facet_opposite(facet, 2), facet};
}

using Cut = std::pair<Vertex, Simplex>;

std::set<Cut> cuts_of(Chain& chain) {
  std::set<Cut> found;
  for (const Simplex& facet : chain.facets()) {
    for (const Vertex v : chain.around(facet)) {
      for (const Simplex& face : faces_of(facet)) {
        if (!chain.is_beside_face(v, face)) continue;
        found.emplace(v, face);
        break;
      }
    }
  }
  return found;
}

// The face of the mesh that a face of a facet is part of.
Simplex whole(const Simplex& face, const Carriers& carriers) {
  std::set<Vertex> corners;
  for (const Vertex v : face) {
    const auto carrier = carriers.find(v);
    if (carrier == carriers.end()) {
      corners.insert(v);
    } else {
      corners.insert(carrier->second.begin(), carrier->second.end());
    }
  }
  return {corners.begin(), corners.end()};
}

// What a facet with the face becomes.
std::vector<Simplex> pieces_of(const Simplex& facet, const Cut& cut) {
  std::vector<Simplex> pieces;
  for (const Vertex v : cut.second) {
    Simplex piece = facet;
    *std::find(piece.begin(), piece.end(), v) = cut.first;
    pieces.push_back(sorted(std::move(piece)));
  }
  return pieces;
}

}  // namespace

std::vector<Uncut> uncut_faces(const Mesh& mesh) {
  const std::vector<BareFacet> bare = bare_facets(mesh);
  if (bare.size() > kMostBare) return {};
  Chain chain(mesh);
  for (const BareFacet& one : bare) chain.put(one.facet);
  std::map<Cut, std::vector<std::vector<Simplex>>> made;
  for (int round = 0; round < kMostRounds; ++round) {
    bool has_more = false;
    for (const Cut& cut : cuts_of(chain)) {
      for (const Simplex& facet : chain.with(cut.second)) {
        if (contains(facet, cut.first)) continue;
        Carriers carriers = chain.carriers(facet);
        const Simplex face = whole(cut.second, carriers);
        carriers[cut.first] = face;
        chain.put(facet);
        const std::vector<Simplex> pieces = pieces_of(facet, cut);
        for (const Simplex& piece : pieces) chain.put(piece, carriers);
        made[{cut.first, face}].push_back(pieces);
        has_more = true;
      }
    }
    if (!has_more) break;
  }
  std::vector<Uncut> found;
  for (const auto& [cut, facets] : made) {
    const bool is_matched = std::any_of(facets.begin(), facets.end(), [&](const auto& pieces) {
      return std::none_of(pieces.begin(), pieces.end(),
                          [&](const Simplex& piece) { return chain.has(piece); });
    });
    if (!is_matched) continue;
    found.push_back({cut.first, cut.second, squared_distance_to(mesh, cut.first, cut.second)});
  }
  return found;
}

}  // namespace circumspect::check
