#include "command/build/steps.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "kernel/exact/number_text.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "oracle/picture/picture.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

using report::Json;

// Ghost simplices have no place in a picture; the words count them.
Json solid(const std::vector<Simplex>& simplices) {
  Json array = Json::array();
  for (const Simplex& simplex : simplices) {
    if (!is_ghost(simplex)) array.push_back(simplex);
  }
  return array;
}

// "3 triangles and 1 ghost triangle"
std::string counts(const std::vector<Simplex>& simplices, int dimension) {
  const auto ghosts =
      static_cast<std::size_t>(std::count_if(simplices.begin(), simplices.end(), is_ghost));
  const std::size_t others = simplices.size() - ghosts;
  std::string text;
  if (others > 0) text = report::counted_simplices(others, dimension);
  if (ghosts > 0) {
    text += fmt::format("{}{} ghost {}", others > 0 ? " and " : "", ghosts,
                        report::simplices_noun(dimension, ghosts));
  }
  return text;
}

// The lifted companions, stretched along the axis to the extent of the points, which is an affine
// map.
std::vector<Point> lifted_to_be_seen(const PointSet& points) {
  std::vector<Rational> heights;
  Rational extent = 0;
  for (std::size_t axis = 0; axis < points.ambient_dimension(); ++axis) {
    Rational low = points[0][axis];
    Rational high = low;
    for (const Point& p : points.points()) {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    extent = std::max<Rational>(extent, high - low);
  }
  // About the middle of the points the paraboloid is seen best; that changes no lower facet.
  Point middle(points.ambient_dimension(), Rational(0));
  for (const Point& p : points.points()) {
    for (std::size_t axis = 0; axis < middle.size(); ++axis) middle[axis] += p[axis];
  }
  const Rational count = to_integer(static_cast<std::int64_t>(points.size()));
  for (Rational& x : middle) x /= count;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto vertex = static_cast<Vertex>(v);
    heights.push_back(squared_length(points[vertex] - middle) - points.weight(vertex));
  }
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const Rational range = *high - *low;
  const Rational factor = sign(range) == 0 ? Rational(0) : Rational(extent / range);
  std::vector<Point> all;
  for (const Point& p : points.points()) {
    all.push_back(p);
    all.back().emplace_back(0);
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    Point up = points.points()[v];
    up.emplace_back(extent / 4 + (heights[v] - *low) * factor);
    all.push_back(std::move(up));
  }
  return all;
}

}  // namespace

Steps::Steps(const ExactMesh& mesh) : mesh_(mesh) {}

Json& Steps::frame(const std::string& step, const std::string& words) {
  Json next = {{"step", step}, {"words", words}};
  if (frames_.size() == kMostSteps) {
    ++left_out_;
    return beyond_ = std::move(next);
  }
  frames_.push_back(std::move(next));
  return frames_.back();
}

std::string Steps::label(const Simplex& simplex) const { return report::labels(mesh_, simplex); }

std::string Steps::named(const Simplex& simplex) const {
  const auto dimension = static_cast<int>(simplex.size()) - 1;
  if (!is_ghost(simplex)) return report::simplices_noun(dimension, 1) + " " + label(simplex);
  Simplex facet = simplex;
  std::erase(facet, kGhost);
  return fmt::format("the ghost {} on {}", report::simplices_noun(dimension, 1), label(facet));
}

std::string Steps::why_in_ball(const Simplex& simplex, Vertex v) const {
  if (mesh_.points.is_weighted()) return "lifted, it lies below the witness plane";
  return in_ball(mesh_.points.configuration(), simplex, v) > 0
             ? "it lies in the open circumball"
             : "it lies on the circumsphere, and the perturbation puts it inside";
}

void Steps::inserted(const delaunay::Insertion& insertion) {
  const int k = mesh_.points.dimension();
  const std::string in_space = k == 3 ? "3D" : "";
  if (insertion.vertex == kGhost) {
    frame("The first simplex", fmt::format("It begins with {}: the first points that are affinely "
                                           "independent, and a ghost on each facet.",
                                           counts(insertion.created, k)))["created"] =
        solid(insertion.created);
    return;
  }
  const Simplex u = {insertion.vertex};
  const Simplex& found = insertion.deleted.front();
  Json& location =
      frame("Point location",
            is_ghost(found)
                ? fmt::format("Vertex {} is in conflict with {}: it lies beyond this facet of the "
                              "hull.",
                              label(u), named(found))
                : fmt::format("Vertex {} is in conflict with {}: {}.", label(u), named(found),
                              why_in_ball(found, insertion.vertex)));
  location["vertex"] = insertion.vertex;
  if (is_ghost(found)) {
    Simplex facet = found;
    std::erase(facet, kGhost);
    location["face"] = facet;
  } else {
    location["look"] = Json::array({found});
    location["ball"] = found;
  }
  Json& cavity = frame("DigCavity" + in_space,
                       fmt::format("{} in conflict with vertex {} {} deleted: the cavity.",
                                   counts(insertion.deleted, k), label(u),
                                   insertion.deleted.size() == 1 ? "is" : "are"));
  cavity["vertex"] = insertion.vertex;
  cavity["deleted"] = solid(insertion.deleted);
  Json& filled = frame("InsertVertex" + in_space,
                       fmt::format("Each facet of the cavity is joined to vertex {}: {}.", label(u),
                                   counts(insertion.created, k)));
  filled["vertex"] = insertion.vertex;
  filled["created"] = solid(insertion.created);
}

