// The sentence that says what a picture shows, and what it draws for one rule alone: columns of
// oracle/model/rules.def.
#pragma once

#include <string>
#include <string_view>

#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::picture {

// The rule's sentence with its fields filled in, by the user's own indices:
//   {first} {second}          simplices, "3 4 6 2"; {simplex} {other simplex}: with their noun,
//                             "triangle 3 4 6"
//   {noun} {corners} {count}  of the first its noun and how many vertices it has; how many
//                             simplices there are
//   {face}                    "edge 3 4"; "the empty face"
//   {vertices}                "7"
//   {expected}                how many vertices a simplex is to have
//   {measured} {required}     what was measured of the first simplex, and what was required
//   {nearest} {distance}      the nearest vertex, and how far it is
//   {ball}                    "circle" in the plane, "ball" elsewhere
//   {flat}                    "on one line" in the plane, "in one plane" elsewhere
// What stands in brackets is left out where the witness lacks one of its fields. If it lacks
// another one, the meaning of the rule stands for the sentence.
std::string caption(const Violation& violation, const Mesh& mesh);

// "common-part": the name by which the page knows a mark.
std::string_view name(Mark mark);

}  // namespace circumspect::picture
