// Mistakes that a dozen points do not show: blocks, counters, tables and keys that are too small.
#include <algorithm>
#include <cstring>
#include <map>
#include <set>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_delaunay.hpp"
#include "reference/delaunay/flip.hpp"

namespace circumspect::faulty {
namespace {

constexpr std::size_t kBlock = 64;

SimplexArray in_whole_blocks(const PointArray& points) {
  std::vector<Vertex> kept = every_index(points);
  if (kept.size() > kBlock) kept.resize(kept.size() / kBlock * kBlock);
  return renumbered(right_answer(selection(points, kept)), kept);
}

// Two simplices of different blocks of the array, with the flip that was never looked at still
// undone.
SimplexArray unflipped_between_blocks(const PointArray& points) {
  const SimplexArray right = right_answer(points);
  const PointSet set = exact_points(points);
  const std::vector<Simplex> simplices(right.begin(), right.end());
  if (set.dimension() < 2 || simplices.size() <= kBlock) return right;
  StarIndex mesh(simplices);
  std::optional<delaunay::ExtendedFlip> undone;
  for (const auto uses : ByFacet(facet_uses(simplices))) {
    if (undone) break;
    if (uses.size() < 2) continue;
    const auto [one, other] = std::pair(uses[0], uses[1]);
    if (one.simplex / kBlock == other.simplex / kBlock) continue;
    const Vertex apex = simplices[other.simplex][other.opposite];
    if (in_ball(set.configuration(), simplices[one.simplex], apex) == 0) continue;
    auto flip =
        delaunay::extended_flip(mesh, delaunay::flip_of_facet(set, mesh, sorted(one.facet)));
    if (flip && flip->deleted.size() == 2) undone = *flip;
  }
  if (!undone) return right;
  mesh.replace(undone->deleted, undone->created);
  return SimplexArray(mesh.simplices().begin(), mesh.simplices().end());
}

// FNV-1a of the bytes of the coordinates, folded to 16 bits.
std::uint32_t hash_of(const PointArray& points, Vertex v) {
  std::uint32_t hash = 0x811c9dc5U;
  for (std::size_t axis = 0; axis < points.dimension; ++axis) {
    unsigned char bytes[sizeof(double)];
    std::memcpy(bytes, points.point(static_cast<std::size_t>(v)) + axis, sizeof bytes);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x01000193U;
  }
  return (hash >> 16) ^ (hash & 0xffff);
}

SimplexArray with_one_point_a_hash(const PointArray& points) {
  std::set<std::uint32_t> seen;
  std::vector<Vertex> kept;
  for (const Vertex v : every_index(points)) {
    if (seen.insert(hash_of(points, v)).second) kept.push_back(v);
  }
  return renumbered(right_answer(selection(points, kept)), kept);
}

SimplexArray with_indices_in_a_byte(const PointArray& points) {
  SimplexArray simplices = right_answer(points);
  for (auto& simplex : simplices) {
    for (auto& v : simplex) v &= 0xff;
  }
  return simplices;
}

// The edge from a to b is number 100a + b of a table, and has room for two triangles.
SimplexArray with_edges_of_a_hundred(const PointArray& points) {
  std::map<std::int64_t, int> triangles_at;
  SimplexArray kept;
  for (auto& row : right_answer(points)) {
    std::vector<std::int64_t> keys;
    for (std::size_t place = 0; row.size() == 3 && place < 3; ++place) {
      const auto [low, high] = std::minmax(row[place], row[(place + 1) % 3]);
      keys.push_back(100 * low + high);
    }
    const auto is_full = [&triangles_at](std::int64_t key) { return triangles_at[key] == 2; };
    if (std::any_of(keys.begin(), keys.end(), is_full)) continue;
    for (const std::int64_t key : keys) ++triangles_at[key];
    kept.push_back(row);
  }
  return kept;
}

SimplexArray in_an_array_of_four_times(const PointArray& points) {
  SimplexArray simplices = right_answer(points);
  simplices.resize(std::min(simplices.size(), 4 * points.size()));
  return simplices;
}

Fault of_many(std::string name, std::string about, std::size_t most_points,
              Triangulator triangulate, std::vector<std::size_t> dimensions = {2, 3}) {
  Fault fault = implementation_fault(std::move(name), std::move(about), std::move(triangulate));
  fault.needs_many = true;
  fault.most_points = most_points;
  fault.dimensions = std::move(dimensions);
  return fault;
}

Fault of_many_by_walk(std::string name, std::string about, Mistakes mistakes) {
  mistakes.search = Search::kWalkThenNeighbors;
  return of_many(std::move(name), std::move(about), 400,
                 [mistakes](const PointArray& points) { return plain_delaunay(points, mistakes); },
                 {2});
}

}  // namespace

std::vector<Fault> size_faults() {
  return {
      of_many("last-block-lost",
              "Points are taken in blocks of 64, and what is left over behind the last whole block "
              "is not: vector code without its remainder.",
              255, in_whole_blocks),
      of_many("blocks-flipped-apart",
              "Simplices are worked on in blocks of 64, and a facet between two blocks is looked "
              "at by neither: threads of a graphics card.",
              255, unflipped_between_blocks),
      of_many_by_walk(
          "stamps-of-eight-bits",
          "Simplices are stamped with the number of the insertion that saw them last, in 8 bits: "
          "after 256 insertions old stamps count as new.",
          {.stamps_in_a_byte = true}),
      of_many_by_walk("walk-of-twenty-steps",
                      "The walk to a new point ends after twenty steps: always enough, in tests.",
                      {.most_steps = 20}),
      of_many_by_walk("three-layers-of-neighbors",
                      "Simplices in conflict are looked for three neighbours deep: a limit on "
                      "recursion that protects the stack.",
                      {.most_layers = 3}),
      of_many("duplicates-by-hash",
              "Points of equal hash, of 16 bits, count as duplicates without being compared.", 600,
              with_one_point_a_hash, {2}),
      of_many("indices-in-a-byte", "Vertices are stored as integers of 8 bits.", 511,
              with_indices_in_a_byte, {2}),
      of_many("edges-of-a-hundred",
              "The edge from a to b has the key 100a + b, for there will not be more than a "
              "hundred points.",
              511, with_edges_of_a_hundred, {2}),
      of_many(
          "room-for-four-times",
          "The array of tetrahedra has room for four a point, which was enough for small examples.",
          127, in_an_array_of_four_times, {3}),
  };
}

}  // namespace circumspect::faulty
