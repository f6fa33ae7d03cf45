#include "oracle/report/json.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "kernel/complex/circumball.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::report {
namespace {

Json labels_of(const Mesh& mesh, const Simplex& simplex) {
  Json array = Json::array();
  for (const Vertex v : simplex) array.push_back(mesh.label(v));
  return array;
}

// The exact coordinates of every vertex that the witness names, by label: what a re-check needs.
Json coordinates_of(const Witness& witness, const Mesh& mesh) {
  std::set<Vertex> named(witness.vertices.begin(), witness.vertices.end());
  for (const Simplex& simplex : witness.simplices) named.insert(simplex.begin(), simplex.end());
  if (witness.face) named.insert(witness.face->begin(), witness.face->end());
  if (witness.nearest) named.insert(witness.nearest->vertex);
  Json object = Json::object();
  for (const Vertex v : named) {
    if (mesh.names(v)) object[std::to_string(mesh.label(v))] = point(mesh.point(v));
  }
  return object;
}

Json points_of(const Simplex& corners, const Mesh& mesh) {
  Json array = Json::array();
  for (const Vertex v : corners) {
    array.push_back(mesh.names(v) ? point(mesh.point(v)) : Json(nullptr));
  }
  return array;
}

// Where the named vertices are, of a mesh whose points are copies: these have the label of a point.
Json places_of(const Witness& witness, const Mesh& mesh) {
  Json simplices = Json::array();
  for (const Simplex& simplex : witness.simplices) simplices.push_back(points_of(simplex, mesh));
  Json object = {{"simplices", simplices}, {"vertices", points_of(witness.vertices, mesh)}};
  if (witness.face) object["face"] = points_of(*witness.face, mesh);
  return object;
}

// The cell of the domain that a witness names, its vertices with their coordinates.
Json cell_of(const Witness& witness, const Domain& domain) {
  Json cell = Json::object();
  if (witness.domain_cell) {
    Json vertices = Json::object();
    for (const Vertex v : *witness.domain_cell) {
      vertices[std::to_string(domain.label(v))] = point(domain.complex.points[v]);
    }
    const std::size_t size = witness.domain_cell->size();
    cell[size == 1 ? "vertex" : size == 2 ? "segment" : "hull_face"] = vertices;
  }
  if (witness.polygon) cell["polygon"] = domain.polygon_name(*witness.polygon);
  return cell;
}

Json nearest(const NearestVertex& nearest, const Mesh& mesh) {
  return {{"vertex", mesh.label(nearest.vertex)},
          {"squared_distance", value(nearest.squared_distance)},
          {"distance_decimal", square_root_to_decimal(nearest.squared_distance)}};
}

// The Steiner points of a mesh: how many, the first ones with their coordinates, are these all?
Json extra_vertices(const ExtraVertices& extra, const Mesh& mesh) {
  Json first = Json::array();
  for (const Vertex v : extra.first) {
    first.push_back({{"vertex", mesh.label(v)}, {"point", point(mesh.point(v))}});
  }
  return {
      {"count", extra.count}, {"first", first}, {"truncated", extra.first.size() < extra.count}};
}

Json complex_facts(const ComplexFacts& facts) {
  Json object = {{"dimension", facts.dimension},
                 {"set_apart", facts.set_apart},
                 {"others_form_a_complex", facts.is_complex},
                 {"parts", facts.parts},
                 {"boundary_facets", facts.boundary_facets},
                 {"hanging_vertices", facts.hanging_vertices},
                 {"positive", facts.positive},
                 {"negative", facts.negative}};
  if (facts.listed_faces > 0) object["listed_faces"] = facts.listed_faces;
  if (facts.are_counts_cut) object["counts_are_cut"] = true;
  return object;
}

Json causes(const std::vector<Cause>& causes) {
  Json array = Json::array();
  for (const Cause& cause : causes) {
    array.push_back({{"cause", cause.name},
                     {"text", cause.words},
                     {"explains", cause.explains},
                     {"of", cause.of},
                     {"of_listed", cause.of_listed}});
  }
  return array;
}

Json surface_facts(const SurfaceFacts& facts) {
  return {{"interior_edges", facts.interior_edges},
          {"boundary_edges", facts.boundary_edges},
          {"edges_of_more_than_two", facts.edges_of_many}};
}

Json voronoi_facts(const VoronoiFacts& facts, const Mesh& sites) {
  Json object = {{"squared_distance", value(facts.squared_distance)},
                 {"distance_rounded_up", square_root_rounded_up(facts.squared_distance)}};
  if (facts.site) object["site"] = sites.label(*facts.site);
  return object;
}

Json quality_facts(const QualityFacts& facts) {
  Json object = {{"required", facts.required}};
  if (facts.except_sharp.empty()) return object;
  object["except_sharp"] = facts.except_sharp;
  object["set_aside"] = facts.set_aside;
  return object;
}

Json measured(const Measured& measured) {
  return {{"measure", entry(measured.measure).name},
          {"text", measure_text(measured.measure, measured.value)},
          {"required", measured.required}};
}

Json violation(const Violation& broken, const Mesh& mesh, const Domain* domain) {
  Json object = {{"rule", identifier(broken.rule)}, {"meaning", meaning(broken.rule)}};
  object.update(witness(broken.witness, mesh, domain));
  return object;
}

}  // namespace

