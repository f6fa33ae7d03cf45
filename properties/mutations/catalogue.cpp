#include "properties/mutations/catalogue.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace circumspect::properties {

std::vector<Mutation> catalogue() {
  std::vector<Mutation> all;
  for (const auto& part : {index_mutations(), facet_mutations(), cover_mutations(),
                           link_mutations(), point_mutations()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

// ---- Index mutations ----

namespace {

using enum Rule;

const std::set<Rule> kAnyOfSimplices = {
    kRepeatedVertex, kDegenerateSimplex, kDuplicateSimplex, kUnusedPoint,  kFacetOverused,
    kOverlap,        kHullNotClosed,     kHullNotConvex,    kCoveredTwice, kPointBelowPlane};

std::int64_t any_vertex(const ArrayMesh& mesh, Dice& dice) {
  return static_cast<std::int64_t>(dice.below(mesh.points()));
}

bool name_no_point(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& v = mesh.simplices[dice.below(mesh.simplices.size())];
  const auto points = static_cast<std::int64_t>(mesh.points());
  constexpr std::int64_t kWord = std::int64_t{1}
                                 << 32;  // what is left of these in 32 bits names one
  const std::array choices{std::int64_t{-1},
                           points,
                           -points,
                           v + kWord,
                           v - kWord,
                           v + kWord / 2,
                           std::int64_t{std::numeric_limits<std::int32_t>::max()},
                           std::numeric_limits<std::int64_t>::max(),
                           std::numeric_limits<std::int64_t>::min()};
  v = choices[dice.below(choices.size())];
  mesh.neighbors.clear();
  return true;
}

bool repeat_vertex(ArrayMesh& mesh, Dice& dice) {
  const auto row = mesh.row(dice.below(mesh.size()));
  const std::size_t place = dice.below(row.size());
  row[place] = row[(place + 1 + dice.below(row.size() - 1)) % row.size()];
  mesh.neighbors.clear();
  return true;
}

bool change_index(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& v = mesh.simplices[dice.below(mesh.simplices.size())];
  const std::int64_t other = any_vertex(mesh, dice);
  if (other == v) return false;
  v = other;
  mesh.neighbors.clear();
  return true;
}

bool replace_simplex(ArrayMesh& mesh, Dice& dice) {
  const auto row = mesh.row(dice.below(mesh.size()));
  std::vector<std::int64_t> old(row.begin(), row.end());
  for (std::int64_t& v : row) v = any_vertex(mesh, dice);
  mesh.neighbors.clear();
  return !std::is_permutation(old.begin(), old.end(), row.begin());
}

bool merge_vertices(ArrayMesh& mesh, Dice& dice) {
  const std::int64_t gone = mesh.simplices[dice.below(mesh.simplices.size())];
  const std::int64_t kept = any_vertex(mesh, dice);
  std::replace(mesh.simplices.begin(), mesh.simplices.end(), gone, kept);
  mesh.neighbors.clear();
  return gone != kept;
}

bool exchange_everywhere(ArrayMesh& mesh, Dice& dice) {
  const std::int64_t a = any_vertex(mesh, dice), b = any_vertex(mesh, dice);
  for (std::int64_t& v : mesh.simplices) v = v == a ? b : v == b ? a : v;
  mesh.neighbors.clear();
  return a != b;
}

bool exchange_between_two(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& a = mesh.simplices[dice.below(mesh.simplices.size())];
  std::int64_t& b = mesh.simplices[dice.below(mesh.simplices.size())];
  std::swap(a, b);
  mesh.neighbors.clear();
  return a != b;
}

bool drop_simplex(ArrayMesh& mesh, Dice& dice) {
  const auto begin =
      mesh.simplices.begin() + static_cast<std::ptrdiff_t>(dice.below(mesh.size()) * mesh.width());
  mesh.simplices.erase(begin, begin + static_cast<std::ptrdiff_t>(mesh.width()));
  mesh.neighbors.clear();
  return true;
}

bool list_twice(ArrayMesh& mesh, Dice& dice) {
  const auto row = mesh.row(dice.below(mesh.size()));
  std::vector<std::int64_t> again(row.begin(), row.end());
  std::shuffle(again.begin(), again.end(), dice.engine());
  const auto place = static_cast<std::ptrdiff_t>(dice.below(mesh.size() + 1) * mesh.width());
  mesh.simplices.insert(mesh.simplices.begin() + place, again.begin(), again.end());
  mesh.neighbors.clear();
  return true;
}

bool permute_rows(ArrayMesh& mesh, Dice& dice) {
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    const auto row = mesh.row(s);
    std::shuffle(row.begin(), row.end(), dice.engine());
  }
  mesh.neighbors.clear();
  return true;
}

// Both lists, so that the links stay right.
bool swap_two_places(ArrayMesh& mesh, Dice& dice) {
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    const std::size_t a = dice.below(mesh.width()), b = dice.below(mesh.width());
    std::swap(mesh.simplices[s * mesh.width() + a], mesh.simplices[s * mesh.width() + b]);
    std::swap(mesh.neighbors[s * mesh.width() + a], mesh.neighbors[s * mesh.width() + b]);
  }
  return true;
}

}  // namespace

std::vector<Mutation> index_mutations() {
  return {
      {"index-of-no-point",
       "One index is negative, the number of points, or beyond 32 bits.",
       Expected::kFails,
       {kUnknownVertex},
       name_no_point},
      {"vertex-repeated",
       "One simplex has a vertex twice.",
       Expected::kFails,
       {kRepeatedVertex},
       repeat_vertex},
      {"index-changed", "One index names another point.", Expected::kFails, kAnyOfSimplices,
       change_index},
      {"simplex-replaced", "One simplex has other vertices.", Expected::kFails, kAnyOfSimplices,
       replace_simplex},
      {"vertices-merged", "One vertex takes the place of another everywhere.", Expected::kFails,
       kAnyOfSimplices, merge_vertices},
      {"vertices-exchanged",
       "Two vertices change places everywhere.",
       Expected::kEither,
       {},
       exchange_everywhere},
      {"vertices-exchanged-between-two",
       "Two simplices exchange a vertex.",
       Expected::kEither,
       {},
       exchange_between_two},
      {"simplex-dropped",
       "One simplex is missing.",
       Expected::kFails,
       {kUnusedPoint, kHullNotClosed, kHullNotConvex},
       drop_simplex},
      {"simplex-listed-twice",
       "One simplex is listed again, in another order.",
       Expected::kFails,
       {kDuplicateSimplex},
       list_twice},
      {"rows-permuted",
       "The vertices of each simplex are listed in another order.",
       Expected::kHolds,
       {},
       permute_rows},
      {"rows-and-neighbours-permuted",
       "Likewise, with the neighbours in the same order.",
       Expected::kHolds,
       {},
       swap_two_places},
  };
}

}  // namespace circumspect::properties
