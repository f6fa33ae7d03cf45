// Are two complexes of doubles the same, up to numbering? What difference() says, of arrays.
#pragma once

#include <optional>

#include "oracle/formats/flat_mesh.hpp"
#include "oracle/judge/points/cells.hpp"
#include "oracle/judge/points/difference.hpp"

namespace circumspect::check {

// Points whose coordinates and weights are doubles, and the cells that are compared.
struct FlatComplex {
  formats::FlatPoints points = {};  // weights: none, or one a point; none is 0
  Cells cells = {};
};

// Of a mesh that has been read into arrays; with the weights that were read, or without.
FlatComplex flat_complex(const formats::FlatMesh& mesh, bool weighted);

// Of a mesh of exact numbers; none if one of them is not a double.
std::optional<FlatComplex> flat_complex(const Mesh& mesh);

// None if a number is not finite, or two points of one mesh are equal.
std::optional<Difference> difference(const FlatComplex& a, const FlatComplex& b);

}  // namespace circumspect::check
