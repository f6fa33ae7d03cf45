// Proof that a mesh is a triangulation of a domain: the mesh as part of one of a whole convex hull,
// with the places of segments, polygons and holes in it; and proof that it is not.
// proofs/CERTIFICATE.md has the conditions of both.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/model/domain.hpp"

namespace circumspect::certificate {

// A vertex of the domain and of this simplex; or another, as a combination of vertices of the
// domain.
struct Role {
  std::optional<std::uint32_t> corner_of = {};
  std::vector<std::pair<Integer, Vertex>> weights = {};
};

// A step along a segment: to the vertex, by an edge of the simplex, which in the plane is its
// facet.
struct Step {
  Vertex reached;
  std::uint32_t simplex;
  std::size_t place;
};

struct SegmentSteps {
  Vertex from;
  std::vector<Step> steps = {};
};

struct Hole {
  HomogeneousPoint seed;
  std::uint32_t simplex;
};

// Part of which wall a facet is, and which piece of it; both count from 0.
using Flag = std::optional<std::pair<std::size_t, std::size_t>>;

struct Mark {
  std::array<Flag, 4> flags = {};
  // Of a simplex that is not kept: in which hole it is, or through which facet one leaves it, and
  // in how many steps.
  std::optional<std::size_t> hole = {};
  std::size_t place = 0;
  std::size_t rank = 0;  // 0: it is kept
};

// What there is to say of a domain beside the mesh of its hull.
struct DomainPart {
  std::vector<Role> roles = {};  // one a vertex
  std::vector<SegmentSteps> segments = {};
  std::vector<Hole> holes = {};
  std::vector<Mark> marks = {};  // one a simplex
  bool dangles = false;          // is a vertex or a step in no kept simplex?
};

// A polygon, seen along an axis as a domain in the plane.
struct PolygonCertificate {
  std::array<Integer, 3> normal = {};
  Integer offset = {};
  std::size_t axis = 0;
  ExactMesh mesh;
  Certificate plane = {};
  DomainPart part = {};
  std::vector<Vertex> above = {};  // by its vertices, those of the mesh in space
  std::vector<std::pair<std::uint32_t, std::size_t>> tiles = {};  // of its kept triangles: facets
  std::vector<HomogeneousPoint> seeds = {};
  std::vector<std::size_t> rim = {};  // which segments of the domain its own are
};

// What shows that the domain is a piecewise linear complex. A face of the mesh (a vertex, an edge,
// in polygons a triangle) is held by a segment, or by the polygon it is in; vertices of the domain
// by nothing.
struct Holder {
  bool is_segment;
  std::size_t number;
};
struct PolygonFaces {
  std::vector<std::pair<std::size_t, bool>> rim = {};  // its own segments: is it on one side only?
  // Those in it, and for each of their steps a triangle of the polygon with this edge.
  std::vector<std::pair<std::size_t, std::vector<std::size_t>>> segments = {};
};
struct ComplexPart {
  std::map<Simplex, Holder> faces = {};
  std::vector<bool> one_sided = {};  // by the walls: is the domain on one side only?
  std::vector<PolygonFaces> polygons = {};
};

struct DomainCertificate {
  Claim claim = Claim::kSteinerTriangulation;
  DomainKind kind = DomainKind::kEnclosed;
  ExactMesh whole;  // the kept simplices first
  Certificate mesh = {};
  DomainPart part = {};
  std::vector<PolygonCertificate> polygons = {};
  std::optional<ComplexPart> complex = {};
  std::size_t helpers = 0;  // points without a label, the last ones
  bool dangles = false;     // is a face in no kept simplex?
};

// A mesh of a domain in which nothing dangles, and the simplices that fill the hull of its points
// besides. Its points need not be vertices of the mesh.
struct FilledMesh {
  ExactMesh mesh;
  std::vector<Simplex> rest;
  std::size_t helpers = 0;  // so many points, the last ones, are nobody's: only the rest has them
};

// What a domain certificate needs and does not construct: it need not be trusted.
struct HullFillers {
  // d-simplices of points of the set that fill its convex hull together with the given ones, face
  // to face; nothing if none are found. The second list is what dangles: they should have it for
  // faces.
  using Filler = std::function<std::optional<std::vector<Simplex>>(
      const PointSet&, const std::vector<Simplex>&, const std::vector<Simplex>&)>;
  Filler fill;
  Filler fill_delaunay;  // likewise, and all of them Delaunay
  std::function<std::vector<Simplex>(const PointSet&)> triangulate;
  // One with Steiner points, if it needs them; or nothing.
  std::function<std::optional<FilledMesh>(const PiecewiseLinearComplex&)> mesh;
};

// Nothing if the boundary of a polygon or of what is filled is not a union of segments and
// polygons.
std::optional<ComplexPart> complex_part(const DomainCertificate& in);

// Of each polygon the segments that its own lines list; the others in it were adopted.
using ListedSegments = std::vector<std::set<Simplex>>;

// Requires: the claim, which is about a domain, holds of the mesh. Error: why there is none, for
// people.
tl::expected<DomainCertificate, std::string> domain_certificate_of(const ExactMesh& mesh,
                                                                   const Domain& domain,
                                                                   const ListedSegments& listed,
                                                                   Claim claim,
                                                                   const HullFillers& fillers);

// The same of a mesh with what fills its hull.
tl::expected<DomainCertificate, std::string> domain_certificate_of(const FilledMesh& filled_mesh,
                                                                   const Domain& domain,
                                                                   const ListedSegments& listed,
                                                                   Claim claim,
                                                                   const HullFillers& fillers);

// As proofs/CERTIFICATE.md lays it out.
void write(std::ostream& out, const DomainCertificate& certificate);

// What proves that a claim about a domain does not hold of a mesh: the mesh, the vertices and
// segments of the domain, and one fault.

// Evidence of which the whole domain is part: the rule, the word for it in the file, and the
// tokens.
struct WholeEvidence {
  Rule rule;
  std::string word;
  std::string because;
  std::optional<HomogeneousPoint> seen =
      {};  // the point that is in no simplex, or in none's face there
  std::optional<DomainCertificate> elsewhere = {};  // of another mesh, which has this point
};

// Of a domain what is not in its vertices and segments, for such evidence.
struct WholeDomain {
  DomainKind kind;
  WholeEvidence evidence;
  std::vector<HomogeneousPoint> holes = {};
  std::vector<PolygonCertificate> polygons = {};
};

// A triangle or an edge that is a face of no simplex, and points that make it one of full
// dimension, to see where it is.
struct DanglingFace {
  Simplex face;
  std::vector<std::vector<Integer>> pads;
};

struct DomainRefutation {
  Refutation refutation;
  ScaledPoints points;  // of the mesh, then the vertices of the domain that are none of these
  std::vector<Vertex> vertices;   // of the domain, among all points
  std::vector<Simplex> segments;  // of the domain, by its vertices
  std::optional<WholeDomain> whole = {};
  std::vector<DanglingFace> dangling = {};
};

// Of the rules that the verdict says are broken the first that can be shown: by the vertices and
// segments of the domain alone if that is possible, else by all of it. Error: why there is none,
// for people. Requires: the verdict is about the mesh and this domain, and it fails.
tl::expected<DomainRefutation, std::string> domain_refutation_of(const ExactMesh& mesh,
                                                                 const Domain& domain,
                                                                 const ListedSegments& listed,
                                                                 const Verdict& verdict,
                                                                 const HullFillers& fillers);

// Requires: `vertices` are those of the domain among the points, of which the first are those of
// the mesh; the mesh lists what dangles after its simplices.
std::optional<WholeEvidence> whole_evidence(const ExactMesh& mesh, const Domain& domain,
                                            const ListedSegments& listed, const Verdict& verdict,
                                            const ScaledPoints& points,
                                            const std::vector<Vertex>& vertices,
                                            const HullFillers& fillers);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const DomainRefutation& refutation);

