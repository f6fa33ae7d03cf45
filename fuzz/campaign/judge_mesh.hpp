// Judges the file that a program wrote, and says how the case ended.
#pragma once

#include <string>

#include "fuzz/campaign/input.hpp"
#include "fuzz/campaign/outcome.hpp"
#include "fuzz/campaign/subject.hpp"

namespace circumspect::campaign {

// Judges the mesh in the file at `path` against the input that the program was given. Files of
// simplices alone (.ele, .qhull-i) refer to the points of the input, even if the program changed
// its points; a mesh that lists its points (.off, .mesh, .json) must have exactly those of the
// input, in any order. Meshes of domains are judged by the coordinates that the program wrote.
// Requires: the file is a regular one.
Outcome judged(const Subject& subject, const Input& input, const std::string& path);

// If `judged` found a fault: how program and campaign misunderstand each other, in words and with
// advice. Its simplices have another dimension than the inputs, or its indices, counted from
// another first one, give a mesh that holds (for points: that is a triangulation). Empty if neither
// is the case.
std::string misunderstanding(const Subject& subject, const Input& input, const std::string& path);

// The domain that meshes are compared with: the domain of the input or, if that may be untidy, its
// arrangement.
ComplexCase tidy(const Subject& subject, const ComplexCase& whole);

// Do these two correct meshes of the input differ although only one can be right? For points: the
// Delaunay triangulation is unique and one of them is it; for a domain: the CDT is certainly
// unique. False if they differ in another way.
struct Comparison {
  bool are_same = false;
  bool is_unique = false;
};
Comparison compared(const Subject& subject, const Input& input, const std::string& one,
                    const std::string& other);

// Can the input be judged at all? Empty, or why it is skipped: it is not made of doubles; the
// points do not span the space, although that is asked for; the domain is invalid or encloses
// nothing. This may take long for a domain in space.
std::string reason_to_skip(const Subject& subject, const Input& input);

// Do the points, or those of the domain, lie in a hyperplane, perhaps because they are too few?
bool is_flat(const Subject& subject, const Input& input);

}  // namespace circumspect::campaign
