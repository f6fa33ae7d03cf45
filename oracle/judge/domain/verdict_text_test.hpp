// All that a verdict says, as text, so that two can be compared in a test. What people read is made of
// the same.
#pragma once

#include <sstream>
#include <string>

#include "oracle/model/verdict.hpp"

namespace circumspect::check {

inline void write_vertices(std::ostream& out, const Simplex& simplex) {
  for (const Vertex v : simplex) out << " " << v;
}
inline void write_point(std::ostream& out, const Point& point) {
  for (const Rational& x : point) out << " " << x;
}

inline void write_witness(std::ostream& out, const Witness& witness) {
  for (const Simplex& simplex : witness.simplices) {
    out << " simplex";
    write_vertices(out, simplex);
  }
  out << " face";
  write_vertices(out, witness.face.value_or(Simplex{}));
  out << " vertices";
  write_vertices(out, witness.vertices);
  for (const NamedValue& value : witness.values) out << " " << value.name << " " << value.value;
  if (witness.ball) {
    out << " ball";
    write_point(out, witness.ball->centre);
    out << " " << witness.ball->squared_radius;
  }
  if (witness.point) {
    out << " point";
    write_point(out, *witness.point);
  }
  if (witness.domain_cell) {
    out << " cell";
    write_vertices(out, *witness.domain_cell);
  }
  if (witness.polygon) out << " polygon " << *witness.polygon;
  if (witness.nearest) {
    out << " nearest " << witness.nearest->vertex << " " << witness.nearest->squared_distance;
  }
}

inline std::string text_of(const Verdict& verdict) {
  std::ostringstream out;
  const auto word = [](const std::optional<bool>& fact) { return fact ? (*fact ? 1 : 0) : -1; };
  out << name(verdict.claim()) << (verdict.holds() ? " holds " : " fails ") << verdict.points << " "
      << verdict.simplices << " " << verdict.dimension << " unique " << word(verdict.unique)
      << " canonical " << word(verdict.canonical) << "\n";
  if (verdict.steiner_points) {
    out << verdict.steiner_points->on_segments << " " << verdict.steiner_points->in_polygons << " "
        << verdict.steiner_points->in_polyhedra << " Steiner points\n";
  }
  if (verdict.holds()) out << verdict.dangling << " dangling\n";
  if (verdict.extra_vertices) {
    out << verdict.extra_vertices->count << " extra:";
    write_vertices(out, verdict.extra_vertices->first);
    out << "\n";
  }
  for (const auto& [rule, tally] : verdict.tallies()) {
    out << identifier(rule) << " " << tally.count;
    if (tally.worst_margin) out << " worst " << *tally.worst_margin;
    out << "\n";
  }
  for (const Violation& violation : verdict.violations()) {
    out << identifier(violation.rule);
    write_witness(out, violation.witness);
    out << "\n";
  }
  return out.str();
}

}  // namespace circumspect::check
