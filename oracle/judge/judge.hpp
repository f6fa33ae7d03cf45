// The judge of meshes, for files, arrays, campaigns and harnesses.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

class KnownMesh;  // known_mesh.hpp

// Why a mesh could not be judged: it has points that are equal (see mesh.hpp).
struct EqualPoints {
  std::vector<Duplicate> repeated;
};

// Does the claim hold of the mesh? By lemma, the fast engine (oracle/judge/fast) is asked first if
// coordinates (and weights, if they count) are doubles, simplices are in rows, and d is 2 or 3. It
// says that the claim holds, or lists what is at fault, which is then looked at again, exactly. For
// a mesh of a domain it decides what takes linear time. The exact checkers judge everything else.
// The verdict is the same whoever finds it; Verdict::course tells who did.
//
// Equal points are an error, unless the claim is found to hold, or to fail by facets alone that are
// not locally Delaunay: then there are none. So nobody has to sort the points of a large mesh that
// holds. For the claim `complex` they break a rule, and count as one for the rest.
// Requires: `domain` if and only if the claim is about one; a valid domain (validity.hpp), and a
// mesh without points or with points of its dimension. No weights for `delaunay` and for claims
// about a domain.
tl::expected<Verdict, EqualPoints> judge(Claim claim, const Mesh& mesh,
                                         const Domain* domain = nullptr,
                                         const Options& options = {});

// The same of a claim about a domain and a mesh of which something is known already. Requires: what
// is known was asked for this claim, domains of this kind and these options.
Verdict judge(Claim claim, const KnownMesh& mesh, const Domain& domain, const Options& options);

// A mesh whose equal points count as one: they are merged if there are any, and added to `merged`.
struct Merging {
  Mesh& mesh;
  std::vector<Duplicate>* merged = nullptr;
};
Verdict judge(Claim claim, Merging merging, const Domain* domain = nullptr,
              const Options& options = {});

}  // namespace circumspect::check
