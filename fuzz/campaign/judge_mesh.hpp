// Judges the file that a program wrote, and says how the case ended.
#pragma once

#include <string>

#include "fuzz/campaign/input.hpp"
#include "fuzz/campaign/outcome.hpp"

namespace circumspect::campaign {

// Judges the mesh in the file at `path` against the input that the program was given. Files of
// simplices alone (.ele, .qhull-i) are about the points of the input, whatever the program made of
// them; a mesh that lists its points (.off, .mesh, .json) must have exactly those of the input, in
// any order. Meshes of domains are judged by the coordinates that the program wrote.
// Requires: the file is a regular one.
Outcome judged(const Subject& subject, const Input& input, const std::string& path);

// What the program and the campaign take differently, where `judged` found a fault, in words and with what to do: its
// simplices are of another dimension than the inputs; or its indices, counted from another one, make
// a mesh that holds (of points: that is a triangulation). Empty if it is nothing of the kind.
std::string misunderstanding(const Subject& subject, const Input& input, const std::string& path);

// The domain that meshes are held against: the one of the input or, where that may be untidy, its arrangement.
ComplexCase tidy(const Subject& subject, const ComplexCase& whole);

// Are these two meshes of the input, both right, different ones where there is only one right one? Of points: where the
// Delaunay triangulation is unique and one of them is that; of a domain: where the CDT certainly is. Where they
// differ otherwise, false.
struct Comparison {
  bool are_same = false;
  bool is_unique = false;
};
Comparison compared(const Subject& subject, const Input& input, const std::string& one,
                    const std::string& other);

// Can the input be judged at all? Empty, or why it is skipped: it is not made of doubles; the points
// do not span the space, where that is asked for; the domain is invalid or encloses nothing.
// Of a domain in space that may take long.
std::string reason_to_skip(const Subject& subject, const Input& input);

// Do the points, or those of the domain, lie in a hyperplane, or are they too few not to?
bool is_flat(const Subject& subject, const Input& input);

}  // namespace circumspect::campaign
