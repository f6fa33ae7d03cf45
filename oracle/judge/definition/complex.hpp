// Is a mesh by itself a simplicial complex, and what is wrong if it is not? The definition of the
// claim `complex`: any two listed simplices A and B meet in the convex hull of their common
// vertices and nowhere else. Book: Definition 2.1.
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect::definition {

// Points may be equal and simplices may be anything: what cannot be judged is set apart.
struct ListedComplex {
  std::vector<Point> points;
  std::vector<Simplex> simplices;
};

// The simplices that are compared, by their places in the list, with equal points merged into the
// first of them; and what was set apart. The vertices of those set apart count as used.
struct SetApart {
  std::vector<Duplicate> equal_points = {};
  std::vector<Vertex> unused_points = {};
  std::vector<std::size_t> not_simplices = {};  // an index that names no point, or another size
  std::vector<std::size_t> repeating = {};      // a vertex twice
  std::vector<std::size_t> flat = {};
  std::vector<std::size_t> doubled = {};  // the vertices of one that comes before
  std::vector<std::size_t> compared = {};
  std::vector<Simplex> merged = {};  // all simplices, by their places
};
// Requires: simplices of the complex have `size` vertices.
SetApart set_apart(const ListedComplex& listed, std::size_t size);

// Every pair of simplices that does not meet as it should is of one kind:
// (a) their relative interiors meet; else
// (b) a vertex of one, not of the other, lies in the other: in the relative interior of this face
//     of it; else
// (c) two faces of them without a common vertex, each of dimension 1 or more, meet in one point of
//     their relative interiors, and no smaller faces of these do.
// Why there is no other kind: write a common point that is not in the common face as a combination
// of either simplex, and take from the difference a minimal affine dependence. Its positive and
// negative vertices are two such faces; one of them may be a vertex.
struct HangingVertex {
  Vertex vertex;
  Simplex face;  // ascending
  std::strong_ordering operator<=>(const HangingVertex&) const = default;
};
struct CrossingFaces {
  Simplex first, second;  // ascending, the lesser first
  std::strong_ordering operator<=>(const CrossingFaces&) const = default;
};
struct ImproperPairs {
  std::vector<std::array<std::size_t, 2>> overlaps = {};  // by the places of the simplices
  std::vector<HangingVertex> hanging = {};
  std::vector<CrossingFaces> crossing = {};
  // Were there so many overlaps that no more were looked for? Then only overlaps are listed.
  bool is_cut = false;
};
// Each (b) and (c) once, in order of indices. Left out is what only repeats something else: what
// has all its vertices in one flat simplex of the list, and what two simplices have that overlap.
ImproperPairs improper_pairs(const ListedComplex& listed, const SetApart& apart);

// What more can be asked, of the simplices that are compared.

// --manifold, of dimension 3 at most: a facet is in one or two simplices; a ridge in no facet of
// the boundary or in two; the simplices at a vertex are connected through facets at it, and if they
// are tetrahedra, the facets of the boundary at it form one circle at most. A ridge is named only
// if no facet that is named has it, a vertex only if neither a facet nor a ridge has.
struct NotManifold {
  std::vector<Simplex> facets = {}, ridges = {};
  std::vector<Vertex> vertices = {};
};
NotManifold not_manifold(const std::vector<Simplex>& simplices);

// --connected: how many parts there are that facets connect. --closed: the facets of one simplex
// only.
std::size_t parts(const std::vector<Simplex>& simplices);
std::vector<Simplex> open_facets(const std::vector<Simplex>& simplices);

// --faces: the places of the listed faces that no simplex of the list has, whatever else it is. A
// face has two different vertices or more, all of which name points; equal points are one vertex.
std::vector<std::size_t> stray_faces(const ListedComplex& listed,
                                     const std::vector<Simplex>& faces);

// --oriented: the sign of det[p_1 − p_0; …; p_d − p_0] of each simplex of full dimension.
std::vector<int> orientation_signs(const std::vector<Point>& points,
                                   const std::vector<Simplex>& simplices);
// Of simplices of any dimension: the facets of two simplices that both go around it in the same
// sense.
std::vector<Simplex> inconsistent_facets(const std::vector<Simplex>& simplices);

}  // namespace circumspect::definition
