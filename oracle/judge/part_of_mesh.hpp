// A part of a mesh in arrays, for the exact checkers to say what is wrong with it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/each_once.hpp"
#include "oracle/judge/definition/complex.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

// Some simplices of a mesh, with their vertices and some further points, all in their order. An
// index that names no point of the whole stays what it is, and names none of the part.
template <std::size_t kDimension, typename Index>
class Part {
 public:
  Part(const fast::MeshView<kDimension, Index>& whole, std::vector<std::size_t> simplices,
       const std::vector<std::size_t>& further_points)
      : whole_(whole), simplices_(std::move(simplices)), place_of_(whole.points(), kNone) {
    keep_each_once(simplices_);
    for (const std::size_t s : simplices_) {
      for (const Index v : whole_.row(s)) {
        if (whole_.names_point(v)) place_of_[static_cast<std::size_t>(v)] = 0;
      }
    }
    for (const std::size_t v : further_points) place_of_[v] = 0;
    for (std::size_t v = 0; v < place_of_.size(); ++v) {
      if (place_of_[v] == kNone) continue;
      place_of_[v] = static_cast<Vertex>(vertices_.size());
      vertices_.push_back(static_cast<Vertex>(v));
    }
  }

  ExactMesh mesh(bool weighted) const {
    std::vector<Rational> weights;
    for (const Vertex v : vertices_) {
      if (weighted) weights.push_back(exact_value(whole_.weights[static_cast<std::size_t>(v)]));
    }
    definition::ListedComplex all = listed();
    return {PointSet(std::move(all.points), std::move(weights)), std::move(all.simplices)};
  }

  // The same, of points that may be equal.
  definition::ListedComplex listed() const {
    definition::ListedComplex part;
    for (const Vertex v : vertices_) {
      Point& point = part.points.emplace_back();
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        const auto place = static_cast<std::size_t>(v) * kDimension + axis;
        point.push_back(exact_value(whole_.coordinates[place]));
      }
    }
    for (const std::size_t s : simplices_) {
      Simplex& simplex = part.simplices.emplace_back();
      for (const Index v : whole_.row(s)) simplex.push_back(place_of(v));
    }
    return part;
  }

  // Where in the whole they are, ascending.
  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<std::size_t>& simplices() const { return simplices_; }

  // As the part numbers points and simplices. Requires: it has the simplex.
  Vertex place_of(Vertex v) const {
    return whole_.names_point(static_cast<Index>(v)) ? place_of_[static_cast<std::size_t>(v)] : v;
  }
  std::size_t place_of_simplex(std::size_t s) const {
    return static_cast<std::size_t>(std::lower_bound(simplices_.begin(), simplices_.end(), s) -
                                    simplices_.begin());
  }
  FacetUse use_of(fast::FacetId facet) const {
    FacetUse use{{}, place_of_simplex(facet.simplex()), facet.place()};
    for (std::size_t i = 0; i <= kDimension; ++i) {
      if (i != facet.place()) use.facet.push_back(place_of(whole_.row(facet.simplex())[i]));
    }
    std::sort(use.facet.begin(), use.facet.end());
    return use;
  }

 private:
  static constexpr Vertex kNone = -1;

  const fast::MeshView<kDimension, Index>& whole_;
  std::vector<std::size_t> simplices_;
  std::vector<Vertex> vertices_;
  std::vector<Vertex> place_of_;  // of each point of the whole, in the part
};

}  // namespace circumspect::check
