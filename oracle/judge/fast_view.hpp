// A mesh as the fast engine sees it, or why it cannot.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>
#include <thread>
#include <type_traits>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/undecided.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"

namespace circumspect::check {

// What the fast engine says, or why it says nothing.
template <class Answer>
using OrReason = tl::expected<Answer, std::string_view>;
inline tl::unexpected<std::string_view> because(std::string_view reason) {
  return tl::unexpected(reason);
}

inline unsigned threads_of(const Options& options) {
  return options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
}

// Calls `answer(view)` with the mesh as the fast engine sees it, without neighbours.
template <class Answer, class Ask>
OrReason<Answer> asked_of_rows(const Mesh& mesh, bool weighted, const Ask& ask) {
  const auto* const coordinates = std::get_if<Rows<double>>(&mesh.coordinates);
  const auto* const weights = std::get_if<Rows<double>>(&mesh.weights);
  if (coordinates == nullptr || (weighted && weights == nullptr)) {
    return because("a number that is no double");
  }
  return mesh.simplices.visit([&]<class Lists>(const Lists& lists) -> OrReason<Answer> {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return because("simplices of various sizes");
    } else {
      const auto simplices = lists.values();
      using Index = typename decltype(simplices)::value_type;
      const std::span<const double> counted =
          weighted ? weights->values() : std::span<const double>();
      if (lists.rows() == 0) return because(description(fast::Undecided::kEmpty));
      if (lists.columns() != mesh.dimension() + 1) {
        return because("simplices of a lower dimension");
      }
      if (mesh.dimension() == 2) {
        return ask(fast::MeshView<2, Index>{coordinates->values(), counted, simplices});
      }
      if (mesh.dimension() == 3) {
        return ask(fast::MeshView<3, Index>{coordinates->values(), counted, simplices});
      }
      return because("a dimension other than 2 and 3");
    }
  });
}

}  // namespace circumspect::check
