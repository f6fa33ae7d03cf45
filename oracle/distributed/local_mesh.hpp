// The part of a mesh that one rank has: simplices, and points with numbers of this rank, as the
// fast judge needs them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <memory_resource>
#include <span>
#include <utility>
#include <vector>

#include "oracle/distributed/ranks.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::distributed {

// Rows of indices: in memory, or in a file that is read in batches, each time they are asked for.
class ListedRows {
 public:
  // Writes the rows from `first` on into the span, as many as fit.
  using Read = std::function<void(std::uint64_t first, std::span<std::int64_t> rows)>;

  ListedRows() = default;
  ListedRows(std::uint64_t count, std::size_t columns, Read read)
      : count_(count), columns_(columns), read_(std::move(read)) {}
  template <class Index>
  ListedRows(Rows<Index> rows) : count_(rows.rows()), columns_(rows.columns()) {
    read_ = [own = std::make_shared<Rows<Index>>(std::move(rows)), columns = columns_](
                std::uint64_t first, std::span<std::int64_t> to) {
      const auto from = std::as_const(*own).values().subspan(first * columns, to.size());
      std::copy(from.begin(), from.end(), to.begin());
    };
  }

  std::uint64_t size() const { return count_; }
  std::size_t columns() const { return columns_; }
  void read(std::uint64_t first, std::span<std::int64_t> to) const { read_(first, to); }

  // Calls visit(number of the first row, values of all rows) for one batch of rows after the other.
  template <class Visit>
  void for_some(std::size_t some, const Visit& visit) const {
    std::vector<std::int64_t> values;
    for (std::uint64_t first = 0; first < count_; first += some) {
      values.resize(std::min<std::uint64_t>(some, count_ - first) * columns_);
      read_(first, values);
      visit(first, std::span<const std::int64_t>(values));
    }
  }

 private:
  std::uint64_t count_ = 0;
  std::size_t columns_ = 0;
  Read read_;
};

// The part of the input that a rank gets. Points are in slices (PartOf); a rank may get any
// simplices.
struct Dealt {
  std::uint64_t points = 0;     // of the whole mesh
  std::uint64_t simplices = 0;  // of the whole mesh
  std::size_t dimension = 0;
  std::pmr::vector<double> coordinates = {};  // of its slice of points; finite, without −0
  std::pmr::vector<double> weights = {};      // of its slice, or none
  ListedRows lists = {};                      // its simplices, by the user's indices of points
  std::uint64_t first_simplex = 0;
  std::pmr::vector<std::uint64_t> places = {};  // in the whole list; empty: they are consecutive
  Vertex first_index = 0;                       // the user's index of the first point
};

// A facet of a simplex of some rank: simplex · (d + 1) + place of the vertex opposite, as that rank
// counts.
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

class PointNumbers;

template <std::size_t kDimension>
class LocalMesh {
 public:
  static constexpr std::size_t kVertices = kDimension + 1;
  static constexpr std::size_t kMostSimplices = (std::size_t{1} << 29) - 1;

  // Asks the owners for the points that the simplices name; they learn which points are used. If
  // ranks name many points that others also name, the simplices are first redistributed, so that
  // each rank has those of one region of space and fewer of their facets have to meet those of
  // other ranks. Called by all ranks. Requires: at most kMostSimplices simplices; `dealt.lists` are
  // rows of kVertices, or empty; weights at all ranks or at none. Pass no weights if they do not
  // count.
  LocalMesh(Ranks& ranks, Dealt dealt, bool weighted);

  // Simplices as the fast judge sees them. The order of points is that of the whole mesh; −1 stands
  // for an index that names no point there.
  fast::MeshView<kDimension, std::int32_t> view() const {
    return {coordinates_, weights_, simplices_};
  }
  std::size_t size() const { return simplices_.size() / kVertices; }
  bool names_points_alone() const { return unknown_.empty(); }
  bool is_weighted() const { return weighted_; }

  // Numbers in the whole mesh: of a vertex of a simplex, whether it names a point or not; of a
  // vertex given by its local number; of a simplex.
  std::int64_t vertex(std::size_t s, std::size_t place) const;
  std::int64_t global(std::int32_t v) const {
    return static_cast<std::int64_t>(global_of_[static_cast<std::size_t>(v)]);
  }
  std::uint64_t place(std::size_t s) const {
    return dealt_.places.empty() ? dealt_.first_simplex + s : dealt_.places[s];
  }
  // Coordinates: of a local number that is not −1; of all vertices of a simplex, if they name
  // points.
  fast::Site<kDimension> site(std::int32_t v) const {
    return weighted_ ? view().template site<true>(v) : view().template site<false>(v);
  }
  fast::SiteRow<kDimension> sites(std::size_t s) const {
    fast::SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kVertices; ++i) row[i] = site(simplices_[s * kVertices + i]);
    return row;
  }

  // The points that this rank owns; those that no simplex of any rank names, ascending.
  std::size_t owned() const { return slice_.size(); }
  NumberedPoint<kDimension> owned_point(std::size_t i) const;
  std::vector<std::size_t> unused() const;
  std::size_t owner_of(std::uint64_t point) const {
    return PartOf::with(point, dealt_.points, ranks_);
  }

  const Dealt& dealt() const { return dealt_; }

 private:
  // Corners of a box around points.
  struct SiteBox {
    std::array<double, kDimension> low, high;
  };

  void number_points(const PointNumbers& numbers);
  // A simplex on its way to another rank, and its place along the curve: that of its first vertex,
  // then its number, mixed; no two are equal.
  struct Moved {
    std::array<std::int64_t, kVertices> row;
    std::uint64_t place;
  };
  struct CurvePlace {
    std::uint64_t of_vertex, of_simplex;
    auto operator<=>(const CurvePlace&) const = default;
  };
  void deal_by_place(Ranks& ranks);
  void append_moved(std::uint64_t first, std::size_t count, std::vector<Moved>& some) const;
  std::vector<CurvePlace> places_of(Ranks& ranks, const std::vector<Moved>& some,
                                    const SiteBox& box) const;
  std::vector<CurvePlace> beginnings(Ranks& ranks, const SiteBox& box) const;
  std::vector<std::uint64_t> curve_places(Ranks& ranks, std::span<const std::uint64_t> points,
                                          const SiteBox& box) const;
  SiteBox box_of_all(Ranks& ranks) const;
  void fetch_points(Ranks& ranks);
  void append_owned(std::uint64_t point, std::vector<double>& numbers);

  // The point that a user's index names, if any.
  bool names_point(std::int64_t place) const {
    return static_cast<std::uint64_t>(place) < dealt_.points;
  }
  std::int64_t place_of(std::int64_t listed) const {
    return place_of_index(listed, dealt_.first_index);
  }

  Dealt dealt_;  // without the lists
  bool weighted_;
  std::size_t ranks_;
  Slice slice_;
  std::pmr::vector<std::uint64_t> global_of_;  // of each local point, ascending
  std::pmr::vector<double> coordinates_;
  std::pmr::vector<double> weights_;
  std::pmr::vector<std::int32_t> simplices_;
  std::vector<std::pair<std::size_t, std::int64_t>>
      unknown_;             // places in simplices_, and what they name
  std::vector<bool> used_;  // of the points of the slice
};

extern template class LocalMesh<2>;
extern template class LocalMesh<3>;

}  // namespace circumspect::distributed
