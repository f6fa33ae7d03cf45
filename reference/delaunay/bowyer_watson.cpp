#include "reference/delaunay/bowyer_watson.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "reference/delaunay/conflict_graph.hpp"
#include "reference/delaunay/point_location.hpp"

namespace circumspect::delaunay {
namespace {

Simplex affine_basis(const PointSet& points) {
  Simplex basis;
  for (const std::size_t v : points.configuration().hull().basis) {
    basis.push_back(static_cast<Vertex>(v));
  }
  return basis;
}

}  // namespace

Simplex first_independent(const PointSet& points, const std::vector<Vertex>& sequence) {
  const auto wanted = static_cast<std::size_t>(points.dimension() + 1);
  Simplex basis;
  // Mostly they are in front; prefixes of the sequence, twice as long each time, find them wherever
  // they are.
  for (std::size_t length = wanted; basis.size() < wanted; length = 2 * length) {
    const Simplex beginning(
        sequence.begin(),
        sequence.begin() + static_cast<std::ptrdiff_t>(std::min(length, sequence.size())));
    basis.clear();
    for (const std::size_t place : affine_hull(coordinates(points, beginning)).basis) {
      basis.push_back(beginning[place]);
    }
  }
  return basis;
}

BowyerWatson::BowyerWatson(const PointSet& points) : BowyerWatson(points, affine_basis(points)) {}

BowyerWatson::BowyerWatson(const PointSet& points, const Simplex& first_simplex,
                           ConflictTest conflict_test)
    : points_(points),
      conflict_test_(conflict_test),
      first_simplex_(positively_oriented(points, first_simplex)) {
  add(first_simplex_);
  for (std::size_t place = 0; place < first_simplex_.size(); ++place) {
    add(join(OrientedFacet::opposite(first_simplex_, place).reverse(), kGhost));
  }
}

bool BowyerWatson::insert(Vertex u) {
  const std::optional<Simplex> located =
      dictionary_.find([&](const Simplex& simplex) { return is_conflict(simplex, u); });
  if (located) insert(u, *located);
  return located.has_value();
}

const Insertion& BowyerWatson::insert(Vertex u, const Simplex& in_conflict) {
  last_insertion_.vertex = u;
  last_insertion_.deleted.clear();
  last_insertion_.created.clear();
  for (std::size_t place = 0; place < in_conflict.size(); ++place) {
    facets_to_pass_.push_back(OrientedFacet::opposite(in_conflict, place));
  }
  remove(in_conflict);
  dig_cavity(u);
  return last_insertion_;
}

bool BowyerWatson::is_conflict(const Simplex& simplex, Vertex u) {
  ++statistics_.conflict_tests;
  return conflict_test_(points_, simplex, u);
}

// DigCavity3D. The facets to pass have a deleted simplex, and so u, in front. The book recurses; a
// stack of facets visits them in the same depth-first order and does not overflow on large
// cavities.
void BowyerWatson::dig_cavity(Vertex u) {
  while (!facets_to_pass_.empty()) {
    const OrientedFacet facet = std::move(facets_to_pass_.back());
    facets_to_pass_.pop_back();
    const OrientedFacet reverse = facet.reverse();
    const std::optional<Vertex> z = dictionary_.adjacent(reverse);
    if (!z) continue;  // Step 4: the simplex has already been deleted.
    const Simplex beyond = join(reverse, *z);
    if (is_conflict(beyond, u)) {
      for (std::size_t place = 0; place < beyond.size(); ++place) {
        if (beyond[place] != *z) facets_to_pass_.push_back(OrientedFacet::opposite(beyond, place));
      }
      remove(beyond);
    } else {
      add(join(facet, u));  // Step 6: a facet of the star-shaped cavity.
    }
  }
}

void BowyerWatson::add(Simplex simplex) {
  dictionary_.add(simplex);
  if (is_ghost(simplex)) {
    ++statistics_.ghost_simplices_created;
  } else {
    ++statistics_.solid_simplices_created;
    most_recent_solid_ = simplex;
  }
  last_insertion_.created.push_back(std::move(simplex));
}

void BowyerWatson::remove(const Simplex& simplex) {
  dictionary_.remove(simplex);
  ++(is_ghost(simplex) ? statistics_.ghost_simplices_deleted : statistics_.solid_simplices_deleted);
  last_insertion_.deleted.push_back(simplex);
}

Triangulation BowyerWatson::triangulation() const {
  std::vector<Simplex> solid;
  for (const Simplex& simplex : dictionary_.simplices()) {
    if (!is_ghost(simplex)) solid.push_back(simplex);
  }
  return Triangulation(points_.dimension(), std::move(solid));
}

namespace {

const Insertion& told(const BowyerWatsonOptions& options, const Insertion& insertion) {
  if (options.watch) options.watch(insertion);
  return insertion;
}

// Inserts the vertices one by one; `locate` finds a simplex in conflict with each, or nothing.
template <typename Locate>
void insert_all(BowyerWatson& algorithm, const std::vector<Vertex>& vertices,
                const BowyerWatsonOptions& options, Locate locate) {
  std::size_t done = 0;
  for (const Vertex u : vertices) {
    tell(options.progress, "points inserted", done++, vertices.size());
    if (const std::optional<Simplex> located = locate(u)) {
      told(options, algorithm.insert(u, *located));
    }
  }
}

void insert_all(const PointSet& points, BowyerWatson& algorithm,
                const std::vector<Vertex>& vertices, const BowyerWatsonOptions& options) {
  Statistics& statistics = algorithm.statistics();
  const SimplexDictionary& dictionary = algorithm.dictionary();
  if (options.location == PointLocation::kLinearScan) {
    insert_all(algorithm, vertices, options,
               [&](Vertex u) { return linear_scan(points, dictionary, u, statistics); });
  } else if (options.location == PointLocation::kWalking) {
    insert_all(algorithm, vertices, options, [&](Vertex u) {
      return walk(points, dictionary, algorithm.most_recent_solid(), u, statistics);
    });
  } else {
    ConflictGraph graph(points, dictionary, vertices, statistics);
    for (const Vertex u : vertices) {
      const std::optional<Simplex> located = graph.conflict_of(u);
      if (located) graph.update(told(options, algorithm.insert(u, *located)));
    }
  }
}

}  // namespace

Triangulation bowyer_watson(const PointSet& points, const BowyerWatsonOptions& options,
                            Statistics* statistics) {
  if (points.empty()) return Triangulation(-1, {});
  if (points.dimension() == 0) return Triangulation(0, {{0}});
  std::vector<Vertex> sequence = insertion_order(points, options.order, options.seed);
  BowyerWatson algorithm(points, first_independent(points, sequence));
  std::erase_if(sequence, [&](Vertex u) { return contains(algorithm.first_simplex(), u); });
  told(options, algorithm.last_insertion());
  insert_all(points, algorithm, sequence, options);
  if (statistics != nullptr) *statistics = algorithm.statistics();
  return algorithm.triangulation();
}

Triangulation bowyer_watson(const PointSet& points) { return bowyer_watson(points, {}); }

}  // namespace circumspect::delaunay
