// The distances of the vertices of a mesh from the cells of a domain, and the cell that carries
// each vertex.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "oracle/judge/within/cells.hpp"
#include "oracle/judge/within/distance.hpp"
#include "oracle/judge/within/work.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

// The cell of lowest dimension that is within reach of a vertex; no cell: the vertex is free. If a
// second cell of the same dimension is within reach as well, the vertex has no carrier either, and
// the reach is ambiguous.
struct Carrier {
  std::optional<Cell> cell = {};
  std::optional<Cell> second = {};

  bool is(Cell c) const { return cell == c && !second; }
  bool is_one() const { return cell && !second; }
};

// Distances of a cell that has a vertex of the domain within the least reach (see Reaches) need not
// be exact: no reach that is asked about is smaller. Then it is that of the vertex, which is no
// less.
struct ToCell {
  Cell cell;
  std::shared_ptr<const Rational> distance;  // its square; cells at a vertex share it

  const Rational& squared() const { return *distance; }
};

// Two cells that do not meet, and how far they are apart.
struct ApartCells {
  Cell a;
  Cell b;
  Rational squared;
};

// Where the cells of a domain are.
class DomainPieces {
 public:
  // Both must outlive this. Where there is too much work, distances are left out.
  DomainPieces(const Cells& cells, Work& work);
  ~DomainPieces();

  // The square of a distance, and at least the distance as `Rounding` has it.
  struct Limit {
    Rational squared;
    double rounded;
  };
  Limit limit(const Rational& squared) const;

  // How points are rounded here, and those of the domain.
  const Rounding& rounding() const { return rounding_; }
  const std::vector<RoundedPoint>& rounded_points() const { return points_; }

  // A point, exactly and as `rounding` has it.
  struct At {
    const Point& exact;
    const RoundedPoint& rounded;
  };
  // The vertices up to a limit from a point, from near to far.
  std::vector<ToCell> vertices_near(const At& point, const Limit& limit) const;
  // Adds to these the other cells, those of lower dimension first, each dimension from near to far.
  // Requires: cells that do not meet are more than two limits apart.
  void add_cells_near(const At& point, const Limit& limit, const Rational& squared_least,
                      std::vector<ToCell>& found) const;
  // The two cells that do not meet and are least apart, if any are at most so far apart. One is a
  // vertex, or both are segments: two cells of higher dimension are nowhere nearer to each other
  // than such faces of them.
  std::optional<ApartCells> least_apart(const Rational& squared_limit, unsigned threads) const;

 private:
  class Pieces;
  struct Around;  // a point, and what is about it up to a limit
  void add_near(int dimension, const Around& around, std::vector<ToCell>& found) const;

  const Cells& cells_;
  Work& work_;
  Rounding rounding_;
  std::vector<RoundedPoint> points_;
  std::vector<Pieces> of_dimension_;
};

class Reaches {
 public:
  // All distances up to a limit. `rounded`: the points of the mesh; `used`: which of them are
  // vertices of it.
  Reaches(const ExactMesh& mesh, const std::vector<RoundedPoint>& rounded,
          const std::vector<bool>& used, const Cells& cells, const DomainPieces& pieces,
          const Rational& squared_limit, unsigned threads);

  Reaches(const Reaches&) = delete;
  Reaches& operator=(const Reaches&) = delete;

  struct ToVertex {
    const Rational* distance;  // its square, as `of` has it
    Vertex vertex;
    const Rational& squared() const { return *distance; }
  };

  // The square of the least reach that can do: each vertex of the domain carries one of the mesh.
  // Of smaller ones nothing may be asked.
  const Rational& squared_least() const { return squared_least_; }
  // The cells up to the limit from a vertex: see DomainPieces::add_cells_near.
  const std::vector<ToCell>& of(Vertex v) const { return of_[static_cast<std::size_t>(v)]; }
  // The vertices near a cell, from near to far.
  const std::vector<ToVertex>& near(Cell cell) const {
    return near_[static_cast<std::size_t>(cell.dimension)][cell.place];
  }

  Carrier carrier(Vertex v, const Rational& squared_reach) const;

 private:
  std::vector<std::vector<ToCell>> of_;
  std::vector<std::vector<ToVertex>> near_[3];
  Rational squared_least_ = 0;
};

}  // namespace circumspect::check
