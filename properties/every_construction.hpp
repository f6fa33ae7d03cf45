// Every construction of the canonical Delaunay triangulation, with every option, for holding them
// equal. A new algorithm is one line here.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "construct/delaunay.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/flip_insertion.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/gift_wrapping_cells.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {

struct NamedConstruction {
  std::string name;
  std::function<Triangulation(const PointSet&)> construct;
};

// Bowyer–Watson in each order with each point location; `seed` is that of the random orders.
inline std::vector<NamedConstruction> insertions(std::uint64_t seed) {
  using delaunay::InsertionOrder;
  using delaunay::PointLocation;
  std::vector<NamedConstruction> all;
  for (const InsertionOrder order : {InsertionOrder::kAsGiven, InsertionOrder::kRandom,
                                     InsertionOrder::kBrioHilbert, InsertionOrder::kBrioZOrder}) {
    for (const PointLocation location :
         {PointLocation::kLinearScan, PointLocation::kConflictGraph, PointLocation::kWalking}) {
      all.push_back({"Bowyer-Watson, order " + std::to_string(static_cast<int>(order)) +
                         ", location " + std::to_string(static_cast<int>(location)),
                     [=](const PointSet& points) {
                       return delaunay::bowyer_watson(points, {order, location, seed});
                     }});
    }
  }
  return all;
}

// Does the fast construction make the book's triangulation, and know whether it is the only one?
// Nothing if it leaves the points to the book.
inline std::optional<bool> fast_agrees(const PointSet& points) {
  const auto fast = construct::canonical_delaunay(points);
  if (!fast) return std::nullopt;
  const Triangulation expected = delaunay::bowyer_watson(points);
  const bool knows_if_unique =
      points.is_weighted() ||
      fast->is_unique == !delaunay::cospherical_points_of_an_empty_ball(points, expected);
  bool is_oriented = true;
  for (std::size_t i = 0; i < fast->simplices.rows(); ++i) {
    const auto row = fast->simplices.row(i);
    is_oriented &= orientation(points.configuration(), Simplex(row.begin(), row.end())) > 0;
  }
  return fast->triangulation() == expected && knows_if_unique && is_oriented;
}

// The fast construction; where it leaves an answer to the book, the book's.
inline Triangulation fast_or_by_the_book(const PointSet& points) {
  const auto fast = construct::canonical_delaunay(points);
  return fast ? fast->triangulation() : delaunay::bowyer_watson(points);
}

inline std::vector<NamedConstruction> every_construction(std::uint64_t seed) {
  std::vector<NamedConstruction> all = insertions(seed);
  all.push_back({"fast", fast_or_by_the_book});
  all.push_back({"gift-wrapping", [](const PointSet& p) { return delaunay::gift_wrapping(p); }});
  all.push_back({"gift-wrapping by cells", delaunay::gift_wrapping_by_cells});
  all.push_back({"lifted hull", [](const PointSet& p) { return delaunay::lifted_hull(p); }});
  all.push_back({"lifted hull by definition", delaunay::lifted_hull_by_definition});
  all.push_back(
      {"insertion by flips", [](const PointSet& p) { return delaunay::flip_insertion(p); }});
  return all;
}

}  // namespace circumspect::properties
