#include "oracle/report/text.hpp"

#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::report {

namespace {

// The cell of the domain that a witness names: " domain-vertex 3", " segment 3 4", " polygon 2", "
// hull-face 3 4 5".
std::string cell_text(const Witness& witness, const Domain* domain) {
  std::string text;
  if (domain == nullptr) return text;
  if (witness.domain_cell) {
    const std::size_t size = witness.domain_cell->size();
    text += size == 1 ? " domain-vertex" : size == 2 ? " segment" : " hull-face";
    for (const Vertex v : *witness.domain_cell) text += fmt::format(" {}", domain->label(v));
  }
  if (witness.polygon) text += " polygon " + domain->polygon_name(*witness.polygon);
  return text;
}

// Where corners are that are copies of points, since copies have the label of the point:
// " at (0, 1) (1, 1)"; nothing of other meshes.
std::string places_text(const Simplex& corners, const Mesh& mesh) {
  std::string text;
  for (const Vertex v : corners) {
    if (!mesh.copies || !mesh.names(v)) continue;
    text += (text.empty() ? " at " : " ") + point_text(mesh.point(v));
  }
  return text;
}

void describe(const Violation& violation, const Mesh& mesh, const Domain* domain,
              std::string& out) {
  const Witness& witness = violation.witness;
  const auto to = std::back_inserter(out);
  fmt::format_to(to, "{}: {}\n", identifier(violation.rule), meaning(violation.rule));
  const NamedCells named = named_cells(witness, mesh);
  for (std::size_t i = 0; i < named.simplices.size(); ++i) {
    fmt::format_to(to, "  simplex  {}{}\n", joined(named.simplices[i]),
                   places_text(witness.simplices[i], mesh));
  }
  if (named.face) {
    fmt::format_to(to, "  face     {}{}\n",
                   named.face->empty() ? "(the empty one)" : joined(*named.face),
                   places_text(*witness.face, mesh));
  }
  for (const auto& [own, left] : named.merged) {
    fmt::format_to(to, "  equal    points {} and {}\n", own, left);
  }
  for (const Vertex v : witness.vertices) {
    fmt::format_to(to, "  vertex   {}{}\n", mesh.label(v),
                   mesh.names(v) ? " at " + point_text(mesh.point(v)) : std::string());
  }
  if (const std::string cell = cell_text(witness, domain); !cell.empty()) {
    fmt::format_to(to, "  domain  {}\n", cell);
  }
  if (witness.point) fmt::format_to(to, "  point    {}\n", point_text(*witness.point));
  if (witness.nearest) {
    const auto& [vertex, squared] = *witness.nearest;
    fmt::format_to(to, "  nearest  vertex {} at {}, squared distance {}, distance ~ {}\n",
                   mesh.label(vertex), point_text(mesh.point(vertex)), value_text(squared),
                   square_root_to_decimal(squared));
  }
  if (witness.ball) {
    // Heavy points may have an orthogonal ball with an imaginary radius.
    const bool is_real = sign(witness.ball->squared_radius) >= 0;
    fmt::format_to(to, "  ball     centre {} {}\n", point_text(witness.ball->centre),
                   is_real ? "radius ~ " + square_root_to_decimal(witness.ball->squared_radius)
                           : "squared radius " + value_text(witness.ball->squared_radius));
  }
  for (const NamedValue& value : witness.values) {
    fmt::format_to(to, "  {}: {}\n", value.name, value_text(value.value));
  }
  if (witness.measured) {
    const auto& [measure, value, required] = *witness.measured;
    fmt::format_to(to, "  measured {}, required {}\n", measure_text(measure, value), required);
  }
  for (const RoundedValue& value : witness.rounded) {
    fmt::format_to(to, "  {} ~ {}\n", value.name, value.decimal);
  }
}

std::string first_witness(const Verdict& verdict, const Mesh& mesh, const Domain* domain,
                          Rule rule) {
  for (const Violation& violation : verdict.violations()) {
    if (violation.rule != rule) continue;
    const Witness& witness = violation.witness;
    std::string text;
    const NamedCells named = named_cells(witness, mesh);
    if (named.face) {
      text += " face " + joined(*named.face);
    } else if (!named.simplices.empty()) {
      text += " simplex " + joined(named.simplices.front());
    }
    if (!witness.vertices.empty()) text += " vertex " + labels(mesh, witness.vertices);
    return text + cell_text(witness, domain);
  }
  return "";
}

// How far the domain was moved, if it may be moved: " within 0", " within ~ 2.1e-14 3
// not-compared"; or that no distance suffices, " beyond ~ 1.0e-12".
std::string moved_text(const Verdict& verdict) {
  const auto distance = [](const Rational& squared) {
    return (sign(squared) == 0 ? "" : "~ ") + square_root_rounded_up(squared);
  };
  if (verdict.beyond) return " beyond " + distance(*verdict.beyond);
  if (!verdict.within) return "";
  std::string text = " within " + distance(verdict.within->squared_reach);
  if (verdict.within->not_compared > 0) {
    text += fmt::format(" {} not-compared", counted(verdict.within->not_compared, "polygon"));
  }
  return text;
}

// " 1 part 12 boundary-facets positive"
std::string complex_text(const ComplexFacts& facts) {
  std::string text = fmt::format(" {} {}", counted(facts.parts, "part"),
                                 counted(facts.boundary_facets, "boundary-facet"));
  if (facts.positive + facts.negative > 0) {
    text += facts.negative == 0 ? " positive" : facts.positive == 0 ? " negative" : " mixed-signs";
  }
  if (facts.hanging_vertices > 0) {
    text += " " + counted(facts.hanging_vertices, "hanging-vertex", "hanging-vertices");
  }
  if (facts.listed_faces > 0) text += " " + counted(facts.listed_faces, "listed-face");
  return text;
}

// " min-angle:20.7deg except-sharp:60deg 3 set-aside"
std::string quality_text(const QualityFacts& facts) {
  std::string text;
  for (const std::string& required : facts.required) text += " " + required;
  if (facts.except_sharp.empty()) return text;
  return text + fmt::format(" except-sharp:{} {} set-aside", facts.except_sharp, facts.set_aside);
}

// " 12 interior-edges 3 boundary-edges", and of more than two triangles, if there are any
std::string surface_text(const SurfaceFacts& facts) {
  std::string text = fmt::format(" {} {}", counted(facts.interior_edges, "interior-edge"),
                                 counted(facts.boundary_edges, "boundary-edge"));
  if (facts.edges_of_many > 0) {
    text += fmt::format(" {} of more than two triangles", counted(facts.edges_of_many, "edge"));
  }
  return text;
}

// " within ~ 1.2e-16 at site 7": the least distance within which all cells are the exact ones; and
// if they were asked for, how many vertices and ridges there are in the box
std::string voronoi_text(const VoronoiFacts& facts, const Mesh& sites) {
  std::string text = " within 0";
  if (facts.site) {
    text = fmt::format(" within ~ {} at site {}", square_root_rounded_up(facts.squared_distance),
                       sites.label(*facts.site));
  }
  if (!facts.structure) return text;
  return text + fmt::format(" {} {}", counted(facts.structure->vertices, "vertex", "vertices"),
                            counted(facts.structure->ridges, "ridge"));
}

}  // namespace

