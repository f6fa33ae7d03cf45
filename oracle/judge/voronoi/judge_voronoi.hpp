// Judges whether listed cells are the Voronoi cells of sites, up to a distance:
// docs/theory/questions.md.
#pragma once

#include <optional>
#include <string>

#include "oracle/model/verdict.hpp"
#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::check {

// Why the diagram cannot be judged within the box, one line that says what to do; empty if it can.
std::string fault_of_diagram(const VoronoiDiagram& diagram, const std::optional<JudgedBox>& box);

// No cell may be farther from that of its site than a distance, which is given by its square. With
// `has_structure`, vertices and ridges are to be those of the diagram within this distance, too.
// The answer is the same by definition and by lemma, but for the time that it takes.
// Requires: fault_of_diagram has none, and fault_of_structure if this is asked for;
// squared_distance >= 0.
Verdict judge_voronoi(const VoronoiDiagram& diagram, const std::optional<JudgedBox>& box,
                      const Rational& squared_distance, bool by_definition,
                      std::size_t max_violations, bool has_structure = false);

}  // namespace circumspect::check
