// Judges whether the listed vertices and ridges are those of the Voronoi diagram, up to a distance:
// docs/theory/questions.md.
#pragma once

#include <string>

#include "oracle/judge/definition/voronoi_structure.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::check {

// Why the structure cannot be judged, one line that says what to do; empty if it can.
std::string fault_of_structure(const VoronoiDiagram& diagram);

// Adds what is wrong with the vertices or, if all are right, with the ridges. `exact`: what the
// diagram of the sites has in the box. `tries_all`: whether every two places are compared;
// otherwise those that are near each other along the first axis, which gives the same answer.
// Requires: fault_of_structure has none; the verdict of the claim `voronoi`.
void judge_structure(const VoronoiDiagram& diagram, const JudgedBox& box,
                     const Rational& squared_distance, const definition::VoronoiStructure& exact,
                     bool tries_all, Verdict& verdict);

}  // namespace circumspect::check
