#include "oracle/certificate/periodic_certificate.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "kernel/complex/by_facet.hpp"
#include "kernel/exact/triple.hpp"
#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/evidence.hpp"

namespace circumspect::certificate {
namespace {

// circumspect-verified tries all moves along two or three vectors.
constexpr int kMostReached = 64;

class PeriodicWriter {
 public:
  PeriodicWriter(const ExactMesh& mesh, const Copies& copies, ScaledPoints points)
      : mesh_(mesh), copies_(copies), d_(points.dimension) {
    made_.points = std::move(points);
    made_.listed = copies.listed;
  }

  // False if the mesh has an index that names no point, or cells that are no simplices.
  bool has_cells() {
    for (const Simplex& simplex : mesh_.simplices) {
      if (simplex.size() != d_ + 1) return false;
      PeriodicCell cell;
      for (const Vertex v : simplex) {
        if (!mesh_.points.names(v)) return false;
        cell.push_back(moved(v));
      }
      made_.cells.push_back(std::move(cell));
    }
    add_lattice();
    return true;
  }

  tl::expected<PeriodicDocument, std::string> certificate() {
    made_.sample = barycentre(made_.points, mesh_.simplices.front());
    made_.homes.resize(copies_.listed);
    made_.links.assign(made_.cells.size(), std::vector<PeriodicDocument::Link>(d_ + 1));
    for (std::size_t cell = 0; cell < made_.cells.size(); ++cell) {
      for (std::size_t place = 0; place <= d_; ++place) {
        made_.homes[static_cast<std::size_t>(made_.cells[cell][place].point)] = {cell, place};
      }
      reach(mesh_.simplices[cell], made_.sample);
    }
    for (const auto group : ByFacet(places())) {
      link(group[0], group[1]);
      link(group[1], group[0]);
    }
    return finished();
  }

  tl::expected<PeriodicDocument, std::string> refutation(const Verdict& verdict) {
    for (const auto& [rule, tally] : verdict.tallies()) {
      for (const Violation& violation : verdict.violations()) {
        if (violation.rule == rule && has_evidence(rule, violation.witness)) return finished();
      }
    }
    return tl::unexpected(fmt::format("there is no refutation of this mesh: none shows {}",
                                      identifier(verdict.tallies().begin()->first)));
  }

 private:
  static Integer number(std::size_t index) { return to_integer(index) + 1; }

  MovedPoint moved(Vertex v) const {
    const auto place = static_cast<std::size_t>(v);
    return {copies_.of[place], copies_.offsets[place]};
  }
  std::vector<FacetPlace> places() const { return facet_places(made_.cells); }

  std::vector<Integer> coordinates_of(Vertex v) const {
    std::vector<Integer> all;
    for (std::size_t axis = 0; axis < d_; ++axis) all.push_back(made_.points.coordinate(v, axis));
    return all;
  }

  // Unfolding has copied point 0 to the end of each vector.
  void add_lattice() {
    made_.lattice.resize(d_);
    for (Vertex v = 0; mesh_.points.names(v); ++v) {
      const MovedPoint copy = moved(v);
      for (std::size_t i = 0; i < d_; ++i) {
        Simplex along(d_, 0);
        along[i] = 1;
        if (copy != MovedPoint{0, along}) continue;
        made_.lattice[i] = coordinates_of(v);
        for (std::size_t axis = 0; axis < d_; ++axis) {
          made_.lattice[i][axis] -= made_.points.coordinate(0, axis);
        }
      }
    }
    const auto& b = made_.lattice;
    if (d_ == 2) {
      made_.dual = {{b[1][1], -b[1][0]}, {-b[0][1], b[0][0]}};
    } else {
      for (std::size_t i = 0; i < 3; ++i)
        made_.dual.push_back(cross(b[(i + 1) % 3], b[(i + 2) % 3]));
    }
    made_.factor = inner(made_.dual[0], b[0]);
    if (made_.factor > 0) return;
    made_.factor = -made_.factor;
    for (auto& row : made_.dual) {
      for (Integer& x : row) x = -x;
    }
  }

