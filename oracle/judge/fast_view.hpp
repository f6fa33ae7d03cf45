// A mesh as the fast engine sees it, or why it cannot.
#pragma once

#include <span>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/undecided.hpp"
#include "oracle/model/claim.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"

namespace circumspect::check {

// What the fast engine says, or why it says nothing.
template <class Answer>
using OrReason = tl::expected<Answer, std::string_view>;
inline tl::unexpected<std::string_view> because(std::string_view reason) {
  return tl::unexpected(reason);
}

// What the fast engine is asked. Requires: a claim about points.
inline fast::Question question_of(Claim claim) {
  if (claim == Claim::kTriangulation) return fast::Question::kTriangulation;
  return claim == Claim::kDelaunay ? fast::Question::kDelaunay : fast::Question::kWeightedDelaunay;
}

// Calls `look(view)` with the simplices as the fast engine sees them, with these numbers for the
// points, and without neighbours. Returns why it does not see them; empty if it does.
template <class Look>
std::string_view look_at_rows(const Mesh& mesh, std::span<const double> coordinates,
                              std::span<const double> weights, const Look& look) {
  return mesh.simplices.visit([&]<class Lists>(const Lists& lists) -> std::string_view {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return "simplices of various sizes";
    } else {
      const auto simplices = lists.values();
      using Index = typename decltype(simplices)::value_type;
      if (lists.rows() == 0) return description(fast::Undecided::kEmpty);
      if (lists.columns() != mesh.dimension() + 1) return "simplices of a lower dimension";
      if (mesh.dimension() == 2) {
        look(fast::MeshView<2, Index>{coordinates, weights, simplices});
      } else if (mesh.dimension() == 3) {
        look(fast::MeshView<3, Index>{coordinates, weights, simplices});
      } else {
        return "a dimension other than 2 and 3";
      }
      return "";
    }
  });
}

// What `ask(view)` says of a mesh of doubles, or why it cannot be asked.
template <class Answer, class Ask>
OrReason<Answer> asked_of_rows(const Mesh& mesh, bool weighted, const Ask& ask) {
  const auto* const coordinates = std::get_if<Rows<double>>(&mesh.coordinates);
  const auto* const weights = std::get_if<Rows<double>>(&mesh.weights);
  if (coordinates == nullptr || (weighted && weights == nullptr)) {
    return because("a number that is not a double");
  }
  OrReason<Answer> answer = because("");
  const std::string_view reason = look_at_rows(
      mesh, coordinates->values(), weighted ? weights->values() : std::span<const double>(),
      [&](const auto& view) { answer = ask(view); });
  if (!reason.empty()) return because(reason);
  return answer;
}

// Calls `look(view)` for what depends on the simplices alone, if the fast engine sees them: numbers
// that are not doubles are zeros in the view.
template <class Look>
void look_at_simplices(const Mesh& mesh, const Look& look) {
  const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates);
  std::vector<double> zeros;
  if (doubles == nullptr) zeros.resize(mesh.points() * mesh.dimension());
  look_at_rows(mesh, doubles != nullptr ? doubles->values() : std::span<const double>(zeros), {},
               look);
}

}  // namespace circumspect::check
