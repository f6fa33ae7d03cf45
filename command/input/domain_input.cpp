#include "command/input/domain_input.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "command/input/breach_text.hpp"
#include "oracle/domain/coplanar_polygons.hpp"
#include "oracle/domain/resolved.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/judge/domain/triangle_walls.hpp"
#include "oracle/judge/within/hull_faces.hpp"
#include "oracle/judge/within/hull_walls.hpp"
#include "oracle/judge/within/nearly_coplanar.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

// What may be all that the user needs, if the input is not a piecewise linear complex; or empty.
std::string remedy_of(const Breach& breach, std::size_t dimension) {
  if (breach.kind == BreachKind::kDuplicateVertex) {
    return "; to take equal points for one, add --duplicates merge to the command";
  }
  const bool meet_in_vertices =
      breach.kind == BreachKind::kCrossingSegments || breach.kind == BreachKind::kVertexInSegment;
  if (meet_in_vertices && dimension == 2) {
    return "; if the program makes a vertex where segments meet, check --resolve judges its mesh";
  }
  return "";
}

// Of breaches that were sought up to one more than `max_breaches`, or all if that is 0.
DomainFault fault_of(std::vector<Breach> breaches, std::size_t max_breaches,
                     formats::DomainFile file) {
  const bool truncated = max_breaches != 0 && breaches.size() > max_breaches;
  if (truncated) breaches.resize(max_breaches);
  std::string message =
      fmt::format("{}: expected a piecewise linear complex, found {}",
                  breach_place(breaches.front(), file), breach_line(breaches.front(), file));
  message += remedy_of(breaches.front(), file.dimension);
  if (truncated) {
    message += fmt::format(
        " (and at least {} more; `circumspect inspect --max-errors 0` lists all)", breaches.size());
  } else if (breaches.size() > 1) {
    message += fmt::format(" (and {} more)", breaches.size() - 1);
  }
  return {std::move(message), std::move(breaches), std::move(file), truncated};
}

Domain domain_of(PiecewiseLinearComplex complex, const formats::DomainFile& file) {
  Domain domain{std::move(complex), file.labels, file.first_index, {}};
  for (std::size_t i = 0; i < file.polygon_lines.size(); ++i) {
    domain.polygon_names.push_back(polygon_name(i, file));
  }
  domain.region_bounds = file.region_bounds;
  return domain;
}

// "3 (line 17), joined of 4"
std::vector<std::string> names_of_joined(const Domain& domain,
                                         const std::vector<std::vector<std::size_t>>& members) {
  std::vector<std::string> names;
  for (const std::vector<std::size_t>& some : members) {
    names.push_back(domain.polygon_name(some.front()));
    if (some.size() > 1) names.back() += fmt::format(", joined of {}", some.size());
  }
  return names;
}

// That of all members, where they agree.
std::vector<Vertex> markers_of_joined(const std::vector<Vertex>& markers,
                                      const std::vector<std::vector<std::size_t>>& members) {
  std::vector<Vertex> joined;
  for (const std::vector<std::size_t>& some : members) {
    if (markers.empty()) break;
    const bool agree = std::all_of(some.begin(), some.end(), [&](std::size_t member) {
      return markers[member] == markers[some.front()];
    });
    joined.push_back(agree ? markers[some.front()] : 0);
  }
  return joined;
}

// Which part of the plane or of space a mesh is held against.
std::string filled_text(const DomainOptions& said, const ChosenKind& chosen,
                        std::size_t dimension) {
  if (chosen.kind == DomainKind::kHull) return "hull, the convex hull";
  if (said.fill == Fill::kHull) {
    return "hull, the convex hull without what its segments enclose around hole seeds";
  }
  if (chosen.is_by_faces) return "enclosed, what its faces cover";
  const std::string walls = dimension == 2 ? "segments" : "polygons";
  if (!said.regions.empty()) {
    return fmt::format("enclosed, {} of what its {} enclose",
                       report::counted(said.regions.size(), "region"), walls);
  }
  switch (said.fill.value_or(Fill::kEnclosed)) {
    case Fill::kEvenOdd:
      return fmt::format("even-odd, what is entered by an odd number of its {}", walls);
    case Fill::kWinding:
      return fmt::format("winding, what its {} wind around", walls);
    default:
      return fmt::format("enclosed, what its {} enclose", walls);
  }
}

