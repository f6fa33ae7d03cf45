// What a faster judge knows of the simplices of a mesh before they are held against a domain.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// That there is one says: the mesh has simplices, and conditions 0 and 1 of docs/theory/points.md hold of them (not
// of listed faces); if the orientation of all was asked for, it is one; and the lists below are right.
// Facets are named by simplex · (d + 1) + place of the vertex opposite, those of two simplices as the one
// that comes first has them.
struct KnownVolume {
  std::vector<std::uint64_t> boundary;  // all facets of one simplex
  // Of two simplices, if the claim is about balls, as it is of a `cdt`: all that are not locally Delaunay;
  // all whose apexes are on a common sphere; and those of these that the canonical perturbation makes
  // not locally Delaunay.
  std::vector<std::uint64_t> not_local = {};
  std::vector<std::uint64_t> ties = {};
  std::vector<std::uint64_t> not_canonical = {};
  // Is it known that conditions 2 and 3 of docs/theory/points.md hold, too?
  bool fills_hull = false;

  // The vertices of a facet, ascending.
  static Simplex vertices(const Mesh& mesh, std::uint64_t facet) {
    const std::size_t size = mesh.simplices.front().size();
    return sorted(facet_opposite(mesh.simplices[facet / size], facet % size));
  }
};

}  // namespace circumspect::check
