// Lawson's algorithm, from a lexicographic triangulation, given up too early. Book: Section 4.4.
#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_delaunay.hpp"
#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/lexicographic.hpp"

namespace circumspect::faulty {
namespace {

using delaunay::ExtendedFlip;

SimplexArray rows_of(const StarIndex& mesh) {
  return SimplexArray(mesh.simplices().begin(), mesh.simplices().end());
}

// Passes over the facets until nothing changes, or as many as allowed; `knows` says which flips the
// program has.
template <typename Knows>
SimplexArray flipped(const PointArray& points, std::size_t most_passes, const Knows& knows) {
  const PointSet set = exact_points(points);
  if (set.dimension() < 2) return right_answer(points);
  StarIndex mesh(delaunay::lexicographic(set).simplices());
  bool changed = true;
  for (std::size_t pass = 0; pass < most_passes && changed; ++pass) {
    changed = false;
    const std::vector<Simplex> now(mesh.simplices().begin(), mesh.simplices().end());
    for (const Simplex& facet : facets_of(now)) {
      if (delaunay::is_locally_delaunay(set, mesh, facet, delaunay::FlipTest::kUnperturbed))
        continue;
      const auto flip = delaunay::extended_flip(mesh, delaunay::flip_of_facet(set, mesh, facet));
      if (!flip || !knows(*flip)) continue;
      mesh.replace(flip->deleted, flip->created);
      changed = true;
    }
  }
  return rows_of(mesh);
}

std::vector<Simplex> ascending(const SimplexArray& rows) {
  std::vector<Simplex> simplices;
  for (const auto& row : rows) simplices.push_back(sorted({row.begin(), row.end()}));
  return simplices;
}

// All points are inserted first, each by splitting the simplices that contain it or by joining it to
// the hull facets that it sees. Then come the flips.
SimplexArray inserted_in_bulk(const PointArray& points) {
  const PointSet set = exact_points(points);
  if (set.dimension() < 2) return right_answer(points);
  const SimplexArray start = plain_delaunay(points, {.only_splits = true});
  const Triangulation flipped =
      delaunay::flip_algorithm(set, Triangulation(set.dimension(), ascending(start))).triangulation;
  return rows_of(StarIndex(flipped.simplices()));
}

bool any_flip(const ExtendedFlip&) { return true; }

constexpr std::size_t kUntilDone = 1000;
constexpr std::size_t kEnoughToGetStuck = 40;

Fault by(std::string name, std::string about, std::vector<std::size_t> dimensions,
         Triangulator triangulate) {
  Fault fault{std::move(name), std::move(about), Kind::kImplementation, Claim::kDelaunay,
              std::move(triangulate)};
  fault.dimensions = std::move(dimensions);
  return fault;
}

}  // namespace

std::vector<Fault> flip_faults() {
  Fault stuck =
      by("stuck-flips-returned",
         "Inserts all points, then flips until no flip is possible, and returns what there "
         "is: in space Lawson's algorithm can get stuck, and does so if it has not been "
         "run after every single insertion. Insertion in bulk, on graphics cards.",
         {3}, inserted_in_bulk);
  stuck.most_points = kEnoughToGetStuck;
  return {
      by("flips-in-one-pass",
         "Looks at each edge or triangle once, and not again after its neighbours were flipped: "
         "swapping as a post-process.",
         {2, 3}, [](const PointArray& points) { return flipped(points, 1, any_flip); }),
      by("flips-2-3-only",
         "Knows the flip that replaces two tetrahedra by three and not its reverse.", {3},
         [](const PointArray& points) {
           return flipped(points, kUntilDone,
                          [](const ExtendedFlip& flip) { return flip.name() == "2-3"; });
         }),
      stuck,
      by("no-flips-of-four-to-four",
         "Knows the flips of generic points alone: edges of four coplanar vertices stay blocked.",
         {3},
         [](const PointArray& points) {
           return flipped(points, kUntilDone, [](const ExtendedFlip& flip) {
             return flip.name() == "2-3" || flip.name() == "3-2";
           });
         }),
  };
}

}  // namespace circumspect::faulty
