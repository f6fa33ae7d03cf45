// A mesh as the fast engine sees it, for what depends on the simplices alone.
#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// Calls `look(view)`, if the mesh has rows of d + 1 indices in the plane or in space. Numbers that
// are no doubles are zeros there.
template <class Look>
void look_at_rows(const Mesh& mesh, const Look& look) {
  const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates);
  std::vector<double> none;
  if (doubles == nullptr) none.resize(mesh.points() * mesh.dimension());
  const std::span<const double> coordinates =
      doubles != nullptr ? doubles->values() : std::span<const double>(none);
  mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      const auto simplices = lists.values();
      using Index = typename decltype(simplices)::value_type;
      if (lists.rows() == 0 || lists.columns() != mesh.dimension() + 1) return;
      if (mesh.dimension() == 2) look(fast::MeshView<2, Index>{coordinates, {}, simplices});
      if (mesh.dimension() == 3) look(fast::MeshView<3, Index>{coordinates, {}, simplices});
    }
  });
}

}  // namespace circumspect::check
