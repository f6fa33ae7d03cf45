// Incremental insertion that is wrong though its predicates are exact.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/exact/each_once.hpp"
#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_delaunay.hpp"
#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/flip_algorithm.hpp"
#include "reference/delaunay/lexicographic.hpp"

namespace circumspect::faulty {
namespace {

Fault inserting_with(std::string name, std::string about, const Mistakes& mistakes,
                     std::size_t most_points = 12) {
  Fault fault = implementation_fault(
      std::move(name), std::move(about),
      [mistakes](const PointArray& points) { return plain_delaunay(points, mistakes); });
  fault.most_points = most_points;
  return fault;
}

double largest_extent(const PointArray& points) {
  double largest = 0;
  for (std::size_t axis = 0; axis < points.dimension; ++axis) {
    const auto [low, high] = extent(points, axis);
    largest = std::max(largest, high - low);
  }
  return largest;
}

// Triangulates the points with further ones behind them, then takes away what has any of those.
SimplexArray without_extra_points(const PointArray& points, const std::vector<double>& extra) {
  if (!std::all_of(extra.begin(), extra.end(), [](double x) { return std::isfinite(x); })) {
    return right_answer(points);
  }
  PointArray more = points;
  more.coordinates.insert(more.coordinates.end(), extra.begin(), extra.end());
  SimplexArray simplices = right_answer(more);
  std::erase_if(simplices, [&points](const auto& simplex) {
    return std::any_of(simplex.begin(), simplex.end(), [&points](std::int64_t v) {
      return v >= static_cast<std::int64_t>(points.size());
    });
  });
  return simplices;
}

// Corner i of the simplex lies `factor` extents from the middle of the points.
SimplexArray within_a_super_simplex(const PointArray& points, double factor) {
  if (exact_points(points).dimension() < static_cast<int>(points.dimension)) {
    return right_answer(points);
  }
  const double size = factor * largest_extent(points);
  std::vector<double> corners;
  for (std::size_t corner = 0; corner <= points.dimension; ++corner) {
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      const auto [low, high] = extent(points, axis);
      const double side = corner == axis ? static_cast<double>(points.dimension) : -1.0;
      corners.push_back(low / 2 + high / 2 + side * size);
    }
  }
  return without_extra_points(points, corners);
}

// A point beyond all others, whose star is removed and not filled again.
SimplexArray after_a_deletion_at_the_hull(const PointArray& points) {
  if (exact_points(points).dimension() < static_cast<int>(points.dimension)) {
    return right_answer(points);
  }
  std::vector<double> corner;
  for (std::size_t axis = 0; axis < points.dimension; ++axis) {
    const double high = extent(points, axis).second;
    corner.push_back(std::max(high + largest_extent(points) / 4,
                              std::nextafter(high, std::numeric_limits<double>::max())));
  }
  return without_extra_points(points, corner);
}

// Two halves by the first coordinate; those in `overlap` of the middle belong to both.
SimplexArray in_two_halves(const PointArray& points, std::size_t overlap) {
  std::vector<Vertex> order = every_index(points);
  std::stable_sort(order.begin(), order.end(), [&points](Vertex a, Vertex b) {
    return points.point(static_cast<std::size_t>(a))[0] <
           points.point(static_cast<std::size_t>(b))[0];
  });
  const std::size_t middle = order.size() / 2;
  const std::size_t from = middle - std::min(middle, overlap);
  const std::size_t to = std::min(order.size(), middle + overlap);
  const auto at = [&order](std::size_t i) { return order.begin() + static_cast<Vertex>(i); };
  SimplexArray both;
  for (const auto& half :
       {std::vector<Vertex>(at(0), at(to)), std::vector<Vertex>(at(from), at(order.size()))}) {
    const PointArray part = selection(points, half);
    if (exact_points(part).dimension() != exact_points(points).dimension()) {
      return right_answer(points);
    }
    for (auto& simplex : renumbered(right_answer(part), half)) {
      std::sort(simplex.begin(), simplex.end());
      both.push_back(std::move(simplex));
    }
  }
  keep_each_once(both);
  return both;
}

}  // namespace

