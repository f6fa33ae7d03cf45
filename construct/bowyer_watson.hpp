// Incremental insertion with ghost simplices on flat arrays, with filtered predicates. Book:
// Section 5.2; point location by walking, Section 5.5; the canonical perturbation, Section 5.6.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "oracle/judge/fast/predicates/predicates.hpp"

namespace circumspect::construct {

// A vertex of the triangulation: a place among its sites.
using Place = std::int32_t;
inline constexpr Place kGhost = -1;

// What is across a facet: a cell, and the place in it of the vertex opposite the shared facet.
class Across {
 public:
  constexpr Across() = default;
  constexpr Across(std::size_t cell, std::size_t place)
      : bits_(static_cast<std::uint32_t>(cell << 2 | place)) {}

  constexpr std::size_t cell() const { return bits_ >> 2; }
  constexpr std::size_t place() const { return bits_ & 3; }
  constexpr bool is_known() const { return bits_ != kUnknown; }

 private:
  static constexpr std::uint32_t kUnknown = ~std::uint32_t{0};
  std::uint32_t bits_ = kUnknown;
};

// The canonical Delaunay triangulation of the sites inserted so far, the weighted one if kWeighted.
// Cells are solid simplices and ghosts, all positively oriented: a ghost is, if a point beyond its
// facet takes the ghost vertex's place.
template <std::size_t kDimension, bool kWeighted>
class BowyerWatson {
 public:
  static constexpr std::size_t kVertices = kDimension + 1;
  using Site = fast::Site<kDimension>;
  struct Cell {
    std::array<Place, kVertices> vertices;
    std::array<Across, kVertices> across = {};  // the facet opposite each vertex
  };

  // Starts with the first kVertices sites. Requires: finite, different points; these first ones are
  // affinely independent; `lattice` contains all sites (fast/predicates/lattice.hpp).
  BowyerWatson(std::vector<Site> sites, fast::Lattice lattice);

  // Inserts a site, unless it is submerged; whatever it submerges vanishes. False if there is no
  // room for more cells. Requires: kVertices <= site, and not inserted before.
  bool insert(Place site);

  // The vertices of each solid cell, positively oriented, one cell after the other.
  std::vector<Place> solid_cells() const;

 private:
  static constexpr std::size_t kMostCells = (std::size_t{1} << 30) - 1;

  std::array<const Site*, kVertices> sites_of(const Cell& cell, std::size_t replaced,
                                              const Site& site) const;
  int orientation_with(const Cell& cell, std::size_t replaced, const Site& site);
  bool is_in_conflict(std::size_t cell, const Site& site);
  bool is_solid_in_conflict(const Cell& cell, const Site& site);
  std::size_t cell_towards(const Site& site);
  void dig_cavity(std::size_t first, Place inserted);
  bool fill_cavity(Place inserted);
  Across turned(Across facet, std::size_t place) const;
  bool is_in_cavity(std::size_t cell) const { return looked_at_[cell] == in_cavity_; }

  std::vector<Site> sites_;
  fast::Lattice lattice_;
  fast::Stages stages_;
  std::vector<Cell> cells_;
  std::vector<std::size_t> free_;         // places of cells that are no more
  std::vector<std::uint32_t> looked_at_;  // for each cell: when, and was it in conflict?
  std::uint32_t in_cavity_ = 0;           // what says that now
  std::size_t recent_ = 0;                // a solid cell, created last
  std::vector<std::size_t> cavity_;       // the cells in conflict with the site
  std::vector<Across> boundary_;          // their facets to other cells, as seen from inside
};

extern template class BowyerWatson<2, false>;
extern template class BowyerWatson<2, true>;
extern template class BowyerWatson<3, false>;
extern template class BowyerWatson<3, true>;

// Which sites can start: kVertices affinely independent ones, the first such. None if all lie in a
// flat. Requires: finite, different points.
template <std::size_t kDimension>
std::optional<std::array<std::size_t, kDimension + 1>> first_independent(
    const std::vector<fast::Site<kDimension>>& sites);

extern template std::optional<std::array<std::size_t, 3>> first_independent<2>(
    const std::vector<fast::Site<2>>&);
extern template std::optional<std::array<std::size_t, 4>> first_independent<3>(
    const std::vector<fast::Site<3>>&);

}  // namespace circumspect::construct
