// Lists that were read otherwise than they were meant: indices that begin at another number,
// columns that are neither indices nor coordinates, and points that are there for something else.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "oracle/judge/cause/rows.hpp"
#include "oracle/judge/stray_faces.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

// A list of indices without some of its columns, each index plus `shift`.
IndexLists changed(const IndexLists& lists, std::size_t columns, Vertex shift) {
  return lists.visit([&]<class Lists>(const Lists& rows) -> IndexLists {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return {};
    } else {
      Lists other(rows.rows(), columns);
      for (std::size_t i = 0; i < rows.rows(); ++i) {
        const auto from = rows.row(i);
        const auto to = other.row(i);
        for (std::size_t j = 0; j < columns; ++j) {
          to[j] = static_cast<std::remove_cvref_t<decltype(to[j])>>(from[j] + shift);
        }
      }
      return other;
    }
  });
}

struct Extent {
  Vertex least = 0, most = 0;
};
std::optional<Extent> extent(const IndexLists& lists) {
  return lists.visit([]<class Lists>(const Lists& rows) -> std::optional<Extent> {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return std::nullopt;
    } else {
      const auto values = rows.values();
      if (values.empty()) return std::nullopt;
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      return Extent{static_cast<Vertex>(*least), static_cast<Vertex>(*most)};
    }
  });
}

// How many different numbers of [first, end) the simplices name.
std::size_t named_from(const IndexLists& lists, Vertex first, Vertex end) {
  std::vector<bool> is_named(static_cast<std::size_t>(end - first), false);
  lists.visit([&]<class Lists>(const Lists& rows) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      for (const auto v : rows.values()) {
        if (v >= first && v < end) is_named[static_cast<std::size_t>(v - first)] = true;
      }
    }
  });
  return static_cast<std::size_t>(std::count(is_named.begin(), is_named.end(), true));
}

// Has every simplex, but none of them, the right number of vertices?
bool all_have_wrong_size(const Case& of) {
  return of.count(Rule::kWrongDimension) == of.mesh().simplices.size();
}

template <class Value>
Rows<Value> without_last_column(const Rows<Value>& rows) {
  Rows<Value> fewer(rows.rows(), rows.columns() - 1);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const auto from = rows.row(i);
    std::copy(from.begin(), from.end() - 1, fewer.row(i).begin());
  }
  return fewer;
}

// Are they whole numbers that many points share?
bool last_coordinates_are_labels(const Mesh& mesh) {
  constexpr std::size_t kMost = 64;
  std::set<Rational> labels;
  for (std::size_t v = 0; v < mesh.points(); ++v) {
    const Rational last = mesh.point(static_cast<Vertex>(v)).back();
    if (last.get_den() != 1) return false;
    labels.insert(last);
    if (labels.size() > kMost) return false;
  }
  return 2 * labels.size() <= mesh.points();
}

}  // namespace

std::optional<Cause> indices_begin_elsewhere(Case& of) {
  if (!of.breaks(Rule::kUnknownVertex)) return std::nullopt;
  const Mesh& mesh = of.mesh();
  const auto found = extent(mesh.simplices);
  if (!found) return std::nullopt;
  const auto last = static_cast<Vertex>(mesh.points());
  Vertex shift = 0;
  if (found->least >= 1 && found->most == last) shift = -1;
  if (found->least == -1 && found->most < last) shift = 1;
  if (shift == 0) return std::nullopt;
  const auto mended =
      of.mended(with_simplices(mesh, changed(mesh.simplices, mesh.simplices.columns(), shift)));
  if (!mended || mended->explains == 0 || mended->left >= of.violations()) return std::nullopt;
  const Vertex first = mesh.label(0);
  return of.cause(
      "indices-begin-elsewhere",
      fmt::format("indices seem to begin at {}, not at {}: so read, {}", first - shift, first,
                  mended->holds ? std::string("the claim holds")
                                : fmt::format("all name points, and {} violation{} left",
                                              mended->left, mended->left == 1 ? " is" : "s are")),
      mended->explains);
}

std::optional<Cause> faces_begin_elsewhere(Case& of) {
  constexpr std::size_t kFewest = 4;  // fewer may be faces by chance
  const Mesh& mesh = of.mesh();
  const std::size_t listed = mesh.faces.size();
  if (listed < kFewest) return std::nullopt;
  for (const Vertex shift : {Vertex{-1}, Vertex{1}}) {
    if (!are_faces_if_shifted(mesh, shift)) continue;
    const Vertex first = mesh.label(0);
    return of.cause("faces-begin-elsewhere",
                    fmt::format("the indices of the listed faces seem to begin at {}, not at {}: "
                                "so read, all {} are faces of simplices",
                                first - shift, first, listed),
                    of.count(Rule::kStrayFace));
  }
  return std::nullopt;
}

