// Programs and meshes that are wrong on purpose, each with a mistake that people really make. What
// finds all of them is worth running on programs whose mistakes nobody knows.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <circumspect/subject.hpp>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "reference/constrained/split_segments.hpp"

namespace circumspect::faulty {

enum class Kind { kPredicate, kImplementation, kCorruption, kDomain };
std::string_view name(Kind kind);

// A program that fills a domain. Nothing, where the input gives it no occasion to run.
using DomainMesher = std::function<std::optional<ExactMesh>(const PiecewiseLinearInput&)>;

struct Fault {
  std::string name;   // lower-case words joined by hyphens
  std::string about;  // what the mistake is, and where people make it
  Kind kind = Kind::kImplementation;
  Claim claim = Claim::kDelaunay;                // what the program says of its output
  Triangulator triangulate = {};                 // of points; or
  DomainMesher mesh = {};                        // of a domain
  std::vector<std::size_t> dimensions = {2, 3};  // in which the mistake can be made
  std::size_t most_points = 12;                  // of an input
  bool oriented = false;                         // the program promises one orientation besides
  // Inputs have as many points as a campaign draws; the program is given at most
  // `most_points` of them: the mistake takes more than a few to show.
  bool needs_many = false;
};

// All of them.
const std::vector<Fault>& faults();

// Where they are from, each in a file of its own.
std::vector<Fault> predicate_faults();
std::vector<Fault> insertion_faults();
std::vector<Fault> size_faults();
std::vector<Fault> flip_faults();
std::vector<Fault> preparation_faults();
std::vector<Fault> weight_faults();
std::vector<Fault> corruptions();
std::vector<Fault> constraint_faults();
std::vector<Fault> domain_faults();

// Programs without any fault, for the same inputs: nothing may be found in them.
std::vector<Fault> right_programs();

// Of programs that triangulate points without weights, and of those that fill domains.

inline Fault implementation_fault(std::string name, std::string about, Triangulator triangulate) {
  return {std::move(name), std::move(about), Kind::kImplementation, Claim::kDelaunay,
          std::move(triangulate)};
}

inline Fault domain_fault(std::string name, std::string about, Claim claim, DomainMesher mesh,
                          std::vector<std::size_t> dimensions = {2, 3}) {
  return {std::move(name), std::move(about),     Kind::kDomain, claim, {},
          std::move(mesh), std::move(dimensions)};
}

// Right meshes of domains, to be spoilt.

// A constrained Delaunay triangulation, with its dangling faces; nothing if there is none.
std::optional<ExactMesh> cdt_mesh(const PiecewiseLinearComplex& complex);

// The same of an input; nothing also if that is not a domain of Definition 4.3.
std::optional<ExactMesh> cdt_of(const PiecewiseLinearInput& input);

// One of the complex with its segments split until they are strongly Delaunay.
struct SteinerMesh {
  ExactMesh mesh;
  std::vector<constrained::PointOnSegment> steiner_points;
};
SteinerMesh steiner_mesh(const PiecewiseLinearComplex& complex);

// A conforming Delaunay triangulation; nothing if so many Steiner points do not suffice.
std::optional<ExactMesh> conforming_mesh(const PiecewiseLinearComplex& complex,
                                         std::size_t most_steiner_points);

}  // namespace circumspect::faulty
