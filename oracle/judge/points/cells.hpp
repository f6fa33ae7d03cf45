// The cells of meshes, and the comparison of two meshes.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

// The cells of a mesh, one after another in one piece of memory, and the cells that two meshes
// share: the comparison of meshes once their points are matched.
class CellList {
 public:
  std::size_t size() const { return ends_.size(); }
  std::span<const Vertex> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::span(vertices_).subspan(begin, ends_[i] - begin);
  }

  template <class Range>
  void add(const Range& cell) {
    vertices_.insert(vertices_.end(), cell.begin(), cell.end());
    ends_.push_back(vertices_.size());
  }
  void add_all(const CellList& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) add(cells[i]);
  }

 private:
  std::vector<std::size_t> ends_;
  std::vector<Vertex> vertices_;
};

// Calls `visit(cell)` for each cell of a mesh.
using EachCell = std::function<void(const std::function<void(std::span<const Vertex>)>& visit)>;

// Those of the faces that are faces of no cell: they are in the complex by themselves. A face that
// is listed twice, as from the two tetrahedra beside it, is one face. `points`: how many there are.
CellList dangling_faces(const std::vector<Simplex>& faces, const EachCell& each_cell,
                        std::size_t points);

// The places of the faces that are faces of no cell. A face of a cell has two different vertices or
// more, all of which name points, and the cell has them all.
std::vector<std::size_t> stray_faces(const std::vector<Simplex>& faces, const EachCell& each_cell,
                                     std::size_t points);

// The cells that one list has and the other lacks, each in its order.
struct CellDifference {
  std::vector<Simplex> only_in_a = {};
  std::vector<Simplex> only_in_b = {};
  std::vector<bool> b_has_too = {};  // for each of these: does the other list it, but less often?
  std::vector<bool> a_has_too = {};
};

// Compares cells as sets of vertices, each as often as it is listed. `place_in_b`: for each point
// of a the equal point of b, or −1. A cell with a vertex that names no point, or one that is not in
// b, matches nothing.
CellDifference difference_of_cells(const CellList& a, const CellList& b,
                                   const std::vector<Vertex>& place_in_b, std::size_t points_of_b);

// Are two meshes the same complex, up to the numbering of points and the order of everything?

// What one mesh has and the other lacks, by indices from 0 into that mesh. Points are matched by
// exact coordinates and, where either mesh has weights, by weight; simplices as sets of matched
// vertices, each as often as it is listed. A simplex with a vertex that names no point, or one that
// the other mesh lacks, matches nothing.
struct Difference {
  std::vector<Vertex> points_only_in_a = {};
  std::vector<Vertex> points_only_in_b = {};
  std::vector<Simplex> simplices_only_in_a = {};  // as that mesh lists them, in its order
  std::vector<Simplex> simplices_only_in_b = {};
  // For each of these: does the other mesh have it, but list it less often?
  std::vector<bool> b_has_too = {};
  std::vector<bool> a_has_too = {};

  void add(CellDifference cells) {
    simplices_only_in_a = std::move(cells.only_in_a);
    simplices_only_in_b = std::move(cells.only_in_b);
    b_has_too = std::move(cells.b_has_too);
    a_has_too = std::move(cells.a_has_too);
  }
  bool empty() const {
    return points_only_in_a.empty() && points_only_in_b.empty() && simplices_only_in_a.empty() &&
           simplices_only_in_b.empty();
  }
};

// The cells that are compared: the simplices, and the faces beside them that dangle.
CellList cells_of(const ExactMesh& mesh);

// Compares the simplices, and those faces listed beside them that dangle: the others add nothing.
Difference difference(const ExactMesh& a, const ExactMesh& b);

}  // namespace circumspect::check