std::optional<Cause> last_column_is_a_label(Case& of) {
  const Mesh& mesh = of.mesh();
  const std::size_t columns = mesh.simplices.columns();
  const bool has_one_more = columns == mesh.dimension() + 2;
  const bool is_wrong = all_have_wrong_size(of) || of.breaks(Rule::kUnknownVertex);
  if (!has_one_more || !is_wrong) return std::nullopt;
  const auto mended =
      of.mended(with_simplices(mesh, changed(mesh.simplices, columns - 1, Vertex{0})));
  if (!mended || !mended->holds) return std::nullopt;
  return of.cause("last-column-is-a-label",
                  "the last column of the simplices is a label: without it, the claim holds",
                  mended->explains);
}

std::optional<Cause> too_few_points(Case& of) {
  constexpr std::size_t kFewest = 16;  // fewer are single indices that are wrong
  const Mesh& mesh = of.mesh();
  const auto found = extent(mesh.simplices);
  const auto count = static_cast<Vertex>(mesh.points());
  if (!found || found->least < 0 || found->most < count) return std::nullopt;
  // The indices of a longer list follow one another. Other numbers may lie anywhere.
  const std::size_t named = named_from(mesh.simplices, count, 2 * count);
  if (named < kFewest || 2 * named < static_cast<std::size_t>(found->most - count)) {
    return std::nullopt;
  }
  return of.cause(
      "points-of-another-mesh",
      fmt::format(
          "the points seem to be those of another mesh, or not all of them: the last one is "
          "{}, and simplices name vertices up to {}",
          mesh.label(count - 1), mesh.label(0) + found->most),
      of.count(Rule::kUnknownVertex));
}

std::optional<Cause> last_coordinate_is_none(Case& of) {
  const Mesh& mesh = of.mesh();
  const bool has_one_more = mesh.dimension() >= 3 && mesh.simplices.columns() == mesh.dimension();
  if (!has_one_more || !all_have_wrong_size(of)) return std::nullopt;
  Mesh fewer = with_simplices(mesh, changed(mesh.simplices, mesh.simplices.columns(), Vertex{0}));
  fewer.coordinates = std::visit(
      []<class Value>(const Rows<Value>& rows) -> Numbers { return without_last_column(rows); },
      mesh.coordinates);
  const auto mended = of.mended(fewer);
  if (!mended || !mended->holds) return std::nullopt;
  const bool are_labels = last_coordinates_are_labels(mesh);
  return of.cause("last-coordinate-does-not-count",
                  are_labels
                      ? "the last column of the points is a label: without it, the claim holds"
                      : "the last coordinate is a height: seen along that axis, the claim holds",
                  mended->explains);
}

// In a model with shells and beams beside solids, only faces that are listed have some points.
bool are_in_listed_faces(const Mesh& mesh, std::size_t count) {
  if (mesh.faces.empty()) return false;
  std::vector<bool> is_in_face(mesh.points(), false);
  for (const Simplex& face : mesh.faces) {
    for (const Vertex v : face) {
      if (mesh.names(v)) is_in_face[static_cast<std::size_t>(v)] = true;
    }
  }
  const std::vector<Vertex> unused = unused_points(mesh, count);
  return std::all_of(unused.begin(), unused.end(),
                     [&](Vertex v) { return is_in_face[static_cast<std::size_t>(v)]; });
}

std::optional<Cause> left_over_points(Case& of) {
  // If indices name no points, others are left over.
  if (of.verdict().claim() != Claim::kComplex || of.breaks(Rule::kUnknownVertex)) {
    return std::nullopt;
  }
  const std::size_t count = of.count(Rule::kUnusedPoint);
  const char* const but = !are_in_listed_faces(of.mesh(), count) ? ""
                          : count == 1                           ? ", but in a listed face"
                                                                 : ", but in listed faces";
  return of.cause("unused-points",
                  fmt::format("{} {} in no {}{}: --allow-unused lets {} pass{}",
                              report::counted(count, "point"), count == 1 ? "is" : "are",
                              report::simplices_noun(of.verdict().complex->dimension, 1), but,
                              count == 1 ? "it" : "them",
                              count == of.violations() ? ", and the claim holds" : ""),
                  count);
}

}  // namespace circumspect::check