std::string verdict_line(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name,
                         const Domain* domain) {
  if (verdict.holds() && verdict.voronoi) {
    return fmt::format("holds: {} {} {} {}", circumspect::name(verdict.claim()),
                       on_one_line(mesh_name), counted(verdict.points, "site"),
                       counted(verdict.simplices, "cell")) +
           voronoi_text(*verdict.voronoi, mesh);
  }
  if (verdict.holds()) {
    // A mesh of a domain in space counts tetrahedra, even if it has none and all its points are in
    // a plane.
    const int dimension = domain != nullptr ? static_cast<int>(domain->complex.ambient_dimension())
                          : verdict.complex ? verdict.complex->dimension
                          : verdict.surface ? 2
                          : verdict.claim() == Claim::kConvexHull ? verdict.dimension - 1
                                                                  : verdict.dimension;
    std::string line = fmt::format("holds: {} {} {} {}", circumspect::name(verdict.claim()),
                                   on_one_line(mesh_name), counted(verdict.points, "point"),
                                   counted_simplices(verdict.simplices, dimension));
    if (verdict.complex) line += complex_text(*verdict.complex);
    if (verdict.surface) line += surface_text(*verdict.surface);
    if (verdict.dangling > 0) line += fmt::format(" {} dangling", verdict.dangling);
    if (verdict.unique) line += *verdict.unique ? " unique" : " not-unique";
    if (verdict.canonical) line += *verdict.canonical ? " canonical" : " not-canonical";
    if (verdict.steiner_points && verdict.steiner_points->count() > 0) {
      const SteinerPoints& steiner = *verdict.steiner_points;
      line += fmt::format(" {} {} on-segments {} in-polygons {} in-polyhedra",
                          counted(steiner.count(), "steiner-point"), steiner.on_segments,
                          steiner.in_polygons, steiner.in_polyhedra);
    }
    if (verdict.quality) line += quality_text(*verdict.quality);
    return line + moved_text(verdict);
  }
  std::string line =
      fmt::format("fails: {} {}", circumspect::name(verdict.claim()), on_one_line(mesh_name));
  bool first = true;
  for (const auto& [rule, tally] : verdict.tallies()) {
    line += fmt::format("{}{} {}", first ? " " : " also ", identifier(rule), tally.count);
    if (first) line += first_witness(verdict, mesh, domain, rule);
    first = false;
  }
  if (verdict.voronoi && verdict.voronoi->site) line += voronoi_text(*verdict.voronoi, mesh);
  return line + moved_text(verdict);
}