ValidityWatch validity_of(const DomainWatch& watch, const formats::DomainFile& file) {
  ValidityWatch validity{watch.progress};
  if (watch.on_breach) {
    validity.on_breach = [&](const Breach& breach) { watch.on_breach(breach, file); };
  }
  return validity;
}

formats::DomainFile with_merged(formats::DomainFile file, const InputOptions& options) {
  if (options.duplicates != Duplicates::kMerge) return file;
  return formats::with_duplicates_merged(std::move(file));
}

// The complex that a file holds, if it is one. One more breach than is reported tells whether there
// are more.
tl::expected<PiecewiseLinearComplex, DomainFault> validated_complex(const formats::DomainFile& file,
                                                                    std::size_t max_breaches,
                                                                    const DomainWatch& watch) {
  auto complex = check::validated_domain(file.input, max_breaches == 0 ? 0 : max_breaches + 1,
                                         validity_of(watch, file));
  if (complex) return std::move(*complex);
  return tl::unexpected(fault_of(std::move(complex.error()), max_breaches, file));
}

// Faces in the plane are looked at as the polygons that they are in space, and joined there.
tl::expected<formats::DomainFile, DomainFault> with_valid_faces(
    formats::DomainFile file, const std::string& path, const InputOptions& options,
    const DomainOptions& said, std::size_t max_breaches, const DomainWatch& watch) {
  if (!file.flat || file.faces.empty()) return file;
  formats::DomainFile in_space = with_merged(*file.flat->in_space, options);
  auto complex = validated_complex(in_space, max_breaches, watch);
  if (!complex) return tl::unexpected(std::move(complex.error()));
  if (!said.merged_slope) return file;
  LoadedDomain space{path, domain_of(std::move(*complex), in_space), std::move(in_space)};
  space.listed = listed_segments(space.file.input);
  space = with_coplanar_joined(std::move(space));
  auto joined = formats::in_plane(space.file);
  assert(joined);  // its points are those of the plane
  joined->notes = std::move(file.notes);
  joined->notes.push_back(space.file.notes.back());
  joined->flat = std::move(file.flat);
  return std::move(*joined);
}

// Points as users name them, with the coordinates that the points of the file have, or those of the
// domain.
tl::expected<DomainOptions, std::string> in_dimension_of(const formats::DomainFile& file,
                                                         DomainOptions said) {
  for (const auto& [name, points] :
       {std::pair{"--hole", &said.holes}, {"--region", &said.regions}}) {
    for (Point& point : *points) {
      const bool is_in_space = file.flat && point.size() == 3 && point[2] == file.flat->height;
      if (is_in_space) point.pop_back();
      if (point.size() == file.dimension) continue;
      return tl::unexpected(
          fmt::format("expected {} with {} coordinates, as its points have, found {}", name,
                      file.dimension, point.size()));
    }
  }
  return said;
}

// Where segments meet is a vertex from here on: those that the file does not list are numbered
// after all others. Lines of segments that were cut are not known.
formats::DomainFile resolved(formats::DomainFile file) {
  PiecewiseLinearInput& input = file.input;
  std::vector<Vertex> labels;
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    labels.push_back(file.label(static_cast<Vertex>(v)));
  }
  if (file.faces_are_rings) input.polygons = std::move(file.faces);
  ResolvedInput whole = circumspect::resolved(input, labels);
  if (file.faces_are_rings) file.faces = std::exchange(whole.input.polygons, {});
  std::string note = file.name + ": " + report::counted(segments_of(input).size(), "segment") +
                     " resolved into " + std::to_string(segments_of(whole.input).size());
  if (whole.added > 0) {
    note += fmt::format(", with {} where they meet, numbered from {}",
                        report::counted(whole.added, "vertex", "vertices"),
                        *std::max_element(whole.labels.begin(), whole.labels.end()) + 1 -
                            static_cast<Vertex>(whole.added));
  }
  if (whole.merged > 0) {
    note += fmt::format("; {} merged", report::counted(whole.merged, "equal point"));
  }
  file.notes.push_back(std::move(note));
  file.segment_lines.assign(whole.input.segments.size(), 0);
  file.labels = std::move(whole.labels);
  file.input = std::move(whole.input);
  return file;
}

