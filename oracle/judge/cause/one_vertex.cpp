// One vertex, or one simplex, that all violations name.
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/cause/bare_facets.hpp"
#include "oracle/judge/cause/rows.hpp"
#include "oracle/judge/fast_view.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

// Fewer violations name too much in common to tell anything.
constexpr std::size_t kFewest = 3;
// Stars that are larger than this are not tried elsewhere.
constexpr std::size_t kMostInStar = 1'000;

// The rules whose violations a vertex in the wrong place causes.
bool is_about_places(Rule rule) {
  const Stage of = stage(rule);
  return rule == Rule::kDegenerateSimplex || rule == Rule::kInverted ||
         rule == Rule::kOrientation || of == Stage::kFacets || of == Stage::kHull ||
         of == Stage::kDelaunay;
}

// The simplices at a vertex, and those across the facets opposite it, all of points.
class Star {
 public:
  Star(const Mesh& mesh, Vertex vertex) : mesh_(mesh), vertex_(vertex) {
    look_at_simplices(mesh, [&](const auto& view) {
      for (std::size_t s = 0; s < view.size(); ++s) {
        const auto row = view.row(s);
        const auto at = std::find(row.begin(), row.end(), vertex);
        if (at == row.end() || !name_points(mesh, row)) continue;
        Simplex facet(row.begin(), row.end());
        facet.erase(facet.begin() + (at - row.begin()));
        facets_.insert(sorted(std::move(facet)));
      }
      for (const Simplex& facet : facets_) link_.insert(facet.begin(), facet.end());
      for (std::size_t s = 0; s < view.size() && facets_.size() <= kMostInStar; ++s) {
        add_across(view.row(s));
      }
    });
  }

  // A place for the vertex at which its simplices fit to those across: the middle of its
  // neighbours. Nothing if they do not fit there, or do already, or if the star is too large.
  std::optional<Point> better_place() const {
    if (fits_at(mesh_.point(vertex_))) return std::nullopt;
    std::vector<Point> around;
    for (const Vertex v : link_) around.push_back(mesh_.point(v));
    const Point middle = barycentre(around);
    if (!fits_at(middle)) return std::nullopt;
    return middle;
  }

 private:
  // Is the point strictly on the other side of each facet than the simplex across?
  bool fits_at(const Point& point) const {
    return std::all_of(across_.begin(), across_.end(), [&](const auto& one) {
      const auto& [facet, apex] = one;
      std::vector<Point> points;
      for (const Vertex v : facet) points.push_back(mesh_.point(v));
      points.push_back(point);
      points.push_back(mesh_.point(apex));
      const Configuration exact(points);
      const Simplex own = first_subset(facet.size() + 1);
      const Simplex other = with_vertex_replaced(own, facet.size(), own.back() + 1);
      std::vector<std::size_t> axes;
      for (std::size_t axis = 0; axis < mesh_.dimension(); ++axis) axes.push_back(axis);
      return orientation(exact, axes, own) * orientation(exact, axes, other) < 0;
    });
  }

  template <class Row>
  void add_across(const Row& row) {
    std::size_t in_link = 0;
    for (const auto v : row) in_link += link_.contains(v) ? 1 : 0;
    if (in_link + 1 < row.size() || !name_points(mesh_, row)) return;
    for (std::size_t place = 0; place < row.size(); ++place) {
      const Simplex facet = sorted(facet_opposite(Simplex(row.begin(), row.end()), place));
      if (row[place] != vertex_ && facets_.contains(facet)) across_.emplace(facet, row[place]);
    }
  }

  const Mesh& mesh_;
  Vertex vertex_;
  std::set<Simplex> facets_;  // opposite the vertex
  std::set<Vertex> link_;
  std::map<Simplex, Vertex> across_;
};

struct Named {
  Simplex vertices = {};       // that most violations name
  std::size_t violations = 0;  // that name them
  std::size_t rules = 0;
  Rule rule = {};  // the first
};

// The vertices that the most violations of the rules name, which all name them.
Named named_by_most(const Verdict& verdict) {
  std::map<Vertex, Named> of_vertex;
  for (const auto& [rule, tally] : verdict.tallies()) {
    if (!is_about_places(rule) || tally.count < kFewest) continue;
    for (const Vertex v : tally.in_all) {
      Named& named = of_vertex[v];
      if (named.rules++ == 0) named.rule = rule;
      named.violations += tally.count;
    }
  }
  Named most;
  for (auto& [vertex, named] : of_vertex) {
    if (named.violations < most.violations) continue;
    if (named.violations > most.violations) most = named;
    most.vertices.push_back(vertex);
  }
  return most;
}

// How many simplices have all of these vertices.
std::size_t simplices_with(const Mesh& mesh, const Simplex& vertices) {
  std::size_t count = 0;
  look_at_simplices(mesh, [&](const auto& view) {
    for (std::size_t s = 0; s < view.size(); ++s) {
      const auto row = view.row(s);
      const bool has_all = std::all_of(vertices.begin(), vertices.end(), [&](Vertex v) {
        return std::find(row.begin(), row.end(), v) != row.end();
      });
      count += has_all ? 1 : 0;
    }
  });
  return count;
}

// Where most simplices have a vertex, it says little that all violations name it.
bool is_seldom(const Mesh& mesh, Vertex vertex) {
  return 2 * simplices_with(mesh, {vertex}) < mesh.simplices.size();
}

std::string decimals(const Point& point) {
  std::string text;
  for (const Rational& x : point) text += (text.empty() ? "(" : ", ") + to_decimal(x);
  return text + ")";
}

}  // namespace

std::optional<Cause> one_vertex(Case& of) {
  const Named named = named_by_most(of.verdict());
  if (named.vertices.empty()) return std::nullopt;
  const std::size_t size = of.mesh().dimension() + 1;
  const std::string all =
      fmt::format("all {} violations{}", named.violations,
                  named.rules == 1 ? fmt::format(" of {}", identifier(named.rule)) : " of these");
  if (named.vertices.size() <= size + 1) {
    std::optional<Vertex> moved;
    std::optional<Point> middle;
    std::size_t mendable = 0;
    for (const Vertex v : named.vertices) {
      if (!is_seldom(of.mesh(), v)) continue;
      const auto found = Star(of.mesh(), v).better_place();
      if (!found) continue;
      ++mendable;
      moved = v;
      middle = found;
    }
    if (mendable == 1) {
      return of.cause(
          "vertex-out-of-place",
          fmt::format("{} name vertex {}, which is not between its neighbours: in their "
                      "middle, {}, its simplices would fit",
                      all, of.mesh().label(*moved), decimals(*middle)),
          named.violations);
    }
  }
  if (named.vertices.size() == size && simplices_with(of.mesh(), named.vertices) == 1 &&
      is_seldom(of.mesh(), named.vertices.front())) {
    return of.cause("one-simplex",
                    fmt::format("{} name the {} {}", all,
                                report::simplices_noun(static_cast<int>(of.mesh().dimension()), 1),
                                report::labels(of.mesh(), named.vertices)),
                    named.violations);
  }
  if (named.vertices.size() > 1 || !is_seldom(of.mesh(), named.vertices.front())) {
    return std::nullopt;
  }
  return of.cause("one-vertex",
                  fmt::format("{} name vertex {}", all, of.mesh().label(named.vertices.front())),
                  named.violations);
}

}  // namespace circumspect::check