std::string explanation(const Verdict& verdict, const Mesh& mesh, const Domain* domain) {
  std::string text;
  for (const Violation& violation : verdict.violations()) describe(violation, mesh, domain, text);
  std::size_t all = 0;
  for (const auto& [rule, tally] : verdict.tallies()) all += tally.count;
  const std::size_t dropped = all - verdict.violations().size();
  if (dropped > 0) {
    text += fmt::format("… and {} more (--max-errors 0 shows all)\n", dropped);
  }
  for (const auto& [rule, tally] : verdict.tallies()) {
    if (!tally.worst_margin) continue;
    text += fmt::format("{}: worst relative margin {}\n", identifier(rule),
                        to_decimal(*tally.worst_margin));
  }
  for (const Cause& cause : verdict.causes) text += cause_line(cause) + "\n";
  return text;
}

std::string cause_line(const Cause& cause) {
  const std::string all = cause.of_listed ? fmt::format("{} above", counted(cause.of, "violation"))
                                          : counted(cause.of, "violation");
  const std::string explained = cause.explains < cause.of
                                    ? fmt::format("{} of {}", cause.explains, all)
                                : cause.of == 1 ? "the violation"
                                                : "all " + all;
  return fmt::format("cause: {} (explains {})", cause.words, explained);
}

std::optional<std::string> note_of_domain_not_given(const Verdict& verdict, const Mesh& mesh,
                                                    const std::string& mesh_name) {
  const bool may_have_domain = mesh.dimension() == 2 || mesh.dimension() == 3;
  if (!may_have_domain || !verdict.tallies().contains(Rule::kHullNotConvex) ||
      verdict.claim() == Claim::kWeightedDelaunay) {
    return std::nullopt;
  }
  return fmt::format(
      "{}: a triangulation of points fills their convex hull, and this mesh does not. A mesh of a "
      "domain, which need not be convex, is judged with --domain FILE: what its mesher was given",
      mesh_name);
}

std::optional<std::string> note_of_claim_complex(const Verdict& verdict,
                                                 const std::string& mesh_name) {
  const auto& tallies = verdict.tallies();
  const bool may_be_meant = tallies.contains(Rule::kHullNotConvex) ||
                            tallies.contains(Rule::kHullNotClosed) ||
                            tallies.contains(Rule::kDegenerateSimplex);
  const bool is_of_points =
      verdict.claim() == Claim::kTriangulation || verdict.claim() == Claim::kDelaunay;
  if (!may_be_meant || !is_of_points) return std::nullopt;
  return mesh_name +
         ": --claim complex tells whether the simplices fit together, whatever they fill";
}

std::optional<std::string> note_of_cut_counts(const Verdict& verdict,
                                              const std::string& mesh_name) {
  if (!verdict.complex || !verdict.complex->are_counts_cut) return std::nullopt;
  return mesh_name +
         ": so many simplices overlap that no more were looked for: the counts are at "
         "least those";
}

