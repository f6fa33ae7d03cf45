#include "oracle/judge/definition/complex.hpp"

#include <algorithm>
#include <set>
#include <span>

#include "kernel/complex/improper_intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"

namespace circumspect::definition {
namespace {

using Points = std::vector<Point>;

Points at(const ListedComplex& listed, const Simplex& simplex) {
  Points points;
  for (const Vertex v : simplex) points.push_back(listed.points[static_cast<std::size_t>(v)]);
  return points;
}

// For each point the first that equals it.
std::vector<Vertex> first_of_equals(const Points& points) {
  std::vector<Vertex> first;
  for (const Point& point : points) {
    first.push_back(std::find(points.begin(), points.end(), point) - points.begin());
  }
  return first;
}

std::vector<Simplex> with_face(const std::vector<Simplex>& simplices, const Simplex& face) {
  std::vector<Simplex> found = simplices;
  std::erase_if(found, [&](const Simplex& simplex) { return !has_face(simplex, face); });
  return found;
}

// Do the relative interiors of two faces meet in one point, and none of smaller faces? Then their
// points have one affine dependence, in which all of them are.
bool meet_in_one_point(const Points& a, const Points& b) {
  Points all = a;
  all.insert(all.end(), b.begin(), b.end());
  return affine_hull(all).dimension + 2 == static_cast<int>(all.size()) &&
         relative_interiors_meet(a, b);
}

// In how many parts are some simplices, if those with a common face of this size are connected?
std::size_t parts_connected_by(const std::vector<Simplex>& simplices, std::size_t face_size,
                               const Simplex& at = {}) {
  std::vector<std::size_t> part(simplices.size());
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = i;
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      for (std::size_t j = 0; j < simplices.size(); ++j) {
        const auto is_shared = [&](const Simplex& face) {
          return has_face(face, at) && has_face(simplices[j], face);
        };
        const std::vector<Simplex> faces = faces_of({simplices[i]}, face_size);
        if (part[j] <= part[i] || std::none_of(faces.begin(), faces.end(), is_shared)) continue;
        part[j] = part[i];
        changes = true;
      }
    }
  }
  return std::set<std::size_t>(part.begin(), part.end()).size();
}

}  // namespace

SetApart set_apart(const ListedComplex& listed, std::size_t size) {
  SetApart apart;
  const std::vector<Vertex> first = first_of_equals(listed.points);
  for (std::size_t v = 0; v < first.size(); ++v) {
    const auto again = static_cast<Vertex>(v);
    if (first[v] != again) apart.equal_points.push_back({first[v], again});
  }
  std::set<Vertex> used;
  for (std::size_t s = 0; s < listed.simplices.size(); ++s) {
    Simplex simplex = listed.simplices[s];
    bool names_points = true;
    for (Vertex& v : simplex) {
      const bool is_point = v >= 0 && v < static_cast<Vertex>(first.size());
      names_points &= is_point;
      if (!is_point) continue;
      used.insert(v);
      v = first[static_cast<std::size_t>(v)];
    }
    apart.merged.push_back(simplex);
    const auto is_same = [&](std::size_t other) {
      return sorted(apart.merged[other]) == sorted(simplex);
    };
    if (!names_points || simplex.size() != size || simplex.empty()) {
      apart.not_simplices.push_back(s);
    } else if (has_repeated_vertex(simplex)) {
      apart.repeating.push_back(s);
    } else if (affine_hull(at(listed, simplex)).dimension + 1 < static_cast<int>(size)) {
      apart.flat.push_back(s);
    } else if (std::any_of(apart.compared.begin(), apart.compared.end(), is_same)) {
      apart.doubled.push_back(s);
    } else {
      apart.compared.push_back(s);
    }
  }
  for (Vertex v = 0; v < static_cast<Vertex>(first.size()); ++v) {
    if (!used.contains(v)) apart.unused_points.push_back(v);
  }
  return apart;
}

ImproperPairs improper_pairs(const ListedComplex& listed, const SetApart& apart) {
  ImproperPairs pairs;
  std::set<HangingVertex> hanging;
  std::set<CrossingFaces> crossing;
  for (const std::size_t i : apart.compared) {
    for (const std::size_t j : apart.compared) {
      if (j <= i) continue;
      const Simplex a = sorted(apart.merged[i]), b = sorted(apart.merged[j]);
      if (!improper_intersection(at(listed, a), at(listed, b))) continue;
      if (relative_interiors_meet(at(listed, a), at(listed, b))) {
        pairs.overlaps.push_back({i, j});
        continue;
      }
      bool hangs = false;
      std::set<CrossingFaces> of_pair;
      for (const Simplex& f : faces(a)) {
        for (const Simplex& g : faces(b)) {
          const bool are_apart =
              std::none_of(f.begin(), f.end(), [&](Vertex v) { return contains(g, v); });
          if (!are_apart || !meet_in_one_point(at(listed, f), at(listed, g))) continue;
          if (f.size() == 1) hanging.insert({f.front(), g});
          if (g.size() == 1) hanging.insert({g.front(), f});
          hangs |= f.size() == 1 || g.size() == 1;
          if (f.size() > 1 && g.size() > 1) of_pair.insert({std::min(f, g), std::max(f, g)});
        }
      }
      if (!hangs) crossing.insert(of_pair.begin(), of_pair.end());
    }
  }
  const auto is_repetition = [&](const Simplex& f, const Simplex& g) {
    const auto have = [&](std::size_t i, std::size_t j) {
      return has_face(apart.merged[i], f) && has_face(apart.merged[j], g);
    };
    return std::any_of(apart.flat.begin(), apart.flat.end(),
                       [&](std::size_t s) { return have(s, s); }) ||
           std::any_of(pairs.overlaps.begin(), pairs.overlaps.end(), [&](const auto& pair) {
             return have(pair[0], pair[1]) || have(pair[1], pair[0]);
           });
  };
  for (const HangingVertex& one : hanging) {
    if (!is_repetition({one.vertex}, one.face)) pairs.hanging.push_back(one);
  }
  for (const CrossingFaces& one : crossing) {
    if (!is_repetition(one.first, one.second)) pairs.crossing.push_back(one);
  }
  return pairs;
}

