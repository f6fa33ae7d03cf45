#include "oracle/judge/periodic/unfolded.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>

#include "kernel/complex/by_facet.hpp"
#include "kernel/exact/interruption.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "oracle/model/periodic_facets.hpp"

namespace circumspect::check {
namespace {

// Sums and differences of offsets do not overflow.
constexpr Vertex kLargestOffset = Vertex{1} << 32U;

std::string counted(std::size_t count, const char* one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

// The vectors as columns: a point is a combination of them.
RationalMatrix columns_of(const std::vector<Point>& lattice) {
  const std::size_t d = lattice.size();
  RationalMatrix rows(d, std::vector<Rational>(d));
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t axis = 0; axis < d; ++axis) rows[axis][i] = lattice[i][axis];
  }
  return rows;
}

std::string fault_of_lattice(const std::vector<Point>& lattice, std::size_t d) {
  const std::string expected = "expected a lattice of " + counted(d, "vector") + " that span" +
                               (d == 2 ? " the plane" : " space");
  const auto has_other_size = [d](const Point& vector) { return vector.size() != d; };
  if (lattice.size() != d || std::any_of(lattice.begin(), lattice.end(), has_other_size)) {
    std::size_t numbers = 0;
    for (const Point& vector : lattice) numbers += vector.size();
    return expected + ", " + std::to_string(d * d) + " numbers, found " + std::to_string(numbers);
  }
  if (!solve(columns_of(lattice), Point(d, 0))) {
    return expected +
           ", found vectors that are linearly dependent: give one for each direction in which the "
           "points repeat";
  }
  return "";
}

std::string fault_of_offsets(const IndexLists& cells, const std::vector<Simplex>& offsets,
                             std::size_t d) {
  if (offsets.size() != cells.size()) {
    return "expected the offsets of " + counted(cells.size(), "cell") + ", found those of " +
           std::to_string(offsets.size());
  }
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const std::size_t expected = cells[i].size() * d;
    if (offsets[i].size() != expected) {
      return "expected " + counted(expected, "integer") + " as the offsets of cell " +
             std::to_string(i) + ", " + std::to_string(d) + " for each corner, found " +
             std::to_string(offsets[i].size());
    }
    const auto is_large = [](Vertex x) { return x < -kLargestOffset || x > kLargestOffset; };
    const auto large = std::find_if(offsets[i].begin(), offsets[i].end(), is_large);
    if (large != offsets[i].end()) {
      return "expected offsets of at most 2^32, found " + std::to_string(*large) + " in cell " +
             std::to_string(i);
    }
  }
  return "";
}

// What is left of a point when whole vectors are taken away: the same for two points if and only if
// the lattice moves one to the other.
Point remainder(const Point& point, const RationalMatrix& columns) {
  Point parts = *solve(columns, point);
  for (Rational& part : parts) part -= rounded_down(part);
  return parts;
}

std::string fault_of_points(const Mesh& listed, const std::vector<Point>& lattice) {
  const RationalMatrix columns = columns_of(lattice);
  std::map<Point, Vertex> seen;
  for (Vertex v = 0; listed.names(v); ++v) {
    end_if_interrupted();
    const auto [known, is_new] = seen.emplace(remainder(listed.point(v), columns), v);
    if (is_new) continue;
    return "expected points of which the lattice moves none to another, found points " +
           std::to_string(listed.label(known->second)) + " and " + std::to_string(listed.label(v)) +
           ": list one of them, and give its corners their offsets";
  }
  return "";
}

// The points that the cells need, each once.
class Unfolding {
 public:
  Unfolding(const Mesh& listed, const std::vector<Point>& lattice)
      : points_(listed.exact_points()) {
    copies_.lattice = lattice;
    copies_.listed = points_.size();
    for (Vertex v = 0; listed.names(v); ++v) {
      labels_.push_back(listed.label(v));
      copies_.of.push_back(v);
      copies_.offsets.emplace_back(lattice.size(), 0);
      places_.emplace(MovedPoint{v, copies_.offsets.back()}, v);
    }
  }

