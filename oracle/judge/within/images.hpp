// The images of the cells of a domain in a mesh, at a given reach. docs/theory/within.md, 1 to 3.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/piecewise_linear/regions.hpp"
#include "oracle/judge/within/mesh_faces.hpp"
#include "oracle/judge/within/reaches.hpp"
#include "oracle/judge/within/seen_from_above.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// The triangles that are the image of a polygon, and for each a triangle of the domain of the same
// part of the polygon: its sides are those of that. All are in the order that is counterclockwise
// seen from above (see `normal_of`), so that the front of OrientedFacet::of is below.
struct Patch {
  std::vector<Simplex> triangles;
  std::vector<Simplex> own;
};

// Why a cell has no image. `is_open`: there is a choice of triangles that the definition does not
// decide.
struct NoImage {
  Violation violation;
  bool is_open = false;
};
// Most cells have images, so what says that there is none is kept elsewhere.
template <class Image>
using ImageOr = tl::expected<Image, std::shared_ptr<NoImage>>;
inline tl::unexpected<std::shared_ptr<NoImage>> no_image(Rule rule, Witness witness) {
  return tl::unexpected(std::make_shared<NoImage>(NoImage{{rule, std::move(witness)}}));
}

class Images {
 public:
  // All must outlive this. In the plane `regions` are not looked at.
  // `rounded`: the points of the mesh.
  Images(const ExactMesh& mesh, const std::vector<RoundedPoint>& rounded, const Cells& cells,
         const DomainPieces& pieces, const Regions& regions, const Reaches& reaches,
         const MeshFaces& faces, Work& work);
  Images(const Images&) = delete;
  Images& operator=(const Images&) = delete;

  // Each asks nothing of the cell's faces but where their own images are: what these lack is
  // theirs. An answer is kept until a reach is asked about at which it may be another.
  // The one vertex of the mesh that a vertex of the domain carries.
  const ImageOr<Vertex>& vertex(std::size_t v, const Rational& squared_reach) const;
  // From the image of its first end to that of its second. Requires: the ends have images.
  const ImageOr<std::vector<Vertex>>& path(std::size_t segment,
                                           const Rational& squared_reach) const;
  // Requires: all faces of the polygon have images.
  const ImageOr<Patch>& patch(std::size_t polygon, const Rational& squared_reach) const;

  // Why a cell has no image; nothing if it has one, or if one of its faces has none.
  std::optional<NoImage> fault(Cell cell, const Rational& squared_reach) const;
  // The least distance beyond the reach at which the carriers of the vertices in the image of the
  // cell change, or there are others; nothing if there is none.
  std::optional<Rational> next_change(Cell cell, const Rational& squared_reach) const;
  // A change at or before which the cell has no image; nothing if it has none at any larger reach.
  // Requires: a fault.
  std::optional<Rational> next_reach(Cell cell, const Rational& squared_reach) const;

 private:
  // An answer, and the reaches that it is about: docs/theory/within.md, A.
  template <class Image>
  struct Known {
    ImageOr<Image> image;
    Rational from;
    bool knows_before = false;
    std::optional<Rational> before = {};  // none: all that are larger

    // Finds the next change only when another reach is asked for, which most images never see.
    // `next(from)`: the least reach after `from` at which the image may change.
    template <class Next>
    bool is_about(const Rational& squared_reach, const Next& next) {
      if (squared_reach == from) return true;
      if (squared_reach < from) return false;
      if (!std::exchange(knows_before, true)) before = next(from);
      return !before || squared_reach < *before;
    }
  };

  // A vertex near a segment: where it projects on the line, and how far it is.
  struct Place {
    Rational at;
    Vertex vertex;
    const Rational* squared;
  };
  // In their order along the segment.
  const std::vector<Place>& places_along(std::size_t segment) const;

  SeenFromAbove seen_from_above(std::size_t polygon) const {
    return {cells_.complex(), pieces_.rounded_points(), polygon, mesh_.points, rounded_};
  }
  bool has_image(Cell cell, const Rational& squared_reach) const;
  ImageOr<Vertex> found_vertex(std::size_t v, const Rational& squared_reach) const;
  ImageOr<std::vector<Vertex>> found_path(std::size_t segment, const Rational& squared_reach) const;
  // What is known of the image of a cell at a reach, or else is found.
  template <class Image, class Find>
  const ImageOr<Image>& known_or_found(std::optional<Known<Image>>& known, Cell cell,
                                       const Rational& squared_reach, const Find& find) const {
    const auto next = [&](const Rational& from) { return next_change(cell, from); };
    if (!known || !known->is_about(squared_reach, next)) {
      known = Known<Image>{find(), squared_reach};
    }
    return known->image;
  }
  std::optional<Patch> patch_of_triangle(std::size_t polygon, const SeenFromAbove& seen,
                                         const Rational& squared_reach) const;
  ImageOr<Patch> found_patch(std::size_t polygon, const Rational& squared_reach) const;

  const ExactMesh& mesh_;
  const std::vector<RoundedPoint>& rounded_;
  const Cells& cells_;
  const DomainPieces& pieces_;
  const Regions& regions_;
  const Reaches& reaches_;
  const MeshFaces& faces_;
  Work& work_;
  mutable std::vector<std::optional<std::vector<Place>>> places_;  // by segment
  mutable std::vector<std::optional<Known<Vertex>>> vertices_;
  mutable std::vector<std::optional<Known<std::vector<Vertex>>>> paths_;
  mutable std::vector<std::optional<Known<Patch>>> patches_;
};

}  // namespace circumspect::check
