#include "command/input/enclosure.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/input/breach_text.hpp"
#include "oracle/domain/filling.hpp"
#include "oracle/domain/uncovered.hpp"

namespace circumspect::cli {
namespace {

bool is_planar(const Domain& domain) { return domain.complex.ambient_dimension() == 2; }

// What encloses: in the plane segments, in space polygons.
std::string wall_noun(const Domain& domain, std::size_t count) {
  const std::string one = is_planar(domain) ? "segment" : "polygon";
  return count == 1 ? one : one + "s";
}

Regions regions_if_enclosed(const Domain& domain, const std::vector<Point>& more_seeds = {}) {
  std::vector<Point> seeds = domain.complex.hole_seeds;
  seeds.insert(seeds.end(), more_seeds.begin(), more_seeds.end());
  return Regions(domain.complex, seeds, DomainKind::kEnclosed);
}

// The ridges that are faces of one wall alone, each with that wall: edges of triangles, in the
// plane ends of segments.
std::map<Simplex, Simplex> open_ridges(const std::vector<Simplex>& walls) {
  std::map<Simplex, Simplex> open;
  std::set<Simplex> closed;
  for (const Simplex& wall : walls) {
    for (std::size_t i = 0; i < wall.size(); ++i) {
      Simplex ridge = wall;
      ridge.erase(ridge.begin() + static_cast<std::ptrdiff_t>(i));
      if (closed.contains(ridge)) continue;
      if (open.emplace(ridge, wall).second) continue;
      open.erase(ridge);
      closed.insert(std::move(ridge));
    }
  }
  return open;
}

// The name of the polygon, or of the segment, that a wall is part of.
std::string name_of(const Simplex& wall, const Domain& domain) {
  if (is_planar(domain)) {
    return fmt::format("segment {} {}", domain.label(wall[0]), domain.label(wall[1]));
  }
  const std::vector<Polygon>& polygons = domain.complex.polygons;
  const auto polygon = std::find_if(polygons.begin(), polygons.end(), [&](const Polygon& p) {
    return std::find(p.triangles.begin(), p.triangles.end(), wall) != p.triangles.end();
  });
  return "polygon " + domain.polygon_name(static_cast<std::size_t>(polygon - polygons.begin()));
}

// "edge 1 2, from (0, 0, 0) to (1, 0, 0), belongs to one polygon alone, polygon 3 (line 17), and so
// do 2 more". A surface without an open edge may yet enclose nothing: Bing's house with two rooms.
std::string open_place(const std::map<Simplex, Simplex>& open, const Domain& domain) {
  if (open.empty()) return "none of their edges is open";
  const auto& [ridge, wall] = *open.begin();
  const PointSet& points = domain.complex.points;
  std::string text =
      is_planar(domain)
          ? fmt::format("vertex {} at {}", domain.label(ridge[0]), point_text(points[ridge[0]]))
          : fmt::format("edge {} {}, from {} to {},", domain.label(ridge[0]),
                        domain.label(ridge[1]), point_text(points[ridge[0]]),
                        point_text(points[ridge[1]]));
  text += fmt::format(" belongs to one {} alone, {}", wall_noun(domain, 1), name_of(wall, domain));
  if (open.size() > 1) {
    text += fmt::format(", and so {} {} more", open.size() == 2 ? "does" : "do", open.size() - 1);
  }
  return text;
}

bool is_flat(const Domain& domain) {
  const PointSet& points = domain.complex.points;
  return points.dimension() < static_cast<int>(points.ambient_dimension());
}

// "all on one line"
std::string flat_text(const Domain& domain) {
  const int dimension = domain.complex.points.dimension();
  if (dimension == 0) return "all in one place";
  return dimension == 1 ? "all on one line" : "all in one plane";
}

std::string flat_hull(const Domain& domain) {
  const bool in_plane = is_planar(domain);
  return fmt::format(
      "expected points that span {}, so that their convex hull has something to fill, found {}; "
      "--fill enclosed meshes {} alone{}",
      in_plane ? "the plane" : "space", flat_text(domain),
      in_plane ? "segments and vertices" : "polygons, segments and vertices",
      in_plane ? "" : ", and points with two coordinates are meshed in their plane");
}

std::string leak_text(const std::vector<Simplex>& walls, const Domain& domain) {
  const std::size_t count =
      is_planar(domain) ? domain.complex.segments.size() : domain.complex.polygons.size();
  return fmt::format(
      "expected {} that enclose something, found {} that {} nothing: {}; close the gap, or say "
      "--fill enclosed if they are to be meshed alone and nothing filled, --fill hull if the "
      "convex hull is to be filled",
      wall_noun(domain, 2), count, count == 1 ? "encloses" : "enclose",
      open_place(open_ridges(walls), domain));
}

// Nobody says, and nothing is enclosed. Where all lies in one plane there is no choice: neither
// kind fills anything, and polygons are meshed alone.
tl::expected<ChosenKind, std::string> kind_without_enclosure(const Domain& domain, Leak leak) {
  const std::vector<Simplex> some = walls(domain.complex);
  if (is_flat(domain)) {
    const std::string why = some.empty() ? flat_hull(domain) : "points " + flat_text(domain);
    if (some.empty() && leak == Leak::kRefused) return tl::unexpected(why);
    return ChosenKind{DomainKind::kEnclosed, {why + ": there is nothing to fill"}};
  }
  if (some.empty()) {
    return ChosenKind{
        DomainKind::kHull,
        {fmt::format("no {} to enclose anything: the domain is the convex hull (--fill)",
                     wall_noun(domain, 2))}};
  }
  std::string text = leak_text(some, domain);
  if (leak == Leak::kRefused) return tl::unexpected(std::move(text));
  return ChosenKind{DomainKind::kHull, {std::move(text) + "; taken as hull"}};
}

// Seeds that make no hole, and seeds that leave nothing.
void note_seeds(const Regions& regions, const Domain& domain, std::vector<std::string>& notes) {
  for (const std::size_t seed : regions.ignored_seeds()) {
    notes.push_back(fmt::format("hole seed {} at {}: ignored, it is in nothing enclosed", seed + 1,
                                point_text(domain.complex.hole_seeds[seed])));
  }
  std::size_t holes = 0;
  for (std::size_t i = 0; i < regions.size(); ++i) holes += regions.where(i) == Where::kHole;
  if (holes > 0 && holes + 1 == regions.size()) {
    notes.push_back(
        fmt::format("hole seeds empty all that is enclosed ({}): nothing is left to fill{}",
                    holes == 1 ? "one region" : fmt::format("{} regions", holes),
                    is_planar(domain) ? "; --fill hull fills the convex hull without them" : ""));
  }
}

std::string name_of(std::size_t wall, const Regions& regions, const Domain& domain) {
  return name_of(regions.walls().simplices()[wall], domain);
}

// Seeds in what --fill leaves empty; a note where that is no matter of course.
tl::expected<std::vector<Point>, std::string> seeds_by_rule(Fill fill, const Regions& regions,
                                                            const Domain& domain,
                                                            const PiecewiseLinearInput& input,
                                                            std::vector<std::string>& notes) {
  auto seeds = seeds_of_unfilled(fill, input, domain.complex, regions);
  if (!seeds) {
    return tl::unexpected(fmt::format(
        "expected {} that are listed all turned one way around what they enclose, found {} turned "
        "against others: --fill winding needs to know which side of each is which; --fill even-odd "
        "does not",
        wall_noun(domain, 2), name_of(seeds.error(), regions, domain)));
  }
  if (fill == Fill::kEvenOdd) {
    const auto wall = nesting_levels(regions).wall_of_no_parity;
    if (wall) {
      notes.push_back(fmt::format(
          "{} parts two regions that are both entered by an even or both by an odd number of {}, "
          "on the shortest ways: of other ways these numbers differ; the shortest ways count",
          name_of(*wall, regions, domain), wall_noun(domain, 2)));
    }
  }
  return std::move(*seeds);
}

// Seeds in what is enclosed but for the regions that somebody names by points in them.
tl::expected<std::vector<Point>, std::string> seeds_beside(const std::vector<Point>& named,
                                                           const Regions& regions) {
  auto seeds = seeds_of_unnamed(named, regions);
  if (seeds) return *std::move(seeds);
  const Point& point = named[seeds.error()];
  return tl::unexpected(fmt::format(
      "expected a point of --region in something enclosed, found {} {}", point_text(point),
      regions.region_at(point) ? "in nothing enclosed" : "on a wall"));
}

// The walls without anything filled on either side.
std::set<Simplex> dangling_walls(const Regions& regions) {
  std::set<Simplex> dangling;
  for (std::size_t wall = 0; wall < regions.walls().size(); ++wall) {
    const auto [behind, in_front] = regions.beside(wall);
    if (regions.where(behind) != Where::kInside && regions.where(in_front) != Where::kInside) {
      dangling.insert(regions.walls().simplices()[wall]);
    }
  }
  return dangling;
}

// The polygons of which all walls are such, and those of which some are: a bridge over the mouth of
// a tunnel also bounds what is beside the tunnel.
struct Dangling {
  std::vector<std::size_t> whole = {};
  std::vector<std::size_t> in_part = {};
};

Dangling dangling_polygons(const Domain& domain, const std::set<Simplex>& walls) {
  Dangling dangling;
  const auto dangles = [&](const Simplex& triangle) { return walls.contains(triangle); };
  for (std::size_t p = 0; p < domain.complex.polygons.size(); ++p) {
    const std::vector<Simplex>& triangles = domain.complex.polygons[p].triangles;
    const auto found = std::count_if(triangles.begin(), triangles.end(), dangles);
    if (found == 0) continue;
    if (static_cast<std::size_t>(found) < triangles.size()) {
      dangling.in_part.push_back(p);
    } else {
      dangling.whole.push_back(p);
    }
  }
  return dangling;
}

constexpr std::string_view kIsMeant = "; --fill enclosed says that this is meant";

// Something is enclosed, and something else may have leaked: walls between the outside and itself,
// or between what is not filled.
void note_dangling(const Regions& regions, const Domain& domain, bool is_said, ChosenKind& chosen) {
  const std::set<Simplex> walls = dangling_walls(regions);
  const bool in_plane = is_planar(domain);
  const Dangling dangling = in_plane ? Dangling{} : dangling_polygons(domain, walls);
  chosen.bound_nothing = dangling.whole;
  if (is_said) return;
  const std::size_t count = in_plane ? walls.size() : dangling.whole.size();
  if (count > 0) {
    const bool by_holes = std::any_of(walls.begin(), walls.end(), [&](const Simplex& wall) {
      return regions.in_front_of({wall, false}) != Regions::kUnbounded;
    });
    std::map<Simplex, Simplex> open = open_ridges(regions.walls().simplices());
    std::erase_if(open, [&](const auto& of_wall) { return !walls.contains(of_wall.second); });
    const std::string first = in_plane ? name_of(*walls.begin(), domain)
                                       : "polygon " + domain.polygon_name(dangling.whole.front());
    chosen.notes.push_back(fmt::format(
        "{} {} with {} on both sides {} nothing{}: {}{}", count, wall_noun(domain, count),
        by_holes ? "the outside or a hole" : "the outside", count == 1 ? "bounds" : "bound",
        count == 1 ? "" : ", the first of them " + first,
        open.empty() && count == 1 ? first : open_place(open, domain), kIsMeant));
  }
  for (const std::size_t p : dangling.in_part) {
    chosen.notes.push_back(fmt::format(
        "polygon {}: a part of it has the outside on both sides and bounds nothing, the rest of it "
        "bounds what is enclosed{}",
        domain.polygon_name(p), kIsMeant));
  }
}

// Formats that know rings want them to be holes; what they are instead is said.
void note_rings(const Domain& domain, const formats::DomainFile& file, const Regions& regions,
                std::vector<std::string>& notes) {
  const auto odd = rings_that_are_no_holes(file.faces, regions);
  if (odd.empty()) return;
  const auto& [face, ring, in_hole] = odd.front();
  const std::string words = fmt::format(
      "ring {} of polygon {}, which has vertex {}, lies {}: no hole, but {} that is filled",
      ring + 1, face + 1, domain.label(file.faces[face].lines[ring].front()),
      in_hole ? fmt::format("in the hole of ring {}", *in_hole + 1) : "outside of ring 1",
      in_hole ? "an island" : "a part");
  const std::string more = odd.size() == 1 ? "" : fmt::format(" (and {} more)", odd.size() - 1);
  notes.push_back(words + more);
}

// Something is enclosed, or the user says that nothing needs to be.
tl::expected<ChosenKind, std::string> kind_enclosed(const Domain& domain,
                                                    const formats::DomainFile& file,
                                                    const Regions& regions,
                                                    const DomainOptions& asked) {
  ChosenKind chosen{DomainKind::kEnclosed};
  const Fill fill = asked.fill.value_or(Fill::kEnclosed);
  tl::expected<std::vector<Point>, std::string> seeds;
  if (!asked.regions.empty()) {
    seeds = seeds_beside(asked.regions, regions);
  } else if (fill != Fill::kEnclosed) {
    seeds = seeds_by_rule(fill, regions, domain, file.input, chosen.notes);
  } else if (!asked.fill && !file.faces.empty()) {
    seeds = file.faces_are_rings ? points_without_rings(file.faces, regions)
                                 : points_without_face(file.faces, regions, domain.complex.points);
    if (file.faces_are_rings) note_rings(domain, file, regions, chosen.notes);
    chosen.is_by_faces = !seeds->empty();
    if (chosen.is_by_faces && !file.faces_are_rings) {  // of rings that is what they are for
      chosen.notes.push_back(fmt::format(
          "no face covers {} of the {} that are enclosed: {} left empty; --fill enclosed fills all",
          seeds->size(), regions.size() - 1, seeds->size() == 1 ? "it is" : "they are"));
    }
  }
  if (!seeds) return tl::unexpected(seeds.error());
  chosen.hole_seeds = std::move(*seeds);
  chosen.regions =
      chosen.hole_seeds.empty() ? regions : regions_if_enclosed(domain, chosen.hole_seeds);
  note_seeds(*chosen.regions, domain, chosen.notes);
  note_dangling(*chosen.regions, domain, asked.fill == Fill::kEnclosed, chosen);
  if (regions.size() == 1) {
    chosen.notes.emplace_back("nothing is enclosed: there is nothing to fill");
  }
  return chosen;
}

}  // namespace

tl::expected<ChosenKind, std::string> choose_kind(const Domain& domain,
                                                  const formats::DomainFile& file,
                                                  const DomainOptions& asked, Leak leak) {
  const std::size_t seeds = domain.complex.hole_seeds.size();
  ChosenKind chosen{DomainKind::kHull};
  if (asked.fill == Fill::kHull) {
    if (is_flat(domain)) return tl::unexpected(flat_hull(domain));
  } else {
    const Regions regions = regions_if_enclosed(domain);
    if (regions.size() > 1 || asked.fill || !asked.regions.empty()) {
      return kind_enclosed(domain, file, regions, asked);
    }
    auto other = kind_without_enclosure(domain, leak);
    if (!other) return other;
    chosen = std::move(*other);
  }
  for (std::size_t seed = 0; seed < seeds; ++seed) {
    chosen.notes.push_back(fmt::format(
        "hole seed {} at {}: ignored, {}", seed + 1, point_text(domain.complex.hole_seeds[seed]),
        chosen.kind == DomainKind::kHull ? "there are no holes in a hull"
                                         : "it is in nothing enclosed"));
  }
  return chosen;
}

}  // namespace circumspect::cli
