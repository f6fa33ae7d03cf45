// check --claim periodic-delaunay: the lattice, and a mesh that it repeats.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/input/input.hpp"
#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::cli {

// The vectors, one after the other, or the box whose edges they are.
struct LatticeOption {
  std::vector<Rational> numbers = {};

  bool is_given() const { return !numbers.empty(); }
};

void add_lattice_option(CLI::App& command, LatticeOption& lattice);

// Replaces what was read from an .ele file, whose attributes are the offsets, by a mesh with a
// point for each corner. What is wrong with the input, one line; empty if all is well.
// Requires: a lattice or a box.
std::string unfold(LoadedMesh& loaded, const LatticeOption& lattice,
                   const std::optional<JudgedBox>& box);

}  // namespace circumspect::cli