// In the plane, --fill hull and hole seeds mean what triangle -pc means: the convex hull without
// the regions that segments enclose around the seeds. Its boundary is then made of segments, so
// that it is what segments enclose. (In space, tetgen -pc fills the holes as well.)
bool is_hull_with_holes(const LoadedDomain& loaded, const DomainOptions& said) {
  const PiecewiseLinearComplex& complex = loaded.domain.complex;
  return said.fill == Fill::kHull && !complex.hole_seeds.empty() &&
         complex.ambient_dimension() == 2 && complex.points.dimension() == 2;
}

void enclose_hull(LoadedDomain& loaded) {
  PiecewiseLinearComplex& complex = loaded.domain.complex;
  complex.kind = DomainKind::kHull;
  std::vector<Point> seeds = complex.hole_seeds;
  complex = check::with_hull_walls(complex, check::hull_faces(complex.points));
  complex.hole_seeds = std::move(seeds);
  const std::vector<Simplex> listed = segments_of(loaded.file.input);
  for (const Simplex& segment : complex.segments) {
    if (std::binary_search(listed.begin(), listed.end(), segment)) continue;
    formats::add_segment(loaded.file, segment, 0);
  }
}

}  // namespace

std::string_view word(DomainKind kind) {
  return kind == DomainKind::kEnclosed ? "enclosed" : "hull";
}

tl::expected<LoadedDomain, DomainFault> load_domain(const std::string& path,
                                                    const InputOptions& options,
                                                    const DomainOptions& said,
                                                    std::size_t max_breaches, Leak leak,
                                                    const DomainWatch& watch) {
  auto read = formats::read_domain(path, options.coordinates);
  if (!read) return tl::unexpected(DomainFault{read.error().to_string()});
  return load_domain(std::move(*read), path, options, said, max_breaches, leak, watch);
}

tl::expected<LoadedDomain, DomainFault> load_domain(
    formats::DomainFile read, const std::string& path, const InputOptions& options,
    const DomainOptions& asked, std::size_t max_breaches, Leak leak, const DomainWatch& watch) {
  auto with_faces = with_valid_faces(std::move(read), path, options, asked, max_breaches, watch);
  if (!with_faces) return tl::unexpected(std::move(with_faces.error()));
  formats::DomainFile file = with_merged(std::move(*with_faces), options);
  if (file.input.points.empty()) {
    return tl::unexpected(DomainFault{path + ": expected a domain with points, found none"});
  }
  if (asked.resolves) {
    if (!file.faces.empty() && !file.faces_are_rings) {
      return tl::unexpected(DomainFault{
          path +
          ": expected segments for --resolve, or polygons in space, found faces in a plane"});
    }
    file = resolved(std::move(file));
  }
  const auto settled = in_dimension_of(file, asked);
  if (!settled) return tl::unexpected(DomainFault{path + ": " + settled.error()});
  const DomainOptions& said = *settled;
  const std::size_t listed_holes = file.input.hole_seeds.size();
  file.input.hole_seeds.insert(file.input.hole_seeds.end(), said.holes.begin(), said.holes.end());
  auto complex = validated_complex(file, max_breaches, watch);
  if (!complex) return tl::unexpected(std::move(complex.error()));
  if (watch.on_valid) watch.on_valid(*complex, file);
  LoadedDomain loaded{path, domain_of(std::move(*complex), file), std::move(file)};
  loaded.listed_holes = listed_holes;
  loaded.listed = listed_segments(loaded.file.input);  // joined polygons are lists of segments
  if (watch.only_validity) return loaded;
  DomainOptions filling = said;
  loaded.is_hull_with_holes = is_hull_with_holes(loaded, said);
  if (loaded.is_hull_with_holes) {
    enclose_hull(loaded);
    filling.fill = Fill::kEnclosed;
  }
  auto chosen = choose_kind(loaded.domain, loaded.file, filling, leak);
  if (!chosen) {
    return tl::unexpected(DomainFault{path + ": " + chosen.error(), {}, std::move(loaded.file)});
  }
  for (const std::string& note : chosen->notes) loaded.file.notes.push_back(path + ": " + note);
  PiecewiseLinearComplex& valid = loaded.domain.complex;
  for (std::vector<Point>* const seeds : {&valid.hole_seeds, &loaded.file.input.hole_seeds}) {
    seeds->insert(seeds->end(), chosen->hole_seeds.begin(), chosen->hole_seeds.end());
  }
  valid.kind = loaded.file.input.kind = chosen->kind;
  loaded.domain.known_regions = std::move(chosen->regions);
  loaded.filled = filled_text(said, *chosen, valid.ambient_dimension());
  loaded.bound_nothing = std::move(chosen->bound_nothing);
  const bool is_joined = !said.merged_slope || loaded.file.flat;
  return is_joined ? std::move(loaded) : with_coplanar_joined(std::move(loaded));
}

