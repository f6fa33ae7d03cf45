// Every construction of the canonical (weighted) Delaunay triangulation equals the one by
// definition. Book: Sections 5.2 to 5.5. Input: a byte with dimension (bit 0) and weights (bit 1),
// then points.
#include "fuzz/targets/fuzz_bytes.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/flip_algorithm.hpp"
#include "reference/delaunay/flip_insertion.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/gift_wrapping_cells.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::fuzz {
namespace {

constexpr std::size_t kHead = 1;
constexpr std::size_t kMostPoints = 9;

void hold_constructions_equal(Bytes bytes) {
  const Input<kHead> input(bytes, kMostPoints);
  if (input.points.size() == 0) return;
  const PointSet points = arrays::exact_mesh_of(input.points, {}, input.is_weighted()).points;
  const Triangulation expected = delaunay::by_definition(points);
  const auto expect = [&](const char* name, const Triangulation& found) {
    if (found != expected) fail(std::string(name) + " differs", input.points, found.simplices());
  };
  using delaunay::InsertionOrder;
  using delaunay::PointLocation;
  for (const PointLocation location :
       {PointLocation::kLinearScan, PointLocation::kConflictGraph, PointLocation::kWalking}) {
    expect("Bowyer-Watson as given",
           delaunay::bowyer_watson(points, {InsertionOrder::kAsGiven, location, 0}));
    expect("Bowyer-Watson by BRIO",
           delaunay::bowyer_watson(points, {InsertionOrder::kBrioHilbert, location, 1}));
  }
  expect("gift-wrapping", delaunay::gift_wrapping(points));
  expect("gift-wrapping by cells", delaunay::gift_wrapping_by_cells(points));
  expect("lifted hull", delaunay::lifted_hull(points));
  expect("insertion by flips", delaunay::flip_insertion(points));
}

}  // namespace
}  // namespace circumspect::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  circumspect::fuzz::hold_constructions_equal({data, size});
  return 0;
}
CIRCUMSPECT_MUTATOR(circumspect::fuzz::kHead);
