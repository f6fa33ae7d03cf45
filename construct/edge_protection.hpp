// Is a piecewise linear complex edge-protected? As reference/constrained/edge_protection.hpp
// answers, by way of the fast construction. Book: Section 4.5.3.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "construct/delaunay.hpp"
#include "kernel/exact/progress.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/model/mesh.hpp"
#include "reference/constrained/edge_protection.hpp"

namespace circumspect::construct {

// How a segment lies in the canonical Delaunay triangulation of the vertices.
struct SegmentFacts {
  Simplex segment;
  bool is_present = false;  // is it an edge of that triangulation?
  delaunay::Delaunayhood delaunayhood = delaunay::Delaunayhood::kNotDelaunay;
  std::optional<Vertex> encroaching = {};  // as constrained::encroaching_vertex names it

  bool is_strong() const { return delaunayhood == delaunay::Delaunayhood::kStronglyDelaunay; }
};

class EdgeProtection {
 public:
  // Constructs the triangulation. The complex, which is valid, outlives it.
  explicit EdgeProtection(const PiecewiseLinearComplex& complex, const Progress& progress = {});

  // Is every segment an edge of the canonical Delaunay triangulation? Then, in space, the complex
  // has a canonical CDT (Theorem 4.9 of the perturbed vertices).
  bool holds_under_perturbation() const;

  // Of each segment, in the order given. Most are decided by their star alone: an edge of a
  // Delaunay triangulation none of whose facets at the edge has a tie is strongly Delaunay.
  std::vector<SegmentFacts> segments(const Progress& progress = {}) const;

 private:
  bool has_edge(const Simplex& segment) const;
  StarIndex stars_at(const std::vector<bool>& at) const;
  SegmentFacts facts_of(const StarIndex& stars, const Simplex& segment) const;
  bool has_no_ties(const std::vector<Simplex>& star) const;
  // Of a simplex of the triangulation: is the vertex on its circumsphere?
  bool is_on_sphere(const Simplex& simplex, Vertex v) const;

  const PiecewiseLinearComplex& complex_;
  // Doubles only if fast predicates may be asked about the points.
  Numbers coordinates_ = Rows<Rational>();
  std::vector<Simplex> simplices_;
  bool is_unique_ = false;            // false also if that is not known
  std::vector<std::uint64_t> edges_;  // both ends in one number, ascending
};

}  // namespace circumspect::construct