std::optional<std::string> note_of_set_apart(const Verdict& verdict, const std::string& mesh_name) {
  if (!verdict.complex || verdict.complex->set_apart == 0) return std::nullopt;
  const ComplexFacts& facts = *verdict.complex;
  std::string broken;
  for (const auto& [rule, tally] : verdict.tallies()) {
    if (stage(rule) != Stage::kFacets) continue;
    broken += fmt::format("{}{} {}", broken.empty() ? ": " : ", ", identifier(rule), tally.count);
  }
  return fmt::format(
      "{}: {} set apart: flat, listed twice, or no simplices; the others {} a complex{}", mesh_name,
      counted_simplices(facts.set_apart, facts.dimension) + (facts.set_apart == 1 ? " is" : " are"),
      facts.is_complex ? "form" : "do not form", facts.is_complex ? "" : broken);
}

std::string fault_of_equal_points(Vertex kept, Vertex again, std::uint64_t count,
                                  std::string_view to_merge) {
  return fmt::format(
      "expected distinct points, found points {} and {} equal{}{}", kept, again,
      count > 1 ? fmt::format(" and {} more duplicate{}", count - 1, count == 2 ? "" : "s") : "",
      to_merge.empty() ? "" : fmt::format("; to take equal points for one, {}", to_merge));
}

std::string note_of_merged_points(const std::vector<Duplicate>& merged, Vertex first_index) {
  const auto& [kept, again] = merged.front();
  return fmt::format(
      "points {} and {} are equal and count as one{}", kept + first_index, again + first_index,
      merged.size() > 1
          ? fmt::format("; in all, {} repeat an earlier one", counted(merged.size(), "point"))
          : "");
}

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
  if (count == 1) return fmt::format("1 {}", one);
  return several.empty() ? fmt::format("{} {}s", count, one) : fmt::format("{} {}", count, several);
}

std::string simplices_noun(int dimension, std::size_t count) {
  const bool one = count == 1;
  switch (dimension) {
    case 0:
      return one ? "vertex" : "vertices";
    case 1:
      return one ? "edge" : "edges";
    case 2:
      return one ? "triangle" : "triangles";
    case 3:
      return one ? "tetrahedron" : "tetrahedra";
    default:
      return one ? "simplex" : "simplices";
  }
}

std::string joined(const Simplex& indices) { return fmt::format("{}", fmt::join(indices, " ")); }
std::string counted_simplices(std::size_t count, int dimension) {
  return fmt::format("{} {}", count, simplices_noun(dimension, count));
}

NamedCells named_cells(const Witness& witness, const Mesh& mesh) {
  NamedCells named;
  std::map<Vertex, Vertex> in_face;  // the index of each vertex, by the first simplex that has it
  for (std::size_t i = 0; i < witness.simplices.size(); ++i) {
    const Simplex& simplex = witness.simplices[i];
    const bool has_place = i < witness.places.size();
    named.simplices.push_back(
        mesh.listed(simplex, has_place ? std::optional(witness.places[i]) : std::nullopt));
    for (std::size_t j = 0; j < simplex.size(); ++j) {
      const Vertex own = named.simplices.back()[j];
      in_face.emplace(simplex[j], own);
      if (own != mesh.label(simplex[j])) named.merged.emplace(own, mesh.label(simplex[j]));
    }
  }
  if (!witness.face) return named;
  named.face = mesh.listed(*witness.face);
  for (std::size_t i = 0; i < named.face->size(); ++i) {
    const Vertex v = (*witness.face)[i];
    const auto found = in_face.find(v);
    Vertex& own = (*named.face)[i];
    if (found != in_face.end()) own = found->second;
    if (own != mesh.label(v)) named.merged.emplace(own, mesh.label(v));
  }
  return named;
}

std::string name(check::By by) { return by == check::By::kLemma ? "lemma" : "definition"; }

std::string square_root_rounded_up(const Rational& squared) {
  if (sign(squared) == 0) return "0";
  int exponent = 0;
  Rational power = 1;  // ten, squared
  for (; power > squared; power /= 100) --exponent;
  for (; Rational(100 * power) <= squared; power *= 100) ++exponent;
  long digits = 10;
  while (Rational(digits * digits) * power < 100 * squared) ++digits;
  if (digits == 100) {
    digits = 10;
    ++exponent;
  }
  return fmt::format("{}.{}e{:+03d}", digits / 10, digits % 10, exponent);
}

}  // namespace circumspect::report
