// How all fuzz targets read their bytes: the first few select what is done, and the others make
// points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <circumspect/fuzz.hpp>

#include "fuzz/harness/cases.hpp"
#include "oracle/judge/arrays/mesh_of.hpp"

namespace circumspect::fuzz {

using Bytes = std::span<const std::uint8_t>;

// The head, and the points that the rest stands for. Missing bytes are 0.
template <std::size_t kHead>
struct Input {
  std::array<std::uint8_t, kHead> head{};
  PointArray points{};

  Input(Bytes bytes, std::size_t most_points) {
    const std::size_t taken = std::min(kHead, bytes.size());
    std::copy_n(bytes.begin(), taken, head.begin());
    constexpr std::size_t kStep = 5;  // bytes a point, see circumspect/fuzz.hpp
    const std::size_t rest = std::min(bytes.size() - taken, kStep * most_points);
    points = points_from_bytes(bytes.data() + taken, rest, dimension(), is_weighted());
  }
  std::size_t dimension() const { return 2 + (head[0] & 1); }
  bool is_weighted() const { return (head[0] & 2) != 0; }
};

// Changes a byte of the head, or the recipe behind it.
inline std::size_t mutate(std::size_t head, std::uint8_t* data, std::size_t size,
                          std::size_t max_size, unsigned int seed) {
  if (max_size <= head) return size;
  if (size < head) {
    std::fill(data + size, data + head, std::uint8_t{0});
    size = head;
  }
  if (seed % 4 == 0) {
    data[(seed / 4) % head] = static_cast<std::uint8_t>(seed >> 16);
    return size;
  }
  return head + mutate_bytes(data + head, size - head, max_size - head, seed);
}

// The list of simplices changed as three bytes say: dropped, listed twice, an index replaced, two
// exchanged.
inline void alter(std::vector<Simplex>& simplices, std::size_t points, Bytes how) {
  if (simplices.empty() || points == 0) return;
  const std::size_t at = how[1] % simplices.size();
  Simplex& simplex = simplices[at];
  Vertex& v = simplex[how[2] % simplex.size()];
  switch (how[0] % 6) {
    case 0:
      return;
    case 1:
      simplices.erase(simplices.begin() + static_cast<std::ptrdiff_t>(at));
      return;
    case 2:
      simplices.push_back(Simplex(simplex.rbegin(), simplex.rend()));
      return;
    case 3:
      // Now and then one that names no point.
      v = static_cast<Vertex>(how[0] / 6u % (points + 2)) - 1;
      return;
    case 4:
      v = static_cast<Vertex>(how[0] / 6u % points);
      return;
    default: {
      Simplex& other = simplices[how[0] / 6u % simplices.size()];
      std::swap(v, other[how[2] / 8u % other.size()]);
    }
  }
}

[[noreturn]] inline void fail(const std::string& what, const PointArray& points,
                              const std::vector<Simplex>& simplices = {}) {
  std::fprintf(stderr, "%s on\n%s", what.c_str(), harness::node_text(points).c_str());
  for (const Simplex& simplex : simplices) {
    for (const Vertex v : simplex) std::fprintf(stderr, "%td ", v);
    std::fprintf(stderr, "\n");
  }
  std::abort();
}

}  // namespace circumspect::fuzz

// The mutator of a target whose inputs begin with a head of so many bytes.
#define CIRCUMSPECT_MUTATOR(head)                                                           \
  extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,      \
                                                 std::size_t max_size, unsigned int seed) { \
    return ::circumspect::fuzz::mutate(head, data, size, max_size, seed);                   \
  }                                                                                         \
  static_assert(true)
