#include "oracle/judge/cause/uncut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "kernel/exact/each_once.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/exact/triple.hpp"

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

// Facets of vertices that some facets have, modulo two: one that is put in again goes.
class Chain {
 public:
  Chain(const Mesh& mesh, const std::vector<BareFacet>& bare)
      : of_(mesh.points(), 0), was_touched_(mesh.points(), false) {
    for (const BareFacet& one : bare) {
      for (const Vertex v : one.facet) ++of_[static_cast<std::size_t>(v)];
    }
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < of_.size(); ++v) {
      if (of_[v] == 0) continue;
      at_.emplace_back().reserve(of_[v]);
      places_.push_back(place_of(mesh, v));
      of_[v] = next++;
    }
    for (const BareFacet& one : bare) put(one.facet);
  }

  void put(const Simplex& facet) {
    for (const Vertex v : facet) was_touched_[static_cast<std::size_t>(v)] = true;
    if (const auto old = find(facet)) {
      for (const Vertex v : facet) std::erase(at(v), *old);
      facets_[*old] = kNone;
      return;
    }
    for (const Vertex v : facet) at(v).push_back(static_cast<std::uint32_t>(facets_.size()));
    facets_.push_back(corners_of(facet));
  }
  bool has(const Simplex& facet) const { return find(facet).has_value(); }

  // Those that have the face.
  std::vector<Simplex> with(const Simplex& face) const {
    std::vector<Simplex> found;
    for (const std::uint32_t f : at(face.front())) {
      Simplex facet = simplex_of(facets_[f]);
      if (has_face(facet, face)) found.push_back(std::move(facet));
    }
    return found;
  }

  // The facets at whose corners something was put in or has gone since the last time.
  std::vector<Simplex> taken_touched() {
    std::vector<Simplex> found;
    for (const Corners& facet : facets_) {
      if (std::any_of(facet.begin(), facet.end(), [this](Vertex v) {
            return v >= 0 && was_touched_[static_cast<std::size_t>(v)];
          })) {
        found.push_back(simplex_of(facet));
      }
    }
    was_touched_.assign(was_touched_.size(), false);
    return found;
  }

  // The vertices of facets at the corners of this one, but for its own and those to be left out.
  template <class LeavesOut>
  std::vector<Vertex> around(const Simplex& facet, const LeavesOut& leaves_out) const {
    std::vector<Vertex> found;
    for (const Vertex corner : facet) {
      for (const std::uint32_t f : at(corner)) {
        for (const Vertex v : facets_[f]) {
          if (v >= 0 && !contains(facet, v) && !leaves_out(v)) found.push_back(v);
        }
      }
    }
    keep_each_once(found);
    return found;
  }
  const Place& place(Vertex v) const { return places_[of_[static_cast<std::size_t>(v)]]; }
  bool is_beside_face(Vertex vertex, const Simplex& face) const {
    std::vector<Place> corners;
    for (const Vertex v : face) corners.push_back(place(v));
    return is_beside(place(vertex), corners);
  }

 private:
  // Ascending; in the plane the last is −1, and of a facet that has gone all are.
  using Corners = std::array<Vertex, 3>;
  static constexpr Corners kNone = {-1, -1, -1};

  static Corners corners_of(const Simplex& facet) {
    Corners corners = kNone;
    std::copy(facet.begin(), facet.end(), corners.begin());
    return corners;
  }
  static Simplex simplex_of(const Corners& corners) {
    return {corners.begin(), std::find(corners.begin(), corners.end(), -1)};
  }
  std::optional<std::uint32_t> find(const Simplex& facet) const {
    const Corners corners = corners_of(facet);
    for (const std::uint32_t f : at(facet.front())) {
      if (facets_[f] == corners) return f;
    }
    return std::nullopt;
  }

  static Place place_of(const Mesh& mesh, std::size_t v) {
    Place place = {};
    if (const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates)) {
      std::copy_n(doubles->row(v).begin(), mesh.dimension(), place.begin());
      return place;
    }
    const Point point = mesh.point(static_cast<Vertex>(v));
    for (std::size_t i = 0; i < point.size(); ++i) place[i] = point[i].get_d();
    return place;
  }
  std::vector<std::uint32_t>& at(Vertex v) { return at_[of_[static_cast<std::size_t>(v)]]; }
  const std::vector<std::uint32_t>& at(Vertex v) const {
    return at_[of_[static_cast<std::size_t>(v)]];
  }

  std::vector<std::uint32_t> of_;  // the number of each vertex in the two lists below
  std::vector<std::vector<std::uint32_t>> at_ = {};  // facets
  std::vector<Place> places_ = {};
  std::vector<bool> was_touched_;
  std::vector<Corners> facets_ = {};
};

