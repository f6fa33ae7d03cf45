// For tests: verdicts as text, with labels for vertices, as all reports have them.
#pragma once

#include <sstream>
#include <string>

#include "kernel/complex/circumball.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

inline void write_simplex(std::ostream& out, const ExactMesh& mesh, const Simplex& simplex) {
  out << " [";
  for (const Vertex v : simplex) {
    out << ' ' << mesh.label(v);
    for (const Rational& x : mesh.points.names(v) ? mesh.points[v] : Point()) out << ',' << x;
  }
  out << " ]";
}

inline void write_ball(std::ostream& out, const Ball& ball) {
  out << " ball";
  for (const Rational& x : ball.centre) out << ' ' << x;
  out << " / " << ball.squared_radius;
}

inline void write_witness(std::ostream& out, const ExactMesh& mesh, const Witness& witness) {
  for (const Simplex& simplex : witness.simplices) write_simplex(out, mesh, simplex);
  if (witness.face) write_simplex(out << " face", mesh, *witness.face);
  write_simplex(out << " vertices", mesh, witness.vertices);
  for (const NamedValue& value : witness.values) out << ' ' << value.name << ' ' << value.value;
  if (witness.ball) write_ball(out, *witness.ball);
  if (witness.point) {
    for (const Rational& x : *witness.point) out << ' ' << x;
  }
}

inline std::string text_of(const Verdict& verdict, const ExactMesh& mesh) {
  std::ostringstream out;
  out << name(verdict.claim()) << ' ' << verdict.points << ' ' << verdict.simplices << ' '
      << verdict.dimension << ' ' << verdict.unique.value_or(false) << verdict.unique.has_value()
      << verdict.canonical.value_or(false) << verdict.canonical.has_value() << '\n';
  for (const auto& [rule, tally] : verdict.tallies()) {
    out << identifier(rule) << ' ' << tally.count;
    if (tally.worst_margin) out << ' ' << *tally.worst_margin;
    out << '\n';
  }
  for (const Violation& violation : verdict.violations()) {
    out << identifier(violation.rule);
    write_witness(out, mesh, violation.witness);
    out << '\n';
  }
  return out.str();
}

}  // namespace circumspect::check