Json witness(const Witness& witness, const Mesh& mesh, const Domain* domain) {
  const NamedCells named = named_cells(witness, mesh);
  Json object = {{"simplices", named.simplices}};
  if (named.face) object["face"] = *named.face;
  object["vertices"] = labels_of(mesh, witness.vertices);
  if (witness.point) object["point"] = point(*witness.point);
  if (witness.ball) object["ball"] = ball(*witness.ball);
  Json values = Json::object();
  for (const NamedValue& exact : witness.values) values[exact.name] = value(exact.value);
  for (const RoundedValue& rounded : witness.rounded) {
    values[rounded.name] = {{"decimal", rounded.decimal}};
  }
  object["values"] = values;
  if (witness.measured) object["measured"] = measured(*witness.measured);
  if (witness.nearest) object["nearest"] = nearest(*witness.nearest, mesh);
  if (mesh.copies) {
    object["places"] = places_of(witness, mesh);
  } else {
    object["coordinates"] = coordinates_of(witness, mesh);
  }
  for (const auto& [own, left] : named.merged) {
    object["merged"][std::to_string(own)] = left;
    object["coordinates"][std::to_string(own)] = object["coordinates"][std::to_string(left)];
  }
  if (domain != nullptr && (witness.domain_cell || witness.polygon)) {
    object["domain"] = cell_of(witness, *domain);
  }
  return object;
}

// Only strings contain bytes beyond ASCII, so such bytes may be escaped wherever they occur.
std::string document_text(const Json& document, int indent) {
  const std::string whole = document.dump(indent, ' ', false, Json::error_handler_t::replace);
  std::string text;
  for (std::string_view rest = whole; !rest.empty();) {
    const Character character = first_character(rest);
    if (character.code < 0x7F || is_printable(character.code)) {
      text += rest.substr(0, character.size);
    } else {
      text += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(character.code));
    }
    rest.remove_prefix(std::max<std::size_t>(character.size, 1));
  }
  return text + "\n";
}

Json value(const Rational& value) {
  return {{"exact", to_string(value)}, {"decimal", to_decimal(value)}};
}

Json point(const Point& point) {
  Json array = Json::array();
  for (const Rational& x : point) array.push_back(to_string(x));
  return array;
}

Json ball(const Ball& ball) {
  Json object = {{"centre", point(ball.centre)}, {"squared_radius", value(ball.squared_radius)}};
  if (sign(ball.squared_radius) >= 0) {
    object["radius_decimal"] = square_root_to_decimal(ball.squared_radius);
  }
  return object;
}

Json verdict(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name, check::By by,
             const Domain* domain) {
  Json object = {{"mesh", mesh_name},
                 {"claim", circumspect::name(verdict.claim())},
                 {"by", name(by)},
                 {"verdict", verdict.holds() ? "holds" : "fails"},
                 {"points", verdict.points},
                 {"simplices", verdict.simplices},
                 {"dimension", verdict.dimension}};
  if (verdict.holds() && is_about_a_domain(verdict.claim())) {
    object["dangling"] = verdict.dangling;
  }
  if (verdict.steiner_points) {
    object["steiner_points"] = {{"on_segments", verdict.steiner_points->on_segments},
                                {"in_polygons", verdict.steiner_points->in_polygons},
                                {"in_polyhedra", verdict.steiner_points->in_polyhedra}};
  }
  if (verdict.extra_vertices) {
    object["steiner_vertices"] = extra_vertices(*verdict.extra_vertices, mesh);
  }
  if (verdict.within) {
    object["within"] = {
        {"squared_distance", value(verdict.within->squared_reach)},
        {"distance_rounded_up", square_root_rounded_up(verdict.within->squared_reach)},
        {"polygons_not_compared", verdict.within->not_compared}};
  }
  if (verdict.beyond) object["beyond"] = {{"squared_distance", value(*verdict.beyond)}};
  if (verdict.complex) object["complex"] = complex_facts(*verdict.complex);
  if (verdict.quality) object["quality"] = quality_facts(*verdict.quality);
  if (verdict.voronoi) object["voronoi"] = voronoi_facts(*verdict.voronoi, mesh);
  if (verdict.surface) object["surface"] = surface_facts(*verdict.surface);
  if (verdict.unique) object["unique"] = *verdict.unique;
  if (verdict.canonical) object["canonical"] = *verdict.canonical;
  Json tallies = Json::array();
  for (const auto& [rule, tally] : verdict.tallies()) {
    Json entry = {{"rule", identifier(rule)}, {"count", tally.count}};
    if (tally.worst_margin) entry["worst_relative_margin"] = value(*tally.worst_margin);
    tallies.push_back(entry);
  }
  object["rules"] = tallies;
  if (!verdict.causes.empty()) object["causes"] = causes(verdict.causes);
  Json violations = Json::array();
  for (const Violation& broken : verdict.violations())
    violations.push_back(violation(broken, mesh, domain));
  object["violations"] = std::move(violations);
  return object;
}

}  // namespace circumspect::report
