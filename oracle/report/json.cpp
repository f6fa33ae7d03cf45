#include "oracle/report/json.hpp"

#include <set>

#include "oracle/report/wording.hpp"
#include "reference/exact/write_number.hpp"

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
  Json object = Json::object();
  for (const Vertex v : named) {
    if (mesh.points.names(v)) object[std::to_string(mesh.label(v))] = point(mesh.points[v]);
  }
  return object;
}

Json violation(const Violation& broken, const Mesh& mesh) {
  const Witness& witness = broken.witness;
  Json object = {{"rule", identifier(broken.rule)}, {"meaning", meaning(broken.rule)}};
  Json simplices = Json::array();
  for (const Simplex& simplex : witness.simplices) simplices.push_back(labels_of(mesh, simplex));
  object["simplices"] = simplices;
  if (witness.face) object["face"] = labels_of(mesh, *witness.face);
  object["vertices"] = labels_of(mesh, witness.vertices);
  if (witness.point) object["point"] = point(*witness.point);
  if (witness.ball) object["ball"] = ball(*witness.ball);
  Json values = Json::object();
  for (const NamedValue& named : witness.values) values[named.name] = value(named.value);
  object["values"] = values;
  object["coordinates"] = coordinates_of(witness, mesh);
  return object;
}

}  // namespace

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

Json verdict(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name, check::By by) {
  Json object = {{"mesh", mesh_name},
                 {"claim", circumspect::name(verdict.claim())},
                 {"by", name(by)},
                 {"verdict", verdict.holds() ? "holds" : "fails"},
                 {"points", verdict.points},
                 {"simplices", verdict.simplices},
                 {"dimension", verdict.dimension}};
  if (verdict.unique) object["unique"] = *verdict.unique;
  if (verdict.canonical) object["canonical"] = *verdict.canonical;
  Json tallies = Json::array();
  for (const auto& [rule, tally] : verdict.tallies()) {
    Json entry = {{"rule", identifier(rule)}, {"count", tally.count}};
    if (tally.worst_margin) entry["worst_relative_margin"] = value(*tally.worst_margin);
    tallies.push_back(entry);
  }
  object["rules"] = tallies;
  Json violations = Json::array();
  for (const Violation& broken : verdict.violations())
    violations.push_back(violation(broken, mesh));
  object["violations"] = violations;
  return object;
}

}  // namespace circumspect::report