// What proves that a domain in space has no triangulation, or no CDT: of each set of four vertices
// why it is not a simplex of one, and clauses that hold of every triangulation and that nothing
// satisfies. Book: Section 4.5.

// Variables v > 0 and their negations -v.
using Clause = std::vector<int>;

// A clause that follows by unit propagation from others, by their numbers: those of the formula
// count from 1, the steps go on after them.
struct ProofStep {
  Clause clause;
  std::vector<std::size_t> hints;
};

// Values of the variables that satisfy all clauses, or a proof that there are none.
struct Decision {
  std::optional<std::vector<bool>> model = {};
  std::vector<ProofStep> proof = {};
};
// Nothing: it was given up. It need not be trusted.
using Decide = std::function<std::optional<Decision>(int variables, const std::vector<Clause>&)>;

struct Impossibility {
  Claim claim = Claim::kPlcTriangulation;  // of which nothing holds
  DomainKind kind = DomainKind::kEnclosed;
  ScaledPoints points;  // the vertices of the domain
  std::vector<Simplex> segments = {};
  std::vector<HomogeneousPoint> holes = {};
  std::vector<PolygonCertificate> polygons = {};
  DomainCertificate mesh;                 // of the domain: nothing dangles
  std::vector<std::string> fates = {};    // of the candidates, as lines of the file
  std::vector<std::string> reasons = {};  // of the clauses, likewise
  std::vector<ProofStep> steps = {};
};

// For the claims plc-triangulation and cdt. Error: why there is none, for people. Requires: the
// domain is in space.
tl::expected<Impossibility, std::string> impossibility_of(const Domain& domain, Claim claim,
                                                          const ListedSegments& listed,
                                                          const HullFillers& fillers,
                                                          const Decide& decide);

// As proofs/CERTIFICATE.md lays it out.
void write(std::ostream& out, const Impossibility& impossibility);

}  // namespace circumspect::certificate
