#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "properties/mutations/catalogue.hpp"

namespace circumspect::properties {
namespace {

constexpr int kDraws = 400;

std::size_t any_facet(const ArrayMesh& mesh, Dice& dice) {
  return dice.below(mesh.neighbors.size());
}

std::optional<std::size_t> any_facet_of_two(const ArrayMesh& mesh, Dice& dice) {
  for (int i = 0; i < kDraws; ++i) {
    const std::size_t facet = any_facet(mesh, dice);
    if (mesh.neighbors[facet] >= 0) return facet;
  }
  return std::nullopt;
}

std::optional<std::size_t> any_facet_of_one(const ArrayMesh& mesh, Dice& dice) {
  const std::size_t start = any_facet(mesh, dice);
  for (std::size_t i = 0; i < mesh.neighbors.size(); ++i) {
    const std::size_t facet = (start + i) % mesh.neighbors.size();
    if (mesh.neighbors[facet] < 0) return facet;
  }
  return std::nullopt;
}

std::int64_t simplex_of(const ArrayMesh& mesh, std::size_t facet) {
  return static_cast<std::int64_t>(facet / mesh.width());
}

bool change_one_end(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& link = mesh.neighbors[any_facet(mesh, dice)];
  const auto other = static_cast<std::int64_t>(dice.below(mesh.size()));
  return std::exchange(link, other) != other;
}

bool cut_one_end(ArrayMesh& mesh, Dice& dice) {
  const auto facet = any_facet_of_two(mesh, dice);
  if (facet) mesh.neighbors[*facet] = -1;
  return facet.has_value();
}

bool cut_both_ends(ArrayMesh& mesh, Dice& dice) {
  const auto facet = any_facet_of_two(mesh, dice);
  if (facet) mesh.neighbors[*facet] = mesh.neighbors[other_side(mesh, *facet)] = -1;
  return facet.has_value();
}

bool cut_all(ArrayMesh& mesh, Dice&) {
  return std::exchange(mesh.neighbors, std::vector<std::int64_t>(mesh.neighbors.size(), -1)) !=
         mesh.neighbors;
}

bool out_of_range(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& link = mesh.neighbors[any_facet(mesh, dice)];
  constexpr std::int64_t kWord = std::int64_t{1} << 32;
  const std::array choices{std::int64_t{-2},
                           static_cast<std::int64_t>(mesh.size()),
                           link + kWord,
                           link - kWord,
                           std::int64_t{std::numeric_limits<std::int32_t>::max()},
                           std::int64_t{std::numeric_limits<std::int32_t>::min()},
                           std::numeric_limits<std::int64_t>::max(),
                           std::numeric_limits<std::int64_t>::min()};
  link = choices[dice.below(choices.size())];
  return true;
}

bool link_to_itself(ArrayMesh& mesh, Dice& dice) {
  const std::size_t facet = any_facet(mesh, dice);
  mesh.neighbors[facet] = simplex_of(mesh, facet);
  return true;
}

// a–b and c–d become a–c and b–d, at all four ends.
bool cross_two(ArrayMesh& mesh, Dice& dice) {
  const auto a = any_facet_of_two(mesh, dice), c = any_facet_of_two(mesh, dice);
  if (!a || !c) return false;
  const std::size_t b = other_side(mesh, *a), d = other_side(mesh, *c);
  if (*a == *c || *a == d) return false;
  const std::vector<std::int64_t> old{mesh.neighbors[*a], mesh.neighbors[b], mesh.neighbors[*c],
                                      mesh.neighbors[d]};
  mesh.neighbors[*a] = simplex_of(mesh, *c);
  mesh.neighbors[*c] = simplex_of(mesh, *a);
  mesh.neighbors[b] = simplex_of(mesh, d);
  mesh.neighbors[d] = simplex_of(mesh, b);
  // Facets of one simplex may lead to the same ones as before.
  return old != std::vector<std::int64_t>{mesh.neighbors[*a], mesh.neighbors[b], mesh.neighbors[*c],
                                          mesh.neighbors[d]};
}

// a → b′, b → c′, c → a′: each is led to, from the wrong one.
bool rotate_three(ArrayMesh& mesh, Dice& dice) {
  const std::array facets{any_facet(mesh, dice), any_facet(mesh, dice), any_facet(mesh, dice)};
  const std::array old{mesh.neighbors[facets[0]], mesh.neighbors[facets[1]],
                       mesh.neighbors[facets[2]]};
  for (std::size_t i = 0; i < 3; ++i) mesh.neighbors[facets[i]] = old[(i + 1) % 3];
  return old[0] != old[1] && old[1] != old[2] && old[2] != old[0] && facets[0] != facets[1] &&
         facets[1] != facets[2] && facets[2] != facets[0];
}

bool swap_within_row(ArrayMesh& mesh, Dice& dice) {
  const std::size_t facet = any_facet(mesh, dice), row = facet - facet % mesh.width();
  const std::size_t other = row + dice.below(mesh.width());
  std::swap(mesh.neighbors[facet], mesh.neighbors[other]);
  return mesh.neighbors[facet] != mesh.neighbors[other];
}

bool join_boundary_facets(ArrayMesh& mesh, Dice& dice) {
  const auto a = any_facet_of_one(mesh, dice), b = any_facet_of_one(mesh, dice);
  if (!a || !b || *a == *b) return false;
  mesh.neighbors[*a] = simplex_of(mesh, *b);
  mesh.neighbors[*b] = simplex_of(mesh, *a);
  return true;
}

bool link_boundary_facet(ArrayMesh& mesh, Dice& dice) {
  const auto facet = any_facet_of_one(mesh, dice);
  if (facet) mesh.neighbors[*facet] = static_cast<std::int64_t>(dice.below(mesh.size()));
  return facet.has_value();
}

// What was linked is a boundary facet at both ends, and two boundary facets are linked: as many
// links as before, each of them returned.
bool open_and_close(ArrayMesh& mesh, Dice& dice) {
  const auto a = any_facet_of_one(mesh, dice), b = any_facet_of_one(mesh, dice);
  if (!a || !b || *a == *b || !cut_both_ends(mesh, dice)) return false;
  mesh.neighbors[*a] = simplex_of(mesh, *b);
  mesh.neighbors[*b] = simplex_of(mesh, *a);
  return true;
}

bool number_from_one(ArrayMesh& mesh, Dice&) {
  for (std::int64_t& link : mesh.neighbors) link += link >= 0 ? 1 : 0;
  return std::find_if(mesh.neighbors.begin(), mesh.neighbors.end(),
                      [](std::int64_t link) { return link >= 0; }) != mesh.neighbors.end();
}

Mutation links(std::string name, std::string about, bool (*apply)(ArrayMesh&, Dice&)) {
  return {std::move(name), std::move(about), Expected::kFails, {Rule::kWrongNeighbor}, apply};
}

}  // namespace

std::vector<Mutation> link_mutations() {
  return {
      links("link-changed", "One entry names another simplex.", change_one_end),
      links("link-cut-at-one-end", "One entry says that nothing is across.", cut_one_end),
      links("link-cut", "Both simplices say that nothing is across.", cut_both_ends),
      links("links-all-cut", "Nothing is across any facet.", cut_all),
      links("link-out-of-range", "One entry names no simplex, some of them only beyond 32 bits.",
            out_of_range),
      links("link-to-itself", "A simplex is across its own facet.", link_to_itself),
      links("links-crossed", "Two links exchange their ends, all four of which agree.", cross_two),
      links("links-rotated", "Three entries go around in a circle.", rotate_three),
      links("links-swapped-in-a-row", "The right simplices, across the wrong facets.",
            swap_within_row),
      links("boundary-joined", "Two facets of the hull lead to each other.", join_boundary_facets),
      links("boundary-linked", "A facet of the hull leads somewhere.", link_boundary_facet),
      links("boundary-exchanged",
            "Two facets of the hull lead to each other, and two that shared a facet no longer do.",
            open_and_close),
      links("links-from-one", "Neighbours are counted from 1.", number_from_one),
  };
}

}  // namespace circumspect::properties
