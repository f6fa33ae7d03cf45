#include "command/inspect/inspect_simplex.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "kernel/complex/circumball.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/report/text.hpp"
#include "reference/delaunay/simplex_predicates.hpp"

namespace circumspect::cli {

namespace {

// Points as the user asks for them.
struct AskedSimplex {
  Simplex vertices = {};
  Simplex indices = {};  // the user's own of each
};

// The point that the user calls so, or an equal one that is left of it; −1 if there is none.
Vertex vertex_of(const ExactMesh& mesh, const std::vector<Duplicate>& repeated, Vertex own) {
  for (const Duplicate& duplicate : repeated) {
    if (index_of_place(duplicate.again, mesh.first_index) != own) continue;
    own = index_of_place(duplicate.kept, mesh.first_index);
    break;
  }
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (mesh.label(v) == own) return v;
  }
  return -1;
}

tl::expected<AskedSimplex, std::string> read_simplex(const ExactMesh& mesh,
                                                     const std::vector<Duplicate>& repeated,
                                                     std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  AskedSimplex asked;
  Simplex& simplex = asked.vertices;
  for (std::size_t begin = text.find_first_not_of(' '); begin != std::string::npos;) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string label = text.substr(begin, end - begin);
    Vertex own = 0;
    const auto read = std::from_chars(label.data(), label.data() + label.size(), own);
    const bool is_index = read.ec == std::errc() && read.ptr == label.data() + label.size();
    const Vertex v = is_index ? vertex_of(mesh, repeated, own) : -1;
    if (v < 0) {
      return tl::unexpected(
          fmt::format("--simplex: expected indices of points, found \"{}\"", label));
    }
    simplex.push_back(v);
    asked.indices.push_back(own);
    begin = text.find_first_not_of(' ', end);
  }
  if (simplex.empty()) {
    return tl::unexpected(std::string("--simplex: expected indices of points, found none"));
  }
  const AffineHull hull = affine_hull(coordinates(mesh.points, simplex));
  if (hull.basis.size() != simplex.size()) {
    return tl::unexpected(fmt::format("--simplex: expected affinely independent points, found {}",
                                      report::joined(asked.indices)));
  }
  return asked;
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

std::string obstruction_text(const ExactMesh& mesh, const delaunay::SimplexDelaunayhood& answer) {
  const bool open = answer.delaunayhood == delaunay::Delaunayhood::kNotDelaunay;
  return fmt::format(", every {} circumball contains one of {}", open ? "open" : "closed",
                     report::labels(mesh, answer.obstruction->points));
}

}  // namespace

tl::expected<SimplexAnswer, std::string> inspect_simplex(const ExactMesh& mesh,
                                                         const std::vector<Duplicate>& repeated,
                                                         const std::string& vertices) {
  const auto asked = read_simplex(mesh, repeated, vertices);
  if (!asked) return tl::unexpected(asked.error());
  const delaunay::SimplexDelaunayhood answer = delaunay::delaunayhood(mesh.points, asked->vertices);
  SimplexAnswer said;
  said.text =
      fmt::format("simplex {}: {}", report::joined(asked->indices), in_a_word(answer.delaunayhood));
  said.json = {{"simplex", asked->indices}, {"answer", in_a_word(answer.delaunayhood)}};
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