std::vector<Fault> insertion_faults() {
  return {
      inserting_with(
          "no-ghosts",
          "No simplices on the outside: points outside the hull so far are lost. Bowyer–Watson "
          "from a description that leaves the outside to the reader.",
          {.no_ghosts = true}),
      inserting_with(
          "coplanar-points-outside-forgotten",
          "A ghost only conflicts with points strictly beyond its facet, not with those in its "
          "plane and circumcircle: flat simplices on the hull.",
          {.ghosts_forget_their_plane = true}),
      inserting_with(
          "coplanar-points-all-in-conflict",
          "A ghost conflicts with every point in the plane of its facet, near or far: `>= 0` in "
          "the visibility test of the hull.",
          {.ghosts_take_their_plane = true}),
      inserting_with(
          "walk-stops-early",
          "The walk to a new point ends after three steps and takes where it is for the simplex "
          "that contains the point: a guard against endless walks.",
          {.search = Search::kWalkThenNeighbors, .most_steps = 3}),
      inserting_with(
          "cavity-one-layer-deep",
          "Of the simplices in conflict only the one with the point and its neighbours are "
          "deleted: recursion that was unrolled once.",
          {.search = Search::kWalkThenNeighbors, .most_layers = 1}),
      implementation_fault(
          "super-simplex-too-small",
          "Starts with a simplex 10 times as large as the points and removes its vertices at the "
          "end: near the hull, large circumballs had held one. All over the web.",
          [](const PointArray& points) { return within_a_super_simplex(points, 10); }),
      implementation_fault(
          "super-simplex-1e6", "The same, 1,000,000 times as large: rarer, not gone.",
          [](const PointArray& points) { return within_a_super_simplex(points, 1e6); }),
      implementation_fault(
          "hull-not-convex-after-deletion",
          "A vertex of the hull is deleted with its star, and the pocket that it leaves is not "
          "filled: dynamic structures that treat only interior vertices.",
          after_a_deletion_at_the_hull),
      implementation_fault(
          "halves-not-joined",
          "The halves of the points are triangulated apart and nothing is put between them: "
          "divide and conquer, or tiles in parallel, before the merge is written.",
          [](const PointArray& points) { return in_two_halves(points, 0); }),
      inserting_with(
          "first-simplex-as-it-comes",
          "The first d + 1 points are taken for a positively oriented simplex, in whatever order "
          "they come.",
          {.first_as_it_comes = true}),
      inserting_with(
          "queue-of-six",
          "The search for the simplices in conflict keeps those yet to be looked at in an array of "
          "six, and drops what does not fit.",
          {.search = Search::kWalkThenNeighbors, .most_waiting = 6}, 40),
      implementation_fault("gives-up-on-a-flat-start",
                           "If the first d + 1 points lie in a hyperplane there is nothing to "
                           "begin with, and nothing "
                           "is returned.",
                           [](const PointArray& points) {
                             const std::size_t few = points.dimension + 1;
                             if (points.size() <= few) return right_answer(points);
                             std::vector<Vertex> first = every_index(points);
                             first.resize(few);
                             const PointSet start = exact_points(selection(points, first));
                             return start.dimension() < static_cast<int>(points.dimension)
                                        ? SimplexArray{}
                                        : right_answer(points);
                           }),
      implementation_fault(
          "flat-sets-give-nothing",
          "Points of a line, or in space of a plane, give no simplices instead of those of that "
          "line or plane.",
          [](const PointArray& points) {
            const bool is_flat =
                exact_points(points).dimension() < static_cast<int>(points.dimension);
            return is_flat ? SimplexArray{} : right_answer(points);
          }),
      implementation_fault("tiles-overlap",
                           "Two tiles share some points, equal simplices are unified, and what the "
                           "tiles disagree on "
                           "is kept twice: parallel triangulation with a halo.",
                           [](const PointArray& points) { return in_two_halves(points, 2); }),
  };
}

// Lawson's algorithm, from a lexicographic triangulation, given up too early. Book: Section 4.4.

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

// All points are inserted first, each by splitting the simplices that contain it or by joining it
// to the hull facets that it sees. Then come the flips.
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
      by("flips-in-three-passes",
         "The same, three times over: enough for the example that it was tried on.", {2, 3},
         [](const PointArray& points) { return flipped(points, 3, any_flip); }),
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