// The edges first, then the facet itself.
std::vector<Simplex> faces_of(const Simplex& facet) {
  if (facet.size() == 2) return {facet};
  return {facet_opposite(facet, 0), facet_opposite(facet, 1), facet_opposite(facet, 2), facet};
}

// Is a point so far from a triangle's plane that it is beside no face of it? Not all that are too
// far count, only those for which that is sure, rounding included. This is one question instead of
// four.
class FarFromPlane {
 public:
  explicit FarFromPlane(const std::array<Place, 3>& corners) : origin_(corners[0]) {
    const Place a = between(corners[0], corners[1]), b = between(corners[0], corners[2]);
    const Place c = between(corners[1], corners[2]);
    normal_ = cross_product(a, b);
    const double longest = std::max({product(a, a), product(b, b), product(c, c)});
    error_ = 16 * std::numeric_limits<double>::epsilon() * longest;
    most_ = 2 * kNear * std::sqrt(longest) * (std::sqrt(product(normal_, normal_)) + error_);
  }

  bool operator()(const Place& point) const {
    const Place w = between(origin_, point);
    const double size = std::abs(w[0]) + std::abs(w[1]) + std::abs(w[2]);
    return std::abs(product(w, normal_)) > most_ + error_ * size;
  }

 private:
  Place origin_, normal_;
  double error_;  // of the normal
  double most_;
};

using Cut = std::pair<Vertex, Simplex>;

// The vertices around a facet that may be beside one of its faces.
std::vector<Vertex> near(const Chain& chain, const Simplex& facet) {
  if (facet.size() == 2) return chain.around(facet, [](Vertex) { return false; });
  const FarFromPlane is_far({chain.place(facet[0]), chain.place(facet[1]), chain.place(facet[2])});
  return chain.around(facet, [&](Vertex v) { return is_far(chain.place(v)); });
}

void add_cuts(const Chain& chain, const Simplex& facet, std::set<Cut>& found) {
  const std::vector<Vertex> vertices = near(chain, facet);
  if (vertices.empty()) return;
  const std::vector<Simplex> faces = faces_of(facet);
  for (const Vertex v : vertices) {
    const auto face = std::find_if(faces.begin(), faces.end(), [&](const Simplex& one) {
      return chain.is_beside_face(v, one);
    });
    if (face != faces.end()) found.emplace(v, *face);
  }
}

// Where nothing was touched, what is found has been cut before.
std::set<Cut> cuts_of(Chain& chain) {
  std::set<Cut> found;
  for (const Simplex& facet : chain.taken_touched()) add_cuts(chain, facet, found);
  return found;
}

// In which faces of the mesh the vertices lie that a facet was cut at.
using Carriers = std::map<Vertex, Simplex>;

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

std::vector<Uncut> uncut_faces(const Mesh& mesh, const std::vector<BareFacet>& bare) {
  if (bare.size() > kMostBare) return {};
  Chain chain(mesh, bare);
  std::map<Cut, std::vector<std::vector<Simplex>>> made;
  std::map<Simplex, Carriers> carriers;  // of the facets that cuts have made
  for (int round = 0; round < kMostRounds; ++round) {
    bool has_more = false;
    for (const Cut& cut : cuts_of(chain)) {
      for (const Simplex& facet : chain.with(cut.second)) {
        if (contains(facet, cut.first)) continue;
        Carriers own = carriers[facet];
        const Simplex face = whole(cut.second, own);
        own[cut.first] = face;
        chain.put(facet);
        const std::vector<Simplex> pieces = pieces_of(facet, cut);
        for (const Simplex& piece : pieces) {
          chain.put(piece);
          carriers[piece] = own;  // read only if it is there
        }
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