void Steps::finished(const OrientedFacet& facet, std::optional<Vertex> apex) {
  const std::string unfinished = fmt::format(
      "{} {} is unfinished.", frames_.empty() ? "A facet of the hull is the seed:" : "The facet",
      label(facet.vertices));
  if (!apex) {
    frame("Finish", unfinished + " No point is in front of it: on this side is nothing.")["face"] =
        facet.vertices;
    return;
  }
  const Simplex simplex = join(facet, *apex);
  Json& next = frame("Finish", fmt::format("{} Of the points in front of it, the circumball with "
                                           "vertex {} has no other inside.",
                                           unfinished, label({*apex})));
  next["face"] = facet.vertices;
  next["vertex"] = *apex;
  next["created"] = Json::array({simplex});
  if (!mesh_.points.is_weighted()) next["ball"] = simplex;
}

void Steps::flipped(const delaunay::FlipStep& step) {
  const delaunay::ExtendedFlip& flip = step.flip;
  if (step.facet) {
    Json& before = frame("Flip algorithm",
                         fmt::format("The facet {} is not locally Delaunay.", label(*step.facet)));
    before["face"] = *step.facet;
    before["look"] = flip.deleted;
    if (!mesh_.points.is_weighted()) before["ball"] = flip.deleted.front();
  }
  const std::string words =
      step.facet     ? fmt::format("The flip {} removes it.", flip.name())
      : !step.vertex ? "It begins with the first points that are affinely independent."
      : flip.deleted.empty()
          ? fmt::format(
                "Vertex {} lies outside: it is joined to the facets of the hull that it sees.",
                label({*step.vertex}))
          : fmt::format("Vertex {} is inserted by the flip {}, which parts the face that holds it.",
                        label({*step.vertex}), flip.name());
  Json& next = frame(step.facet    ? "Flip"
                     : step.vertex ? "Insert a vertex"
                                   : "The first simplex",
                     words);
  next["deleted"] = flip.deleted;
  next["created"] = flip.created;
  if (step.vertex) next["vertex"] = *step.vertex;
}

void Steps::flipped(const std::string& polygon, const constrained::TimedFlip& timed) {
  Json& next = frame("FlipInsertPolygon",
                     fmt::format("Polygon {} is inserted: at time {} the flip {} is due.", polygon,
                                 to_decimal(timed.time.standard), timed.flip.name()));
  next["deleted"] = timed.flip.deleted;
  next["created"] = timed.flip.created;
}

void Steps::wrapped(const Face& facet, bool is_lower) {
  is_lifted_ = mesh_.points.ambient_dimension() == 2;
  if (frames_.empty()) {
    frame("Parabolic lifting map",
          is_lifted_ ? "Each point is lifted to the height of the squared distance from the middle "
                       "of all. Heights are drawn to another scale than the plane, an affine map."
                     : "Each point is lifted along one more axis, which no picture shows.");
  }
  Json& next = frame("Convex hull of the lifted points",
                     fmt::format("The facet on {} faces {}.", label(facet),
                                 is_lower ? "downwards, and is a cell of the Delaunay subdivision"
                                          : "upwards or is vertical, and is left out"));
  if (is_lifted_) {
    next["outline"] = facet;
    next["lower"] = is_lower;
  } else if (is_lower && facet.size() <= mesh_.points.ambient_dimension() + 1) {
    next["look"] = Json::array({facet});
  }
}

void Steps::begun(const std::vector<Simplex>& simplices, const std::string& words) {
  frame("Begin", words)["created"] = simplices;
}

void Steps::done(const std::vector<Simplex>& simplices) {
  frames_.push_back(Json{
      {"step", "Done"},
      {"words",
       fmt::format("The triangulation has {}.",
                   report::counted_simplices(
                       simplices.size(), simplices.empty()
                                             ? mesh_.points.dimension()
                                             : static_cast<int>(simplices.front().size()) - 1))},
      {"all", simplices}});
}

Json Steps::json() {
  Mesh mesh;
  const PointSet& points = mesh_.points;
  if (points.empty() || points.ambient_dimension() < 1 || points.ambient_dimension() > 3 ||
      points.size() > kMostStepPoints) {
    return {};
  }
  const std::size_t dimension = is_lifted_ ? 3 : points.ambient_dimension();
  mesh.coordinates =
      numbers_of(is_lifted_ ? lifted_to_be_seen(points) : points.points(), dimension);
  Witness all;
  all.vertices = all_vertices(points);
  if (is_lifted_) {
    for (Vertex v = 0; points.names(v); ++v) {
      all.vertices.push_back(v + static_cast<Vertex>(points.size()));
    }
  }
  Json picture = picture::pictures({&all, 1}, mesh).front();
  for (std::size_t i = 0; i < picture["names"].size(); ++i) {
    picture["names"][i] =
        i < points.size() ? std::to_string(mesh_.label(static_cast<Vertex>(i))) : "";
  }
  Json steps = {{"picture", std::move(picture)}, {"frames", std::move(frames_)}};
  if (left_out_ > 0) {
    steps["left_out"] = fmt::format("{} more {} not shown.", report::counted(left_out_, "step"),
                                    left_out_ == 1 ? "is" : "are");
  }
  return steps;
}

}  // namespace circumspect::cli
