#include "command/compare/comparison.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

std::size_t shown(std::size_t count, std::size_t most) {
  return most == 0 ? count : std::min(count, most);
}

Side side(const LoadedMesh& input, const std::vector<Vertex>& points,
          const std::vector<Simplex>& simplices, const std::vector<bool>& are_repeated,
          std::size_t most) {
  const Mesh& mesh = input.mesh;
  Side side{input.name, points.size()};
  for (std::size_t i = 0; i < shown(points.size(), most); ++i) {
    const Vertex v = points[i];
    NamedPoint& named = side.points.emplace_back(NamedPoint{mesh.label(v), mesh.point(v), {}});
    if (mesh.is_weighted()) named.weight = mesh.weight(v);
  }
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    std::size_t& count = are_repeated[i] ? side.repeated_count : side.simplex_count;
    std::vector<Simplex>& some = are_repeated[i] ? side.repeated : side.simplices;
    ++count;
    if (most != 0 && some.size() == most) continue;
    Simplex& labels = some.emplace_back(simplices[i]);
    for (Vertex& v : labels) v = mesh.label(v);
  }
  return side;
}

std::string coordinates_text(const NamedPoint& point) {
  std::string text;
  for (const Rational& x : point.coordinates)
    text += (text.empty() ? "" : ", ") + to_text_of_double_or_fraction(x);
  if (point.weight) text += "; weight " + to_text_of_double_or_fraction(*point.weight);
  return text;
}

// "and 7 more", where not all are shown.
std::string rest(const Side& side, std::string_view what, std::size_t count, std::size_t shown) {
  if (shown == count) return "";
  return fmt::format("only in {}: {} more {}; --max-errors 0 shows all\n", on_one_line(side.name),
                     count - shown, what);
}

std::string text_of(const Side& side) {
  const std::string name = on_one_line(side.name);
  std::string text;
  for (const NamedPoint& point : side.points) {
    text += fmt::format("only in {}: point {} ({})\n", name, point.label, coordinates_text(point));
  }
  text += rest(side, "points", side.point_count, side.points.size());
  for (const Simplex& simplex : side.simplices) {
    text += fmt::format("only in {}: simplex {}\n", name, fmt::join(simplex, " "));
  }
  text += rest(side, "simplices", side.simplex_count, side.simplices.size());
  for (const Simplex& simplex : side.repeated) {
    text += fmt::format("listed once more in {}: simplex {}\n", name, fmt::join(simplex, " "));
  }
  if (side.repeated.size() < side.repeated_count) {
    text += fmt::format("listed once more in {}: {} more; --max-errors 0 shows all\n", name,
                        side.repeated_count - side.repeated.size());
  }
  return text;
}

report::Json json_of(const Side& side) {
  report::Json points = report::Json::array();
  for (const NamedPoint& point : side.points) {
    report::Json entry = {{"index", point.label},
                          {"coordinates", report::point(point.coordinates)}};
    if (point.weight) entry["weight"] = to_string(*point.weight);
    points.push_back(std::move(entry));
  }
  report::Json simplices = report::Json::array();
  for (const Simplex& simplex : side.simplices) simplices.push_back(simplex);
  return {{"point_count", side.point_count},
          {"simplex_count", side.simplex_count},
          {"points", points},
          {"simplices", simplices},
          {"repeated_count", side.repeated_count},
          {"repeated", side.repeated}};
}

std::string counts(const Side& side) {
  return fmt::format("{} {} only in {}", report::counted(side.point_count, "point"),
                     report::counted(side.simplex_count, "simplex", "simplices"),
                     on_one_line(side.name));
}

std::string repeated_counts(const Side& side) {
  if (side.repeated_count == 0) return "";
  return fmt::format(", {} listed once more in {}",
                     report::counted(side.repeated_count, "simplex", "simplices"),
                     on_one_line(side.name));
}

}  // namespace

Comparison compared(const LoadedMesh& a, const LoadedMesh& b, const check::Difference& found,
                    std::size_t most) {
  return {a.mesh.points(), a.mesh.simplices.size(), a.mesh.is_weighted() || b.mesh.is_weighted(),
          side(a, found.points_only_in_a, found.simplices_only_in_a, found.b_has_too, most),
          side(b, found.points_only_in_b, found.simplices_only_in_b, found.a_has_too, most)};
}

std::string text_of(const Comparison& comparison) {
  return text_of(comparison.only_in_a) + text_of(comparison.only_in_b);
}

std::string line_of(const ComparedFiles& files, const Comparison& comparison) {
  return comparison.is_same()
             ? fmt::format("same: {} {} {} {}{}", on_one_line(files.a), on_one_line(files.b),
                           report::counted(comparison.points_of_a, "point"),
                           report::counted(comparison.simplices_of_a, "simplex", "simplices"),
                           comparison.weighted ? " weighted" : "")
             : fmt::format("differ: {}, {}{}{}", counts(comparison.only_in_a),
                           counts(comparison.only_in_b), repeated_counts(comparison.only_in_a),
                           repeated_counts(comparison.only_in_b));
}

report::Json json_of(const ComparedFiles& files, const Comparison& comparison,
                     const std::vector<std::string>& notes) {
  return {{"a", files.a},
          {"b", files.b},
          {"same", comparison.is_same()},
          {"weighted", comparison.weighted},
          {"notes", notes},
          {"only_in_a", json_of(comparison.only_in_a)},
          {"only_in_b", json_of(comparison.only_in_b)}};
}

}  // namespace circumspect::cli
