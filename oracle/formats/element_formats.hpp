// The formats of meshes of elements: readers and writers. VTK's old format is in vtk.hpp.
#pragma once

#include <ostream>

#include "kernel/exact/number.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// ---- Gmsh ----
// Meshes as Gmsh writes them, in text or binary of either byte order: .msh, version 2 and 4.1.
//
//     $MeshFormat                                 version, 0 (text) or 1 (binary), 8
//     $Nodes                                      each has a tag of its own, in any order
//     $Elements                                   of all dimensions; the (first) physical group of
//                                                 each is its label, 0 if it is in none
//     $Entities                                   of version 4.1: the physical groups of each
//     $PhysicalNames, $NodeData, …                other sections are skipped
//
// Lines outside the sections are skipped, with a note. Numbers follow one another, wherever lines
// end.

// Is this the word with which such a file begins?
bool is_gmsh_keyword(std::string_view token);

// Points are in the order of their tags and counted from the lowest; if tags have gaps, they are
// counted from 1, which is noted.
Result<ElementFile> read_gmsh(const Source& source, NumberReading reading);

// Version 2.2, in text; tags count from 1; labels are physical groups. Requires: points of
// dimension 2 or 3, whose third coordinate is written as 0; vertices are counted from the first
// index of the points.
void write_gmsh(std::ostream& out, const ElementFile& file);

// ---- Medit ----
// Meshes as Medit and Gmsh write them, as text: .mesh.
//
//     MeshVersionFormatted 2
//     Dimension 3                                 or 2
//     Vertices 8                                  for each: x y [z] reference
//     Edges 12                                    for each: v0 v1 reference
//     Triangles, Quadrilaterals, Tetrahedra …     likewise; indices from 1
//     …                                           other sections are read over
//     End                                         which may be missing: that is noted
//
// Numbers follow one another, wherever lines end.

// Is this the keyword with which such a file begins?
bool is_medit_keyword(std::string_view token);

// References are dropped; the first index is 1.
Result<ElementFile> read_medit(const Source& source, NumberReading reading);

// Requires: points of dimension 2 or 3; vertices are counted from the first index of the points.
void write_medit(std::ostream& out, const ElementFile& file);

// ---- VTK in XML ----
// Meshes and surfaces in VTK's XML format: .vtu (UnstructuredGrid) and .vtp (PolyData), their
// arrays as text, as bytes in base 64, or appended, compressed by zlib or not.
//
// Points of several pieces follow one another. Numbers in text are taken as they are written,
// whatever type is declared. Data of points and cells are ignored.

// Does the text begin as such a file does?
bool is_vtu(std::string_view text);

// Points are counted from 0.
Result<ElementFile> read_vtu(const Source& source, NumberReading reading);

// An UnstructuredGrid, in text; labels, which all cells have or none, are cell data. Requires:
// points of dimension 2 or 3, whose third coordinate is written as 0; vertices are counted from the
// first index of the points.
void write_vtu(std::ostream& out, const ElementFile& file);

// ---- .tet ----
// Meshes of tetrahedra as the program CDT of Attene and Diazzi and others write them: .tet.
//
//     8 vertices
//     6 tets                                      or 6 inner tets, and on a line below 4 outer tets
//     x y z                                       a line each; with option r, fractions
//     4 v0 v1 v2 v3                               a line each, indices from 0
//
// With option b, everything after the counts is binary: doubles, then vertices of 32 bits.

// Outer tetrahedra, which fill the convex hull around a domain, are left out, which is noted.
// Points are counted from 0.
Result<ElementFile> read_tet(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