  Vertex place(const MovedPoint& moved) {
    const auto next = static_cast<Vertex>(points_.size());
    const auto [known, is_new] = places_.emplace(moved, next);
    if (is_new) {
      const auto listed = static_cast<std::size_t>(moved.point);
      points_.push_back(points_[listed] + copies_.shift(moved.offset));
      labels_.push_back(labels_[listed]);
      copies_.of.push_back(moved.point);
      copies_.offsets.push_back(moved.offset);
    }
    return known->second;
  }

  Mesh with(std::vector<Simplex> simplices, Vertex first_index) && {
    Mesh mesh;
    mesh.coordinates = numbers_of(points_, copies_.lattice.size());
    mesh.simplices = IndexLists(std::move(simplices));
    mesh.labels = std::move(labels_);
    mesh.first_index = first_index;
    mesh.copies = std::move(copies_);
    return mesh;
  }

 private:
  std::vector<Point> points_;
  std::vector<Vertex> labels_;
  Copies copies_;
  std::map<MovedPoint, Vertex> places_;
};

std::vector<PeriodicCell> cells_of(const std::vector<Simplex>& simplices,
                                   const Periodic& periodic) {
  const auto d = static_cast<std::ptrdiff_t>(periodic.lattice.size());
  std::vector<PeriodicCell> cells(simplices.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    auto offset = periodic.offsets[i].begin();
    for (const Vertex v : simplices[i]) {
      cells[i].push_back({v, Simplex(offset, offset + d)});
      offset += d;
    }
  }
  return cells;
}

void add_what_is_across(const std::vector<PeriodicCell>& cells, Unfolding& unfolding) {
  for (const auto places : ByFacet(facet_places(cells))) {
    if (places.size() != 2) continue;
    for (const auto& [own, other] : {std::pair{0, 1}, std::pair{1, 0}}) {
      const FacetPlace& from = places[static_cast<std::size_t>(other)];
      const MovedPoint& apex = cells[from.cell][from.opposite];
      const Simplex way = difference(places[static_cast<std::size_t>(own)].moved, from.moved);
      unfolding.place({apex.point, sum(apex.offset, way)});
    }
  }
}

}  // namespace

std::string fault_of_periodic(const Mesh& listed, const Periodic& periodic) {
  const std::size_t d = listed.dimension();
  if (listed.points() == 0) return "expected points that a lattice repeats, found none";
  if (d != 2 && d != 3) {
    return "expected points in the plane or in space for the claim periodic-delaunay, found "
           "dimension " +
           std::to_string(d);
  }
  if (listed.simplices.empty()) {
    return "expected cells for the claim periodic-delaunay, found none";
  }
  for (const std::string& fault : {fault_of_lattice(periodic.lattice, d),
                                   fault_of_offsets(listed.simplices, periodic.offsets, d)}) {
    if (!fault.empty()) return fault;
  }
  return fault_of_points(listed, periodic.lattice);
}

Mesh unfolded(const Mesh& listed, const Periodic& periodic) {
  std::vector<Simplex> simplices = listed.simplices.lists();
  Unfolding unfolding(listed, periodic.lattice);
  const auto has_all = [&](const Simplex& simplex) {
    return std::all_of(simplex.begin(), simplex.end(), [&](Vertex v) { return listed.names(v); });
  };
  if (!std::all_of(simplices.begin(), simplices.end(), has_all)) {
    return std::move(unfolding).with(std::move(simplices), listed.first_index);
  }
  const std::size_t d = listed.dimension();
  for (std::size_t i = 0; i < d; ++i) {
    Simplex along(d, 0);
    along[i] = 1;
    unfolding.place({0, along});
  }
  const std::vector<PeriodicCell> cells = cells_of(simplices, periodic);
  bool are_simplices = true;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = 0; j < cells[i].size(); ++j) {
      simplices[i][j] = unfolding.place(cells[i][j]);
    }
    are_simplices =
        are_simplices && simplices[i].size() == d + 1 && !has_repeated_vertex(simplices[i]);
  }
  if (are_simplices) add_what_is_across(cells, unfolding);
  return std::move(unfolding).with(std::move(simplices), listed.first_index);
}

}  // namespace circumspect::check
