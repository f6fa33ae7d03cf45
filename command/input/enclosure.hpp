// Finds which part of the plane or of space a domain fills, by the user's options or by default.
// Book: Section 4.5.1, Definition 4.3.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "command/options/domain_options.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/model/domain.hpp"

namespace circumspect::cli {

// A domain has polygons (in the plane: segments) that enclose nothing, and nobody says which
// kind of domain it is. That may be a surface with a leak, which nothing but its author can tell
// from one that is meant to dangle: a judgement refuses it, an inspection tells.
enum class Leak { kRefused, kTold };

// The kind, and what the user ought to know of it, one line each: a default that is no matter of
// course, hole seeds that make no hole or leave nothing, polygons that bound nothing.
struct ChosenKind {
  DomainKind kind;
  std::vector<std::string> notes = {};
  std::vector<Point> hole_seeds = {};           // further ones, in what is enclosed and not filled
  std::vector<std::size_t> bound_nothing = {};  // polygons without anything filled on either side
  bool is_by_faces = false;                     // of what is enclosed, faces cover only a part
  std::optional<Regions> regions = {};  // of the domain, of this kind, where they were found
};

// `asked`: what the user says of what is filled, if anything. Otherwise what the faces of a
// domain in the plane cover is filled, if there are any; a domain without them is enclosed if it
// encloses anything, its convex hull if it has nothing that could enclose, and enclosed if all of
// it lies in one hyperplane, where neither kind fills anything; `domain.complex.kind` does not
// matter. Errors (one line, without the name of the file): a leak, where it is refused; a convex
// hull that is flat and thus fills nothing; walls that are not turned one way, where their winding
// is to say what is filled; a point of --region that is in nothing enclosed. Requires: a valid
// complex that has points, and the file it was made of; in the plane edges of faces are
// segments, and no two faces overlap unless they are rings.
tl::expected<ChosenKind, std::string> choose_kind(const Domain& domain,
                                                  const formats::DomainFile& file,
                                                  const DomainOptions& asked, Leak leak);

}  // namespace circumspect::cli