std::vector<Simplex> open_facets(const std::vector<Simplex>& simplices) {
  std::vector<Simplex> open;
  if (simplices.empty()) return open;
  for (const Simplex& facet : faces_of(simplices, simplices.front().size() - 1)) {
    if (with_face(simplices, facet).size() == 1) open.push_back(facet);
  }
  return open;
}

std::size_t parts(const std::vector<Simplex>& simplices) {
  return simplices.empty() ? 0 : parts_connected_by(simplices, simplices.front().size() - 1);
}

NotManifold not_manifold(const std::vector<Simplex>& simplices) {
  NotManifold found;
  if (simplices.empty()) return found;
  const std::size_t size = simplices.front().size();
  const std::vector<Simplex> boundary = open_facets(simplices);
  const auto is_named = [](const std::vector<Simplex>& named, const Simplex& face) {
    return !with_face(named, face).empty();
  };
  for (const Simplex& facet : faces_of(simplices, size - 1)) {
    if (with_face(simplices, facet).size() > 2) found.facets.push_back(facet);
  }
  for (const Simplex& ridge : size > 2 ? faces_of(boundary, size - 2) : std::vector<Simplex>()) {
    if (is_named(found.facets, ridge) || with_face(boundary, ridge).size() == 2) continue;
    found.ridges.push_back(ridge);
  }
  for (const Simplex& vertex : faces_of(simplices, 1)) {
    if (is_named(found.facets, vertex) || is_named(found.ridges, vertex)) continue;
    const bool is_connected =
        size < 3 || parts_connected_by(with_face(simplices, vertex), size - 1, vertex) == 1;
    const bool has_one_circle =
        size < 4 || parts_connected_by(with_face(boundary, vertex), size - 2, vertex) <= 1;
    if (!is_connected || !has_one_circle) found.vertices.push_back(vertex.front());
  }
  return found;
}

std::vector<std::size_t> stray_faces(const ListedComplex& listed,
                                     const std::vector<Simplex>& faces) {
  const std::vector<Vertex> first = first_of_equals(listed.points);
  const auto names_point = [&](Vertex v) { return v >= 0 && v < std::ssize(first); };
  const auto merged = [&](std::vector<Simplex> simplices) {
    for (Simplex& simplex : simplices) {
      for (Vertex& v : simplex) v = names_point(v) ? first[static_cast<std::size_t>(v)] : v;
    }
    return simplices;
  };
  const std::vector<Simplex> simplices = merged(listed.simplices), own = merged(faces);
  std::vector<std::size_t> stray;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Simplex& face = own[i];
    const bool may_be_face = face.size() > 1 && !has_repeated_vertex(face) &&
                             std::all_of(face.begin(), face.end(), names_point);
    if (!may_be_face || with_face(simplices, face).empty()) stray.push_back(i);
  }
  return stray;
}

std::vector<int> orientation_signs(const std::vector<Point>& points,
                                   const std::vector<Simplex>& simplices) {
  const Configuration configuration(points);
  std::vector<int> signs;
  for (const Simplex& simplex : simplices) {
    const auto axes = std::span(kSpace).first(configuration.ambient_dimension());
    // det[p_0 − p_d; …; p_{d−1} − p_d] is this determinant in the plane, and minus it in space.
    const int of_last = orientation(configuration, axes, simplex);
    signs.push_back(axes.size() % 2 == 0 ? of_last : -of_last);
  }
  return signs;
}

std::vector<Simplex> inconsistent_facets(const std::vector<Simplex>& simplices) {
  // In which sense a simplex goes around a facet: that of its order without the vertex opposite.
  const auto sense = [](const Simplex& simplex, const Simplex& facet) {
    std::size_t place = 0;
    while (contains(facet, simplex[place])) ++place;
    return is_odd_permutation(facet_opposite(simplex, place)) != (place % 2 == 1);
  };
  std::vector<Simplex> found;
  if (simplices.empty() || simplices.front().size() < 2)
    return found;  // nothing goes around points
  for (const Simplex& facet : faces_of(simplices, simplices.front().size() - 1)) {
    const std::vector<Simplex> beside = with_face(simplices, facet);
    if (beside.size() == 2 && sense(beside[0], facet) == sense(beside[1], facet)) {
      found.push_back(facet);
    }
  }
  return found;
}

}  // namespace circumspect::definition
