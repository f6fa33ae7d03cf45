// The steps of a construction, as pictures: `build --html FILE` shows one after the other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/complex/polytope.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/report/json.hpp"
#include "reference/constrained/flip_insert_polygon.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/flip_algorithm.hpp"

namespace circumspect::cli {

// Of more points no steps are kept, and of a construction no more steps than this.
inline constexpr std::size_t kMostStepPoints = 200;
inline constexpr std::size_t kMostSteps = 600;

// Is told by a construction what it does, and makes frames of it, each with the book's name of the
// step.
class Steps {
 public:
  // The points outlive it.
  explicit Steps(const ExactMesh& mesh);

  void inserted(const delaunay::Insertion& insertion);                           // Section 5.2
  void finished(const OrientedFacet& facet, std::optional<Vertex> apex);         // Section 5.6
  void flipped(const delaunay::FlipStep& step);                                  // Section 4.4
  void wrapped(const Face& facet_of_lifted_hull, bool is_lower);                 // Section 4.2
  void flipped(const std::string& polygon, const constrained::TimedFlip& flip);  // Section 5.8
  // The construction begins with all these simplices.
  void begun(const std::vector<Simplex>& simplices, const std::string& words);
  // It has come to these.
  void done(const std::vector<Simplex>& simplices);

  // For picture::Facts: `picture` has the points, of the plane also lifted ones if any were
  // wrapped, and `frames` what changes:
  //   step, words        the book's name of the step, and what it does
  //   deleted, created   simplices, by the places of their points
  //   look               simplices that are looked at
  //   vertex, face       likewise, those that there are; `ball`: the simplex
  //                      whose circumball is drawn;
  //   outline            the corners of a polygon, in no order
  report::Json json();

 private:
  report::Json& frame(const std::string& step, const std::string& words);
  std::string named(const Simplex& simplex) const;  // "triangle 1 2 3"
  std::string label(const Simplex& simplex) const;  // "1 2 3"
  std::string why_in_ball(const Simplex& simplex, Vertex v) const;

  const ExactMesh& mesh_;
  bool is_lifted_ = false;
  std::size_t left_out_ = 0;
  report::Json beyond_ = {};  // the frame that is left out
  report::Json frames_ = report::Json::array();
};

}  // namespace circumspect::cli