  static std::vector<Integer> cross(const std::vector<Integer>& u, const std::vector<Integer>& v) {
    const auto product = cross_product(Triple<Integer>{u[0], u[1], u[2]}, {v[0], v[1], v[2]});
    return {product.begin(), product.end()};
  }
  static Integer inner(const std::vector<Integer>& u, const std::vector<Integer>& v) {
    Integer sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += u[i] * v[i];
    return sum;
  }
  static Integer floor_of(const Integer& over, const Integer& under) {
    Rational value(over, under);
    value.canonicalize();
    return rounded_down(value);
  }

  // By which multiples some of the vertices are not all on one side of the point, seen along a
  // vector of the dual basis.
  void reach(const Simplex& vertices, const HomogeneousPoint& q) {
    const Integer step = q.denominator * made_.factor;
    for (const std::vector<Integer>& row : made_.dual) {
      const Integer value = inner(row, q.numerators);
      for (const Vertex v : vertices) {
        const Integer ahead = value - q.denominator * inner(row, coordinates_of(v));
        const Integer down = floor_of(ahead, step);
        const Integer up = -floor_of(Integer(-ahead), step);
        if (!reaches_ || down < made_.first_reached) made_.first_reached = down;
        if (!reaches_ || up > made_.last_reached) made_.last_reached = up;
        reaches_ = true;
      }
    }
  }

  void link(const FacetPlace& own, const FacetPlace& other) {
    made_.links[own.cell][own.opposite] = {other.cell, other.opposite,
                                           difference(own.moved, other.moved)};
  }

  tl::expected<PeriodicDocument, std::string> finished() {
    const Integer width = made_.last_reached - made_.first_reached + 1;
    if (width > kMostReached) {
      return tl::unexpected(fmt::format(
          "expected cells that are all listed within {} lattice vectors of each other for a "
          "certificate, found {}: move them together by changing offsets",
          kMostReached, width.get_str()));
    }
    return std::move(made_);
  }

  bool shown(const char* rule, std::vector<Integer> because, const Simplex& offset = {}) {
    made_.rule = rule;
    made_.because = std::move(because);
    for (const Vertex x : offset) made_.because.push_back(to_integer(x));
    return true;
  }

  bool has_evidence(Rule rule, const Witness& witness) {
    switch (rule) {
      case Rule::kRepeatedVertex:
      case Rule::kDegenerateSimplex: {
        const auto cell = number_of(mesh_, witness.simplices.front());
        return cell && shown("simplex.degenerate", {to_integer(*cell)});
      }
      case Rule::kDuplicateSimplex:
      case Rule::kFacetOverused:
        return same_but_for_a_move();
      case Rule::kNotClosed:
        return open_facet();
      case Rule::kCoveredTwice:
        return covered_twice(witness);
      case Rule::kUnusedPoint: {
        const Vertex v = witness.vertices.front();
        for (const Simplex& simplex : mesh_.simplices) {
          for (const Vertex corner : simplex) reach({v}, barycentre(made_.points, {corner}));
        }
        return shown("triangulation.unused-point", {number(static_cast<std::size_t>(v))});
      }
      case Rule::kFacetNotLocal: {
        const auto cell = number_of(mesh_, witness.simplices.front());
        const MovedPoint apex = moved(witness.vertices.front());
        return cell && shown("delaunay.vertex-in-ball",
                             {to_integer(*cell), number(static_cast<std::size_t>(apex.point))},
                             apex.offset);
      }
      default:
        return false;
    }
  }

