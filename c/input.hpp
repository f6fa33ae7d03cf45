// Converts the structs of <circumspect/circumspect.h> to what is judged and built.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <circumspect/circumspect.h>

#include "c/guard.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::c {

inline constexpr std::int64_t kLargestDimension = 64;

// a·b, if arrays of so many entries can exist: no machine has addresses of more than 57 bits.
// Requires: neither is negative.
std::size_t product(std::int64_t a, std::int64_t b, const char* what);
void require_count(std::int64_t count, const char* what);
void require_dimension(std::int64_t dimension, std::int64_t least, std::int64_t most);

// An array of that many entries; empty if the number is 0, whatever the pointer.
template <class Value>
std::span<const Value> array(const Value* values, std::size_t size, const char* what) {
  if (size == 0) return {};
  return {required(values, what), size};
}

// Appends `count` faces of so many vertices.
void take_faces(const std::int64_t* indices, std::int64_t count, std::int64_t vertices,
                const char* what, std::vector<Simplex>& faces);

// Uses the memory of the arrays if these are doubles. `weighted`: the weights count. All of these
// functions refuse anything that the header does not allow.
Mesh mesh_of(const circumspect_mesh& mesh, bool weighted);

// Its points without its simplices; weights count.
Mesh points_of(const circumspect_mesh* points);

// Refuses a mesh without points and simplices: usually a program wrote nothing.
// `option`: the one with which it is not refused.
void refuse_empty(const Mesh& mesh, const Option& option = {});
// Refuses a mesh that has equal points, which are `repeated`.
void refuse_equal_points(const std::vector<Duplicate>& repeated, const Option& option = {});

// Requires the name of a claim that is, or is not, about a domain, as asked.
Claim claim_of(const char* text, bool has_domain);

// A valid complex, and the part of it that is filled (domain.cpp). `merges`: equal points count as
// one.
Domain domain_of(const circumspect_domain& domain, bool merges = false);

// Points by either array.
std::vector<Point> exact_points(std::int64_t count, std::int64_t dimension, const double* doubles,
                                const char* const* texts);

}  // namespace circumspect::c
