// What only one of two meshes has: a card for each place at which they differ.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "oracle/model/printable.hpp"
#include "oracle/picture/page.hpp"
#include "oracle/picture/picture.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::picture {
namespace {

using report::Json;

// Of each mesh so many simplices, and of one place so many, are looked at.
constexpr std::size_t kMostCompared = 2000;
constexpr std::size_t kMostOfPlace = 30;

// Simplices of two meshes by one numbering: points are one if their coordinates and weights are.
class TwoMeshes {
 public:
  TwoMeshes(const Mesh& a, const Mesh& b, const check::Difference& found) : meshes_{&a, &b} {
    const std::array<const std::vector<Simplex>*, 2> own = {&found.simplices_only_in_a,
                                                            &found.simplices_only_in_b};
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t i = 0; i < std::min(own[side]->size(), kMostCompared); ++i) {
        const Simplex& simplex = (*own[side])[i];
        cells_.push_back({side, numbered(simplex, side), meshes_[side]->listed(simplex)});
      }
    }
    const std::array<const std::vector<Vertex>*, 2> points = {&found.points_only_in_a,
                                                              &found.points_only_in_b};
    for (std::size_t side = 0; side < 2; ++side) {
      for (const Vertex v : *points[side]) {
        if (lonely_.size() == kMostCards) break;
        const std::size_t before = points_.size();
        const Vertex vertex = number(v, side);
        if (points_.size() > before)
          lonely_.push_back({side, {vertex}, {meshes_[side]->label(v)}, true});
      }
    }
    for (std::size_t side = 0; side < 2; ++side) add_common(side, *own[side]);
  }

  // A simplex, or a point that is a corner of none of these, which only one mesh has.
  struct Cell {
    std::size_t side;
    Simplex vertices;
    Simplex labels;  // as its user lists it
    bool is_point = false;
  };

  const std::vector<Cell>& cells() const { return cells_; }
  const std::vector<Cell>& lonely_points() const { return lonely_; }
  const Point& point(Vertex v) const { return points_[static_cast<std::size_t>(v)]; }

  // "3" where both meshes call the point so, or "A3", "B4", "A3 B4".
  std::string name(Vertex v) const {
    const auto& [a, b] = labels_[static_cast<std::size_t>(v)];
    if (a && b && *a == *b) return std::to_string(*a);
    return (a ? fmt::format("A{}", *a) : "") + (a && b ? " " : "") +
           (b ? fmt::format("B{}", *b) : "");
  }

  // The simplices that both meshes have beside them.
  Mesh common() const {
    Mesh mesh;
    mesh.coordinates = numbers_of(points_, meshes_[0]->dimension());
    mesh.simplices = IndexLists(std::vector<Simplex>(common_.begin(), common_.end()));
    return mesh;
  }

  // The cells, those together that share a facet, or an edge if they are of different meshes: the
  // triangles of a square's two diagonals, the cells of a cube.
  std::vector<std::vector<Cell>> places() const {
    std::map<Simplex, std::vector<std::size_t>> of_face;
    const auto for_each_face = [this](std::size_t cell, const auto& visitor) {
      const Simplex simplex = sorted(cells_[cell].vertices);
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        visitor(facet_opposite(simplex, i), true);
        for (std::size_t j = 0; j < i; ++j) visitor({simplex[j], simplex[i]}, false);
      }
    };
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      for_each_face(i, [&](const Simplex& face, bool) { of_face[face].push_back(i); });
    }
    std::vector<bool> seen(cells_.size());
    std::vector<std::vector<Cell>> found;
    for (std::size_t first = 0; first < cells_.size(); ++first) {
      if (seen[first]) continue;
      std::vector<std::size_t> place = {first};
      seen[first] = true;
      for (std::size_t i = 0; i < place.size(); ++i) {
        const std::size_t cell = place[i];
        for_each_face(cell, [&](const Simplex& face, bool is_facet) {
          for (const std::size_t next : of_face[face]) {
            if (seen[next] || place.size() == kMostOfPlace) continue;
            if (!is_facet && cells_[next].side == cells_[cell].side) continue;
            seen[next] = true;
            place.push_back(next);
          }
        });
      }
      std::sort(place.begin(), place.end());
      std::vector<Cell>& cells = found.emplace_back();
      for (const std::size_t cell : place) cells.push_back(cells_[cell]);
    }
    return found;
  }

 private:
  Vertex number(Vertex v, std::size_t side) {
    const Mesh& mesh = *meshes_[side];
    if (!mesh.names(v)) return -1;
    Point point = mesh.point(v);
    const auto [place, is_new] =
        numbers_.emplace(std::pair(point, mesh.weight(v)), static_cast<Vertex>(points_.size()));
    if (is_new) {
      points_.push_back(std::move(point));
      labels_.emplace_back();
    }
    labels_[static_cast<std::size_t>(place->second)][side] = mesh.label(v);
    return place->second;
  }

  Simplex numbered(const Simplex& simplex, std::size_t side) {
    Simplex numbers;
    for (const Vertex v : simplex) numbers.push_back(number(v, side));
    return numbers;
  }

  // The simplices that have a vertex of those above, and that the other mesh has as well.
  void add_common(std::size_t side, std::vector<Simplex> own) {
    const Mesh& mesh = *meshes_[side];
    const auto count = static_cast<Vertex>(points_.size());
    std::vector<bool> is_near(mesh.points());
    for (Vertex v = 0; v < static_cast<Vertex>(mesh.points()); ++v) {
      const auto found = numbers_.find(std::pair(mesh.point(v), mesh.weight(v)));
      if (found == numbers_.end() || found->second >= count) continue;
      is_near[static_cast<std::size_t>(v)] = true;
      labels_[static_cast<std::size_t>(found->second)][side] = mesh.label(v);
    }
    for (Simplex& simplex : own) simplex = sorted(std::move(simplex));
    std::sort(own.begin(), own.end());
    for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
      const Simplex simplex = mesh.simplices[i];
      const auto names = [&](Vertex v) { return mesh.names(v); };
      const auto near = [&](Vertex v) { return is_near[static_cast<std::size_t>(v)]; };
      if (!std::all_of(simplex.begin(), simplex.end(), names) ||
          std::none_of(simplex.begin(), simplex.end(), near) ||
          std::binary_search(own.begin(), own.end(), sorted(simplex))) {
        continue;
      }
      common_.insert(sorted(numbered(simplex, side)));
    }
  }

  std::array<const Mesh*, 2> meshes_;
  std::map<std::pair<Point, Rational>, Vertex> numbers_;
  std::vector<Point> points_;
  std::vector<std::array<std::optional<Vertex>, 2>> labels_;
  std::vector<Cell> cells_;
  std::vector<Cell> lonely_;
  std::set<Simplex> common_;
};

