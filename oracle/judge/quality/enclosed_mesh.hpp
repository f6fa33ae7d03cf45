// The simplices of a mesh of doubles in rows, as squared lengths of edges.
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/exact/angle.hpp"
#include "oracle/judge/quality/measures.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::quality {

// How many simplices are looked at between two looks at whether to go on.
inline constexpr std::size_t kChunk = 4096;

// A number that bounds a measure, as Requirement::bound holds it, among the values of the measure.
inline Enclosed enclosed_bound(Measure measure, const Rational& bound) {
  const DoubleRange range = entry(measure).is_angle
                                ? signed_square_of_degrees(bound)
                                : DoubleRange{lower_double(bound), upper_double(bound)};
  return Enclosed::between(range.low, range.high);
}

template <std::size_t k>
SquaredLengths<k, Enclosed> enclosed(const SquaredLengths<k, double>& rounded) {
  SquaredLengths<k, Enclosed> lengths;
  for (std::size_t e = 0; e < lengths.kEdges; ++e) {
    lengths.squared[e] = enclosed_squared_distance(rounded.squared[e]);
  }
  return lengths;
}

template <std::size_t kSimplex, std::size_t kSpace, class Index>
class EnclosedMesh {
 public:
  static constexpr std::size_t kDimension = kSimplex;

  EnclosedMesh(const Mesh& mesh, const double* coordinates, const Rows<Index>& simplices)
      : mesh_(mesh), coordinates_(coordinates), simplices_(simplices) {}

  // Rounded; false if an index of the simplex names no point.
  bool set_lengths(std::size_t s, SquaredLengths<kDimension, double>& lengths) const {
    const auto row = simplices_.row(s);
    for (const Index v : row) {
      if (!mesh_.names(static_cast<Vertex>(v))) return false;
    }
    for (std::size_t i = 0; i < kDimension; ++i) {
      for (std::size_t j = i + 1; j <= kDimension; ++j) {
        lengths.squared[lengths.place(i, j)] = rounded_squared_distance<kSpace>(
            coordinates_ + static_cast<std::size_t>(row[i]) * kSpace,
            coordinates_ + static_cast<std::size_t>(row[j]) * kSpace);
      }
    }
    return true;
  }

 private:
  const Mesh& mesh_;
  const double* coordinates_;
  const Rows<Index>& simplices_;
};

// Calls `with(EnclosedMesh)` if the mesh is one of triangles or tetrahedra whose numbers are
// doubles, else `without()`.
template <class With, class Without>
auto enclosed_or_else(const Mesh& mesh, const With& with, const Without& without) {
  const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates);
  if (doubles == nullptr) return without();
  const double* const coordinates = doubles->values().data();
  return mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      using Index = typename std::remove_cvref_t<decltype(lists.values())>::value_type;
      const std::size_t size = lists.columns(), space = mesh.dimension();
      if (size == 3 && space == 2) return with(EnclosedMesh<2, 2, Index>(mesh, coordinates, lists));
      if (size == 3 && space == 3) return with(EnclosedMesh<2, 3, Index>(mesh, coordinates, lists));
      if (size == 4 && space == 3) return with(EnclosedMesh<3, 3, Index>(mesh, coordinates, lists));
    }
    return without();
  });
}

}  // namespace circumspect::quality
