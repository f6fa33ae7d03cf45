// Which sides of walls face the same region. Book: Section 4.5.1 (the polyhedra of a PLC).
#pragma once

#include <vector>

#include "reference/piecewise_linear/wall_set.hpp"

namespace circumspect {

// The regions are the components of the complement of all walls. Number 0 is the unbounded one, the
// others are numbered in the order in which they first appear here.
struct WallSides {
  std::vector<std::size_t> region;  // in front of wall i at place 2i, behind it at 2i + 1
  std::size_t regions = 1;
};

// Joins the sides of walls that face each other, in three ways.
//
// 1. Around a ridge (in space an edge, in the plane a vertex) the walls are sorted in rotary order;
//    the near sides of two that follow each other bound one wedge of the complement. A ridge with
//    one wall joins its two sides.
// 2. (Space only.) Walls at a vertex x, cut by a small sphere about x, are arcs; a component of
//    what they leave of the sphere is a cone of the complement at x. Step 1 has joined the sides of
//    arcs that share ends. If the arcs are connected, no more is needed; else a path on the sphere
//    is drawn from an arc of each connected set of arcs to one of the next, and wherever it crosses
//    two arcs in succession, the sides between are joined.
// 3. Likewise a path is drawn from one connected set of walls to the next, all of them in a row.
//
// Nothing false is joined: two crossings in succession face each other through one region. And
// everything is. Take a region U and make it smaller by a thin layer along all walls, so that its
// boundary is a closed surface (3: in space; 2: on the sphere about x, a curve), along which one
// can walk from wall side to wall side around ridges and, on a surface, corners. The complement of
// U (infinity included, so that U lies on a sphere of some dimension) falls into connected pieces
// D_1, D_2, …; the boundary of one is connected, for the sphere is unicoherent: if two connected
// closed sets D_i and the closure of the rest cover it, they meet in a connected set. So all sides
// that face U from one D_i are joined by walking along the surface: by step 1 and, at corners, step
// 2. Every D_i that U has a wall in common with contains with one wall all that is connected to it, so
// the path visits every D_i. Between its stay in one D_i and the next in D_j it goes through U
// alone, and the last wall it has left and the next one it meets join the sides of D_i with those
// of D_j. As it visits all of them, all are joined.
//
// Paths are made of straight segments that meet walls in interior points only, out of the walls'
// own planes; a bend in each makes that possible. For all but finitely many points of a moment
// curve (t, t², t³), which meets no plane more than three times, it is so.
WallSides wall_sides(const PointSet& points, const WallSet& walls);

// Some points about a straight way: the bend in a path. Those of them for t = 1, 2, … lie on a
// moment curve; `scale` says how far they are from `origin`.
Point on_moment_curve(const Point& origin, const Rational& scale, int t);

// The way between two points, bent at the t-th of some points that lie about its middle; on moment
// curves as well.
Point bend(const Point& from, const Point& to, int t);

}  // namespace circumspect