// What a card says of some cells: as the report of a violation, and `groups` of its simplices.
Json difference_card(const TwoMeshes& meshes, const std::vector<TwoMeshes::Cell>& cells,
                     const Json& report, Witness& witness) {
  Json card = {{"meaning", ""},
               {"groups", Json::array()},
               {"simplices", Json::array()},
               {"vertices", Json::array()},
               {"coordinates", Json::object()},
               {"values", Json::object()}};
  const bool is_point = cells.front().is_point;
  std::array<std::size_t, 2> counts = {};
  for (const TwoMeshes::Cell& cell : cells) {
    ++counts[cell.side];
    card[is_point ? "vertices" : "simplices"].push_back(is_point ? Json(cell.labels.front())
                                                                 : Json(cell.labels));
    if (is_point) {
      witness.vertices.push_back(cell.vertices.front());
    } else {
      witness.simplices.push_back(cell.vertices);
    }
    for (const Vertex v : cell.vertices) {
      if (v >= 0) card["coordinates"][meshes.name(v)] = report::point(meshes.point(v));
    }
  }
  std::string meaning;
  for (std::size_t side = 0; side < 2; ++side) {
    if (counts[side] == 0) continue;
    const std::string which = side == 0 ? "A" : "B";
    meaning += (meaning.empty() ? "" : ", and ") +
               (is_point ? report::counted(counts[side], "point")
                         : report::counted(counts[side], "simplex", "simplices")) +
               " only in " + which;
    card["groups"].push_back(
        {{"role", side == 0 ? "first" : "second"},
         {"words", fmt::format("only in {}: {}", which,
                               on_one_line(report[side == 0 ? "a" : "b"].get<std::string>()))},
         {"count", counts[side]}});
  }
  card["meaning"] = meaning;
  card["caption"] = is_point ? "The point that is marked is one of only one mesh."
                             : "Where the meshes differ: the simplices of A and those of B, each "
                               "in its colour. What is grey, both have.";
  card["around"] = "simplices that both meshes have";
  return card;
}

}  // namespace

void Page::add_difference(const Mesh& a, const Mesh& b, const check::Difference& found,
                          const Json& report, const std::string& line) {
  const auto name = [&report](const char* key) {
    return on_one_line(report[key].get<std::string>());
  };
  Json result = {{"heading", fmt::format("A: {}, B: {}", name("a"), name("b"))},
                 {"line", line},
                 {"verdict", found.empty() ? "holds" : "fails"},
                 {"noun", "Difference"},
                 {"notes", Json::array()},
                 {"cards", Json::array()},
                 {"pictures", Json::array()}};
  for (const Json& note : report["notes"]) {
    result["notes"].push_back(on_one_line(note.get<std::string>()));
  }
  if (a.dimension() != b.dimension()) {
    result["cards_note"] = fmt::format(
        "The points of A have {}, and those of B have {}, so no picture shows both.",
        report::counted(a.dimension(), "coordinate"), report::counted(b.dimension(), "coordinate"));
  } else {
    const TwoMeshes meshes(a, b, found);
    std::vector<std::vector<TwoMeshes::Cell>> places = meshes.places();
    for (const TwoMeshes::Cell& point : meshes.lonely_points()) places.push_back({point});
    const std::size_t room = kMostCards - std::min(cards_, kMostCards);
    if (places.size() > room) places.resize(room);
    cards_ += places.size();
    std::vector<Witness> witnesses(places.size());
    std::size_t shown = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      result["cards"].push_back(difference_card(meshes, places[i], report, witnesses[i]));
      shown += witnesses[i].simplices.size();
    }
    const std::size_t all = found.simplices_only_in_a.size() + found.simplices_only_in_b.size();
    if (shown < all) {
      result["cards_note"] =
          fmt::format("{} of {} that differ {} in a card here.", shown,
                      report::counted(all, "simplex", "simplices"), shown == 1 ? "is" : "are");
    }
    for (Json& picture : pictures(witnesses, meshes.common())) {
      if (!picture.contains("why_none")) {
        picture["boundary"] =
            Json::array();  // of the part that is drawn, which is none of the mesh
        for (Json& own : picture["names"]) {
          const std::string number = own.get<std::string>();
          if (!number.empty()) own = meshes.name(std::stoll(number));
        }
      }
      result["pictures"].push_back(std::move(picture));
    }
  }
  results_.push_back(std::move(result));
  text_ += line + "\n";
  if (title_.empty()) title_ = line;
}

}  // namespace circumspect::picture
