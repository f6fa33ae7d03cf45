// Finds options with which a mesh of a domain would hold, for the notes under a verdict.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "command/check/within_option.hpp"
#include "command/input/domain_input.hpp"
#include "oracle/judge/known_mesh.hpp"
#include "oracle/judge/within/judge_within.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::cli {

// The verdict for the domain with its cells moved by no more than `distance`. `bent`: the domain
// with polygons joined that are not flat, if it is that one. `markers`: of the mesh and of the
// domain that is judged. `work`: see judge_within. Requires: no equal points.
tl::expected<Verdict, check::NotJudged> judged_within(
    const Distance& distance, Claim claim, const check::KnownMesh& mesh, const Domain& domain,
    const check::Options& options, const BentDomain* bent = nullptr,
    const check::Markers& markers = {}, check::Work* work = nullptr);

// What may have been meant where no domain was given: that triangles in space are a surface or a
// hull, and that what is not convex is a mesh of a domain.
std::vector<std::string> notes_without_domain(const Verdict& verdict, const Mesh& mesh,
                                              const std::string& path);

// Whether the simplices fit together at least, of a mesh that does not fill the hull of its points:
// with how many simplices that is tried is limited. Likewise of a mesh with flat simplices, which
// keep the others from being judged. `alone`: what the claim `complex` says of it, if it was asked.
std::optional<std::string> note_of_complex(const Verdict& verdict, const std::string& path,
                                           const std::optional<Verdict>& alone);

// Polygons that bound nothing, and so are not in a mesh of what is enclosed; none if they are not
// what is missing.
std::optional<std::string> note_of_lone_polygons(const Verdict& verdict,
                                                 const LoadedDomain& domain);

// What a mesh is whose only fault is that it is not constrained Delaunay, which was claimed for it;
// none if that is not all. The rules about balls are asked of triangulations of the domain alone.
std::optional<std::string> note_of_weaker_claim(const Verdict& verdict);

// What was judged, and what the user said of it.
struct Judged {
  Claim claim;
  const check::KnownMesh& mesh;
  const LoadedDomain& domain;
  const std::optional<Distance>& within;          // --within
  bool has_merged;                                // --merge-coplanar
  const std::map<Simplex, Vertex>& face_markers;  // of the mesh
};

// What may be all that keeps the claim from holding: that polygons of one plane are one to the
// program, that coordinates were rounded, or both. With the options that are named the claim holds,
// if it does with any of these.
std::optional<std::string> remedy(const Verdict& verdict, const Judged& judged,
                                  const check::Options& options);

}  // namespace circumspect::cli