DomainFrame frame_of(const LoadedDomain& domain) {
  const auto& flat = domain.file.flat;
  return {domain.domain.complex.ambient_dimension(),
          flat ? std::optional(flat->height) : std::nullopt};
}

LoadedDomain with_coplanar_joined(LoadedDomain loaded) {
  JoinedPolygons joined = coplanar_polygons_joined(loaded.file.input, loaded.domain.complex);
  const std::size_t before = loaded.domain.complex.polygons.size();
  loaded.file.notes.push_back(
      joined.members.size() == before
          ? loaded.name + ": no two polygons of one plane share a segment; none are joined"
          : fmt::format("{}: {} joined into {}, without {} between them", loaded.name,
                        report::counted(before, "polygon"), joined.members.size(),
                        report::counted(joined.removed_segments, "segment")));
  std::vector<std::size_t> lines;
  std::vector<std::size_t> bound_nothing;
  for (std::size_t p = 0; p < joined.members.size(); ++p) {
    const std::vector<std::size_t>& members = joined.members[p];
    if (!loaded.file.polygon_lines.empty()) {
      lines.push_back(loaded.file.polygon_lines[members.front()]);
    }
    const bool all = std::all_of(members.begin(), members.end(), [&](std::size_t member) {
      return std::binary_search(loaded.bound_nothing.begin(), loaded.bound_nothing.end(), member);
    });
    if (all) bound_nothing.push_back(p);
  }
  loaded.domain.polygon_names = names_of_joined(loaded.domain, joined.members);
  loaded.domain.complex = std::move(joined.complex);
  loaded.domain.known_regions.reset();
  loaded.file.input = std::move(joined.input);
  loaded.file.polygon_lines = std::move(lines);
  loaded.file.polygon_markers = markers_of_joined(loaded.file.polygon_markers, joined.members);
  loaded.bound_nothing = std::move(bound_nothing);
  return loaded;
}

BentDomain with_nearly_coplanar_joined(const LoadedDomain& loaded, const Rational& slope,
                                       const Rational& squared_distance) {
  check::NearlyJoined joined = check::nearly_coplanar_polygons_joined(
      loaded.domain.complex, loaded.listed, {slope * slope, squared_distance});
  std::string note =
      joined.removed_segments == 0
          ? loaded.name +
                ": no polygons are flat enough, within this distance, to be joined by angle"
          : fmt::format(
                "{}: {} of nearly one plane joined into {}, flat up to a distance of {}",
                loaded.name, report::counted(loaded.domain.complex.polygons.size(), "polygon"),
                joined.members.size(), report::square_root_rounded_up(joined.squared_height));
  if (joined.refused > 0) {
    note += fmt::format("; {} left as they are, since they fold or other cells are too near",
                        report::counted(joined.refused, "set of polygons", "sets of polygons"));
  }
  Domain domain = loaded.domain;
  domain.known_regions.reset();
  domain.complex = std::move(joined.complex);
  domain.polygon_names = names_of_joined(loaded.domain, joined.members);
  return {std::move(domain), joined.removed_segments, joined.squared_height, std::move(note),
          joined.squared_limit};
}

}  // namespace circumspect::cli