  // Two cells that are the same when both begin at their least corner.
  bool same_but_for_a_move() {
    std::vector<std::pair<PeriodicCell, std::size_t>> named;
    std::vector<Simplex> first;
    for (std::size_t i = 0; i < made_.cells.size(); ++i) {
      PeriodicCell cell = made_.cells[i];
      std::sort(cell.begin(), cell.end());
      first.push_back(cell.front().offset);
      for (MovedPoint& corner : cell) {
        corner.offset = difference(corner.offset, first.back());
      }
      named.emplace_back(std::move(cell), i);
    }
    std::sort(named.begin(), named.end());
    const auto twice =
        std::adjacent_find(named.begin(), named.end(),
                           [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice == named.end()) return false;
    const std::size_t a = twice->second;
    const std::size_t b = (twice + 1)->second;
    return shown("complex.duplicate-simplex", {number(a), number(b)},
                 difference(first[a], first[b]));
  }

  bool open_facet() {
    for (const auto group : ByFacet(places())) {
      if (group.size() != 1) continue;
      const FacetPlace& open = group.front();
      const Simplex& simplex = mesh_.simplices[open.cell];
      // The checker looks where the first vertex of the facet is.
      const Vertex first = simplex[open.opposite == 0 ? 1 : 0];
      for (const Simplex& other : mesh_.simplices) reach(other, barycentre(made_.points, {first}));
      return shown("complex.not-closed", {number(open.cell), to_integer(open.opposite)});
    }
    return false;
  }

  // The witness names a point inside the first of two cells, and how the second is moved.
  bool covered_twice(const Witness& witness) {
    if (!witness.point || witness.places.size() != 2) return false;
    Simplex way;
    for (std::size_t i = 0; i < d_; ++i) {
      way.push_back(witness.values[i].value.get_num().get_si());
    }
    shown("triangulation.covered-twice", {number(witness.places[0]), number(witness.places[1])},
          way);
    const HomogeneousPoint point = scaled(made_.points, *witness.point);
    made_.because.insert(made_.because.end(), point.numerators.begin(), point.numerators.end());
    made_.because.push_back(point.denominator);
    return true;
  }

  const ExactMesh& mesh_;
  const Copies& copies_;
  std::size_t d_;
  PeriodicDocument made_;
  bool reaches_ = false;
};

void write_rows(Lines& lines, std::string_view name,
                const std::vector<std::vector<Integer>>& rows) {
  lines << name << rows.size();
  lines.end_line();
  for (const std::vector<Integer>& row : rows) {
    for (const Integer& x : row) lines << x;
    lines.end_line();
  }
}

void write_cells(Lines& lines, const PeriodicDocument& document) {
  begin_section(lines, "cells", document.cells.size());
  for (std::size_t i = 0; i < document.cells.size(); ++i) {
    for (const MovedPoint& corner : document.cells[i]) {
      lines << corner.point + 1;
      for (const Vertex x : corner.offset) lines << x;
      lines.gap();
    }
    if (document.rule.empty()) {
      for (const PeriodicDocument::Link& link : document.links[i]) {
        lines << link.cell + 1 << link.place;
        for (const Vertex x : link.offset) lines << x;
        lines.gap();
      }
    }
    lines.end_line();
  }
}

}  // namespace

tl::expected<PeriodicDocument, std::string> periodic_document_of(const ExactMesh& mesh,
                                                                 const Copies& copies,
                                                                 const Verdict& verdict) {
  auto points = scaled_to_integers(mesh.points);
  if (!points) return tl::unexpected(points.error());
  PeriodicWriter writer(mesh, copies, std::move(*points));
  if (!writer.has_cells()) {
    return tl::unexpected(fmt::format("there is no refutation of this mesh: none shows {}",
                                      identifier(verdict.tallies().begin()->first)));
  }
  return verdict.holds() ? writer.certificate() : writer.refutation(verdict);
}

void write(std::ostream& out, const ExactMesh& mesh, const PeriodicDocument& document) {
  Lines lines(out);
  const bool holds = document.rule.empty();
  write_first_line(lines, holds ? "circumspect-certificate 1" : "circumspect-refutation 2",
                   Claim::kPeriodicDelaunay, document.points.dimension, document.rule);
  write_scale(lines, document.points);
  write_rows(lines, "lattice", document.lattice);
  write_rows(lines, "dual", document.dual);
  lines << "factor" << document.factor;
  lines.end_line();
  lines << "reach";
  for (Integer z = document.first_reached; z <= document.last_reached; ++z) lines << z;
  lines.end_line();
  begin_section(lines, "points", document.listed);
  for (std::size_t i = 0; i < document.listed; ++i) {
    const auto v = static_cast<Vertex>(i);
    write_point(lines, document.points, v, false);
    lines.gap();
    if (holds) {
      lines << document.homes[i].cell + 1 << document.homes[i].place;
      lines.gap();
    }
    lines << mesh.label(v);
    lines.end_line();
  }
  write_cells(lines, document);
  if (holds) {
    lines << "sample" << 1;
    write_point(lines, document.sample);
  } else {
    lines << "because";
    for (const Integer& token : document.because) lines << token;
  }
  lines.end_line();
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
