// Constructions of Delaunay triangulations that are compared: one line each.
#include <functional>
#include <vector>

#include "bench/tables.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/flip_insertion.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/gift_wrapping_cells.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::bench {
namespace {

using delaunay::InsertionOrder;
using delaunay::PointLocation;

std::function<Triangulation(const PointSet&)> bowyer_watson(InsertionOrder order,
                                                            PointLocation location) {
  return [=](const PointSet& points) {
    return delaunay::bowyer_watson(points, {.order = order, .location = location, .seed = 1});
  };
}

}  // namespace

const std::vector<Algorithm>& algorithms() {
  static const std::vector<Algorithm> table = {
      {"Bowyer-Watson, BRIO (Hilbert), walking",
       bowyer_watson(InsertionOrder::kBrioHilbert, PointLocation::kWalking),
       {1000, 10000, 100000},
       60},
      {"Bowyer-Watson, BRIO (z-order), walking",
       bowyer_watson(InsertionOrder::kBrioZOrder, PointLocation::kWalking),
       {1000, 10000, 100000}},
      {"Bowyer-Watson, random order, walking",
       bowyer_watson(InsertionOrder::kRandom, PointLocation::kWalking),
       {1000, 10000}},
      {"Bowyer-Watson, random order, conflict graph",
       bowyer_watson(InsertionOrder::kRandom, PointLocation::kConflictGraph),
       {1000, 10000},
       30},
      {"Bowyer-Watson, BRIO (Hilbert), conflict graph",
       bowyer_watson(InsertionOrder::kBrioHilbert, PointLocation::kConflictGraph),
       {1000, 10000},
       30},
      {"Bowyer-Watson, as given, linear scan",
       bowyer_watson(InsertionOrder::kAsGiven, PointLocation::kLinearScan),
       {100, 1000}},
      {"flips, vertex by vertex",
       [](const PointSet& points) { return delaunay::flip_insertion(points); },
       {30, 100}},
      {"gift-wrapping",
       [](const PointSet& points) { return delaunay::gift_wrapping(points); },
       {100, 300},
       10},
      {"gift-wrapping by whole cells", delaunay::gift_wrapping_by_cells, {100, 300}, 10},
      {"lifted hull",
       [](const PointSet& points) { return delaunay::lifted_hull(points); },
       {100, 300},
       10},
      {"lifted hull, by definition", delaunay::lifted_hull_by_definition, {15, 30}},
      {"by definition", delaunay::by_definition, {15, 30}},
  };
  return table;
}

}  // namespace circumspect::bench
