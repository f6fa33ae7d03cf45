// What one rank has of a mesh: simplices with points that it numbers for itself, as the fast judge takes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "oracle/distributed/ranks.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::distributed {

// ---- Dealt ----

// What a rank is dealt. Points are in slices (PartOf); of simplices a rank may have any.
struct Dealt {
  std::uint64_t points = 0;     // of the whole mesh
  std::uint64_t simplices = 0;  // of the whole mesh
  std::size_t dimension = 0;
  Rows<double> coordinates = {};  // of its slice of points; finite, without −0
  Rows<double> weights = {};      // of its slice, or none
  IndexLists lists = {};          // its simplices, by the user's indices of points; in rows
  std::uint64_t first_simplex = 0;
  std::vector<std::uint64_t> places = {};  // in the whole list; empty: they follow each other
  Vertex first_index = 0;                  // the user's index of the first point
};

// ---- Local mesh ----

// A facet of a simplex of some rank: simplex · (d + 1) + place of the vertex opposite, as that rank counts.
struct FacetName {
  std::int32_t rank = -1;
  std::uint32_t facet = 0;

  friend auto operator<=>(const FacetName&, const FacetName&) = default;
};

// A point of the whole mesh.
template <std::size_t kDimension>
struct NumberedPoint {
  std::uint64_t index = 0;
  fast::Site<kDimension> site = {};
};

template <std::size_t kDimension>
class LocalMesh {
 public:
  static constexpr std::size_t kVertices = kDimension + 1;
  static constexpr std::size_t kMostSimplices = (std::size_t{1} << 29) - 1;

  // Asks the owners for the points that the simplices name; they learn which points are used. Called by all
  // ranks. Requires: at most kMostSimplices simplices; `dealt.lists` are rows of kVertices, or empty; weights at
  // all ranks or at none. Does not take weights if they do not count.
  LocalMesh(Ranks& ranks, Dealt dealt, bool weighted);

  // Simplices as the fast judge sees them. The order of points is that of the whole mesh; −1 stands for an index
  // that names no point there.
  fast::MeshView<kDimension, std::int32_t> view() const {
    return {coordinates_, weights_, simplices_};
  }
  std::size_t size() const { return simplices_.size() / kVertices; }
  bool names_points_alone() const { return unknown_.empty(); }
  bool is_weighted() const { return weighted_; }

  // As the whole mesh counts: a vertex of a simplex, whether it names a point or not; a vertex that is a local
  // number; a simplex.
  std::int64_t vertex(std::size_t s, std::size_t place) const;
  std::int64_t global(std::int32_t v) const {
    return static_cast<std::int64_t>(global_of_[static_cast<std::size_t>(v)]);
  }
  std::uint64_t place(std::size_t s) const {
    return dealt_.places.empty() ? dealt_.first_simplex + s : dealt_.places[s];
  }
  // Of a local number that is not −1; of all vertices of a simplex, if they name points.
  fast::Site<kDimension> site(std::int32_t v) const {
    return weighted_ ? view().template site<true>(v) : view().template site<false>(v);
  }
  fast::SiteRow<kDimension> sites(std::size_t s) const {
    fast::SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kVertices; ++i) row[i] = site(simplices_[s * kVertices + i]);
    return row;
  }

  // The points that the rank owns; those of them that no simplex of any rank names, ascending.
  std::size_t owned() const { return dealt_.coordinates.rows(); }
  NumberedPoint<kDimension> owned_point(std::size_t i) const;
  std::vector<std::size_t> unused() const;
  std::size_t owner_of(std::uint64_t point) const {
    return PartOf::with(point, dealt_.points, ranks_);
  }

  const Dealt& dealt() const { return dealt_; }

 private:
  void number_points(const IndexLists& lists);
  void fetch_points(Ranks& ranks);
  void append_owned(std::uint64_t point, std::vector<double>& numbers);

  Dealt dealt_;  // without the lists
  bool weighted_;
  std::size_t ranks_;
  Slice slice_;
  std::vector<std::uint64_t> global_of_;  // of each local point, ascending
  std::vector<double> coordinates_;
  std::vector<double> weights_;
  std::vector<std::int32_t> simplices_;
  std::vector<std::pair<std::size_t, std::int64_t>>
      unknown_;             // places in simplices_, and what they name
  std::vector<bool> used_;  // of the points of the slice
};

extern template class LocalMesh<2>;
extern template class LocalMesh<3>;

}  // namespace circumspect::distributed
