#include "oracle/cli/inspect_simplex.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "oracle/report/wording.hpp"
#include "reference/delaunay/simplex_predicates.hpp"
#include "reference/exact/affine_hull.hpp"
#include "reference/exact/number_text.hpp"

namespace circumspect::cli {
namespace {

// The point that the user calls so; −1 if there is none.
Vertex vertex_of(const Mesh& mesh, std::string_view label) {
  Vertex own = 0;
  const auto [end, error] = std::from_chars(label.data(), label.data() + label.size(), own);
  if (error != std::errc() || end != label.data() + label.size()) return -1;
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (mesh.label(v) == own) return v;
  }
  return -1;
}

tl::expected<Simplex, std::string> read_simplex(const Mesh& mesh, std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  Simplex simplex;
  for (std::size_t begin = text.find_first_not_of(' '); begin != std::string::npos;) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string label = text.substr(begin, end - begin);
    const Vertex v = vertex_of(mesh, label);
    if (v < 0) {
      return tl::unexpected(
          fmt::format("--simplex: expected indices of points, found \"{}\"", label));
    }
    simplex.push_back(v);
    begin = text.find_first_not_of(' ', end);
  }
  if (simplex.empty()) {
    return tl::unexpected(std::string("--simplex: expected indices of points, found none"));
  }
  const AffineHull hull = affine_hull(coordinates(mesh.points, simplex));
  if (hull.basis.size() != simplex.size()) {
    return tl::unexpected(fmt::format("--simplex: expected affinely independent points, found {}",
                                      report::labels(mesh, simplex)));
  }
  return simplex;
}

std::string_view in_a_word(delaunay::Delaunayhood delaunayhood) {
  switch (delaunayhood) {
    case delaunay::Delaunayhood::kNotDelaunay:
      return "not-delaunay";
    case delaunay::Delaunayhood::kDelaunay:
      return "delaunay";
    case delaunay::Delaunayhood::kStronglyDelaunay:
      return "strongly-delaunay";
  }
  return "";
}

std::string ball_text(const Ball& ball) {
  std::string centre;
  for (const Rational& x : ball.centre) centre += " " + to_decimal(x);
  return fmt::format(", ball of centre ~{} squared radius ~ {}", centre,
                     to_decimal(ball.squared_radius));
}

std::string obstruction_text(const Mesh& mesh, const delaunay::SimplexDelaunayhood& answer) {
  const bool open = answer.delaunayhood == delaunay::Delaunayhood::kNotDelaunay;
  return fmt::format(", every {} circumball contains one of {}", open ? "open" : "closed",
                     report::labels(mesh, answer.obstruction->points));
}

}  // namespace

tl::expected<SimplexAnswer, std::string> inspect_simplex(const Mesh& mesh,
                                                         const std::string& vertices) {
  const auto simplex = read_simplex(mesh, vertices);
  if (!simplex) return tl::unexpected(simplex.error());
  const delaunay::SimplexDelaunayhood answer = delaunay::delaunayhood(mesh.points, *simplex);
  SimplexAnswer said;
  said.text =
      fmt::format("simplex {}: {}", report::labels(mesh, *simplex), in_a_word(answer.delaunayhood));
  report::Json labels = report::Json::array();
  for (const Vertex v : *simplex) labels.push_back(mesh.label(v));
  said.json = {{"simplex", labels}, {"answer", in_a_word(answer.delaunayhood)}};
  if (answer.ball) {
    said.text += ball_text(*answer.ball);
    said.json["ball"] = report::ball(*answer.ball);
  }
  if (answer.obstruction) {
    said.text += obstruction_text(mesh, answer);
    report::Json obstruction = report::Json::object();
    for (std::size_t i = 0; i < answer.obstruction->points.size(); ++i) {
      const Vertex v = answer.obstruction->points[i];
      obstruction[std::to_string(mesh.label(v))] = to_string(answer.obstruction->coefficients[i]);
    }
    said.json["obstruction"] = {{"convex_combination", obstruction},
                                {"power", report::value(answer.obstruction->power)}};
  }
  return said;
}

}  // namespace circumspect::cli
