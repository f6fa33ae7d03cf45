#include <map>
#include <optional>
#include <set>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "properties/adapters/adapters.hpp"

namespace circumspect::adapters {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel>;
using Cell = std::array<std::int64_t, 4>;
using Triangle = std::array<std::int64_t, 3>;

constexpr std::int64_t kInfinite = -1;

// A facet of a cell: sorted, and with the sign of the orientation that the cell gives it.
struct Side {
  Triangle facet;
  bool positive;
};

Side side(const Cell& cell, std::size_t opposite) {
  Side result{{}, opposite % 2 == 0};
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i != opposite) result.facet[n++] = cell[i];
  }
  const auto order = [&](std::size_t a, std::size_t b) {
    if (result.facet[a] <= result.facet[b]) return;
    std::swap(result.facet[a], result.facet[b]);
    result.positive = !result.positive;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return result;
}

struct Use {
  std::size_t cell;
  std::size_t opposite;
};
using Uses = std::map<Triangle, std::vector<Use>>;

Uses uses_of(const std::vector<Cell>& cells) {
  Uses uses;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t i = 0; i < 4; ++i) uses[side(cells[c], i).facet].push_back({c, i});
  }
  return uses;
}

// One tetrahedron a row; nothing, if a row is none.
std::optional<std::vector<Cell>> cells_of(const PointArray& points, const SimplexArray& simplices) {
  std::vector<Cell> cells;
  for (const auto& row : simplices) {
    const std::set<std::int64_t> distinct(row.begin(), row.end());
    if (row.size() != 4 || distinct.size() != 4 || *distinct.begin() < 0) return std::nullopt;
    if (*distinct.rbegin() >= static_cast<std::int64_t>(points.size())) return std::nullopt;
    cells.push_back({row[0], row[1], row[2], row[3]});
  }
  return cells;
}

// An infinite cell goes behind each facet that one cell alone has. Is every facet shared by two
// then?
bool close(std::vector<Cell>& cells) {
  for (const auto& [facet, uses] : uses_of(cells)) {
    if (uses.size() == 1) cells.push_back({kInfinite, facet[0], facet[1], facet[2]});
  }
  for (const auto& [facet, uses] : uses_of(cells)) {
    if (uses.size() != 2) return false;
  }
  return true;
}

Kernel::Point_3 point(const PointArray& points, std::int64_t i) {
  const double* const p = points.point(static_cast<std::size_t>(i));
  return {p[0], p[1], p[2]};
}

void orient_positively(const PointArray& points, Cell& cell) {
  if (cell[0] == kInfinite) return;
  if (CGAL::orientation(point(points, cell[0]), point(points, cell[1]), point(points, cell[2]),
                        point(points, cell[3])) == CGAL::NEGATIVE) {
    std::swap(cell[0], cell[1]);
  }
}

// Gives neighbours the same orientation, that of the first cell of each component; false, if they
// have none in common.
bool orient(const PointArray& points, std::vector<Cell>& cells) {
  const Uses uses = uses_of(cells);
  std::vector<bool> done(cells.size());
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (done[first]) continue;
    orient_positively(points, cells[first]);
    done[first] = true;
    std::vector<std::size_t> pending = {first};
    while (!pending.empty()) {
      const std::size_t c = pending.back();
      pending.pop_back();
      for (std::size_t i = 0; i < 4; ++i) {
        const Side mine = side(cells[c], i);
        const std::vector<Use>& both = uses.at(mine.facet);
        const std::size_t other = both[0].cell == c ? both[1].cell : both[0].cell;
        std::size_t place = 0;
        while (side(cells[other], place).facet != mine.facet) ++place;
        const bool agree = side(cells[other], place).positive != mine.positive;
        if (done[other] && !agree) return false;
        if (done[other]) continue;
        if (!agree) std::swap(cells[other][0], cells[other][1]);
        done[other] = true;
        pending.push_back(other);
      }
    }
  }
  return true;
}

void fill(Delaunay& mesh, const PointArray& points, const std::vector<Cell>& cells) {
  auto& structure = mesh.tds();
  structure.clear();
  structure.set_dimension(3);
  std::map<std::int64_t, Delaunay::Vertex_handle> vertices;
  vertices[kInfinite] = structure.create_vertex();
  mesh.set_infinite_vertex(vertices[kInfinite]);
  std::vector<Delaunay::Cell_handle> made;
  for (const Cell& cell : cells) {
    std::array<Delaunay::Vertex_handle, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [entry, is_new] = vertices.try_emplace(cell[i]);
      if (is_new) {
        entry->second = structure.create_vertex();
        entry->second->set_point(point(points, cell[i]));
      }
      corners[i] = entry->second;
    }
    made.push_back(structure.create_cell(corners[0], corners[1], corners[2], corners[3]));
    for (const auto& corner : corners) corner->set_cell(made.back());
  }
  for (const auto& [facet, uses] : uses_of(cells)) {
    made[uses[0].cell]->set_neighbor(static_cast<int>(uses[0].opposite), made[uses[1].cell]);
    made[uses[1].cell]->set_neighbor(static_cast<int>(uses[1].opposite), made[uses[0].cell]);
  }
}

}  // namespace

Opinion cgal_is_valid_3(const PointArray& points, const SimplexArray& simplices) {
  auto cells = cells_of(points, simplices);
  if (!cells || cells->empty() || !close(*cells) || !orient(points, *cells)) {
    return Opinion::kNoDataStructure;
  }
  Delaunay mesh;
  fill(mesh, points, *cells);
  return mesh.is_valid() ? Opinion::kValid : Opinion::kInvalid;
}

}  // namespace circumspect::adapters
