// Proof that a mesh is a triangulation, Delaunay or not: the mesh, and all that a proved checker
// needs to see this in linear time. proofs/CERTIFICATE.md has the conditions that it has to fulfil.
#pragma once

#include <array>
#include <charconv>
#include <compare>
#include <concepts>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

// Writes lines of tokens, many of them.

class Lines {
 public:
  explicit Lines(std::ostream& out) : out_(out) {}
  ~Lines() { flush(); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  Lines& operator<<(std::string_view token);
  Lines& operator<<(const Integer& number);
  // Any integer of the machine.
  template <std::integral Number>
  Lines& operator<<(Number number) {
    constexpr std::size_t kLongest = 24;
    if (text_.size() - used_ < kLongest) flush();
    char* const to = text_.data() + used_;
    *to = ' ';
    const auto end = std::to_chars(to + (at_start_ ? 0 : 1), to + kLongest, number).ptr;
    used_ = static_cast<std::size_t>(end - text_.data());
    at_start_ = false;
    return *this;
  }
  // Separates groups of tokens.
  Lines& gap();
  void end_line();

 private:
  void append(std::string_view text);
  void flush();

  std::ostream& out_;
  std::vector<char> text_ = std::vector<char>(std::size_t{1} << 16);
  std::size_t used_ = 0;  // of it
  bool at_start_ = true;
};

// A claim, its dimension and what else is said of it, after the first words of a file, `kind` and
// its version.
void write_first_line(Lines& lines, std::string_view kind, Claim claim, std::size_t dimension,
                      std::string_view more = "");

void write_scale(Lines& lines, const ScaledPoints& points);

// Coordinates, and the weight if `weighted`.
void write_point(Lines& lines, const ScaledPoints& points, Vertex v, bool weighted);

// The first line of a section, which has so many more.
void begin_section(Lines& lines, std::string_view name, std::size_t count);

// All points in this order, each with the index by which the user knows it.
template <class AnyMesh>
void write_points(Lines& lines, const AnyMesh& mesh, const ScaledPoints& points,
                  const std::vector<Vertex>& order, bool weighted = false) {
  begin_section(lines, "points", order.size());
  for (const Vertex v : order) {
    write_point(lines, points, v, weighted);
    lines.gap() << mesh.label(v);
    lines.end_line();
  }
}

// Numerators and denominator.
void write_point(Lines& lines, const HomogeneousPoint& point);

// Which cells share a face: facets of simplices, and ridges of hull facets.

// One cell's use of a face: a tuple without memory of its own, of which there are millions.
struct FaceUse {
  std::array<std::uint32_t, 3> face;  // its vertices, ascending; what is left over is 0
  std::uint32_t cell;
  std::uint32_t place;  // of the cell's vertex that the face leaves out

  auto operator<=>(const FaceUse&) const = default;
};

// The use of the face opposite vertex number `place`. Requires: at most four vertices.
FaceUse face_use(std::span<const std::uint32_t> vertices, std::size_t cell, std::size_t place);

// The uses of the facets of a mesh. Requires: simplices of at most four vertices, which are points.
std::vector<FaceUse> facets(const ExactMesh& mesh);

void sort(std::vector<FaceUse>& uses);

// Sorts by face, so that the uses of one stand together, and calls `visit` once a face with them.
void for_each_face(std::vector<FaceUse>& uses, const auto& visit) {
  sort(uses);
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first;
    while (last < uses.size() && uses[last].face == uses[first].face) ++last;
    visit(std::span<const FaceUse>(uses).subspan(first, last - first));
    first = last;
  }
}

// What lies across a facet or a ridge, and the place of its vertex that the facet or ridge leaves
// out.
// A facet of the hull has a hull facet there, which leaves out no vertex.
struct Across {
  std::uint32_t cell = 0;
  std::int32_t place = kHull;

  static constexpr std::int32_t kHull = -1;
};

// Vertices are those of the mesh; in the plane the last entry of each array is not used.
struct CertifiedSimplex {
  std::array<Vertex, 4> vertices = {};  // positively oriented
  std::array<Across, 4> across = {};
  std::optional<std::size_t> separating = {};  // the facet beyond which the sample lies
};

// The vertices of a hull facet are in the order of its simplex.
struct HullFacet {
  std::uint32_t simplex = 0;
  std::uint32_t place = 0;
  std::array<Across, 3> across = {};
};

// Where a point is a vertex; or, if it is none, in which simplex it lies.
struct Incidence {
  std::uint32_t simplex = 0;
  std::optional<std::size_t> place = {};
};

// All points, by their coordinates and then by their numbers.
std::vector<Vertex> lexicographic_order(const ScaledPoints& points);

// The number in a file of each vertex, counted from 1 in that order of all vertices.
std::vector<std::size_t> numbers_in(const std::vector<Vertex>& order);

struct Certificate {
  Claim claim = Claim::kDelaunay;
  ScaledPoints points;
  std::vector<Vertex> order = {};  // all vertices, in lexicographic order of their coordinates
  std::vector<Incidence> incidences = {};  // one a vertex
  std::vector<CertifiedSimplex> simplices = {};
  std::vector<HullFacet> hull = {};
  HomogeneousPoint sample = {};  // in the interior of the first simplex
  // Besides the claim: `unique` if it is the only such triangulation of the points, `canonical` if
  // it is the canonical one; or nothing.
  std::string_view standing = {};
};

// Linear in the mesh but for sorting, and for what it takes to find weighted points that are not
// vertices. Requires: the claim holds of the mesh; its points have dimension 2 or 3, and that is
// the dimension of their affine hull.
Certificate certificate_of(const ExactMesh& mesh, Claim claim, ScaledPoints points);

// The same from the arrays of a large mesh, which are not copied, with its standing. Nothing unless
// triangulation or delaunay holds of doubles without weights, and the simplices have as many
// dimensions as the points: then document_of (document.hpp) is to be asked.
std::optional<Certificate> certificate_of(const Mesh& mesh, const Verdict& verdict);

// What a verdict says beside the claim.
std::string_view standing_of(const Verdict& verdict);

// From the scale to the sample point; proofs/CERTIFICATE.md lays it out. The mesh says by which
// index its user knows a point.
// The last points, so many, have no label.
void write_mesh(Lines& lines, const ExactMesh& mesh, const Certificate& certificate,
                std::size_t helpers = 0);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const Certificate& certificate);
void write(std::ostream& out, const Mesh& mesh, const Certificate& certificate);

// In which simplices of a triangulation do points lie? Book: Section 5.5 (walking).

// For each of the points a simplex that contains it (kernel/boxes/point_search.hpp). Requires:
// simplices and what is across their facets; each of the points is in one of the simplices.
std::vector<std::uint32_t> simplices_that_contain(const Certificate& certificate,
                                                  std::span<const std::size_t> points);

}  // namespace circumspect::certificate
