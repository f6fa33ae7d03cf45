#include "oracle/judge/complex/improper_pairs.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/complex/carriers.hpp"

namespace circumspect::check {
namespace {

using definition::CrossingFaces;
using definition::HangingVertex;
using definition::ImproperPairs;

// Do the relative interiors of two faces without a common vertex meet in one point, and none of
// smaller faces?
bool meet_in_one_point(const OrientationSigns& orientation, const Simplex& f, const Simplex& g) {
  for (const Vertex v : f) {
    if (contains(g, v)) return false;
  }
  const Carriers both = carriers(orientation, f, g);
  if (both.of_a != f || both.of_b != g) return false;
  Simplex all = f;
  all.insert(all.end(), g.begin(), g.end());
  return axes_of(orientation.points(), all).size() + 2 == all.size();
}

class Pairs {
 public:
  Pairs(const Configuration& points, const definition::ListedComplex& listed,
        const definition::SetApart& apart, const std::vector<std::size_t>& among)
      : orientation_(points), sorted_(apart.merged.size()) {
    std::vector<Simplex> compared;
    for (const std::size_t s : apart.compared) {
      sorted_[s] = sorted(apart.merged[s]);
      compared.push_back(sorted_[s]);
      for (const Vertex v : sorted_[s]) at_vertex_[v].push_back(s);
    }
    for (const std::size_t s : apart.flat) {
      sorted_[s] = sorted(apart.merged[s]);
      for (const Vertex v : sorted_[s]) flat_at_vertex_[v].push_back(s);
    }
    const std::vector<Box> boxes = CellBoxes(listed.points).of(compared);
    const BoxIndex tree(boxes);
    for (const std::size_t i : among) {
      pairs_.is_cut = pairs_.overlaps.size() >= kMostOverlaps;
      if (pairs_.is_cut) break;
      for (const std::size_t j : tree.meeting(boxes[i])) {
        const bool comes_again = std::binary_search(among.begin(), among.end(), j);
        if (j == i || (comes_again && j < i)) continue;
        compare(apart.compared[std::min(i, j)], apart.compared[std::max(i, j)]);
      }
    }
    std::sort(pairs_.overlaps.begin(), pairs_.overlaps.end());
  }

  ImproperPairs found() && {
    if (pairs_.is_cut) return std::move(pairs_);
    for (const HangingVertex& one : hanging_) {
      if (!is_repetition({one.vertex}, one.face)) pairs_.hanging.push_back(one);
    }
    for (const CrossingFaces& one : crossing_) {
      if (!is_repetition(one.first, one.second)) pairs_.crossing.push_back(one);
    }
    return std::move(pairs_);
  }

 private:
  static constexpr std::size_t kMostOverlaps = 50'000;

  void compare(std::size_t i, std::size_t j) {
    const Carriers both = carriers(orientation_, sorted_[i], sorted_[j]);
    if (both.are_proper()) return;
    if (both.of_a == sorted_[i] && both.of_b == sorted_[j]) {
      pairs_.overlaps.push_back({i, j});
      overlaps_.insert({i, j});
      return;
    }
    bool hangs = false;
    std::vector<CrossingFaces> of_pair;
    for (const Simplex& f : faces(both.of_a)) {
      for (const Simplex& g : faces(both.of_b)) {
        if (!meet_in_one_point(orientation_, f, g)) continue;
        if (f.size() == 1) hanging_.insert({f.front(), g});
        if (g.size() == 1) hanging_.insert({g.front(), f});
        hangs |= f.size() == 1 || g.size() == 1;
        if (f.size() > 1 && g.size() > 1) of_pair.push_back({std::min(f, g), std::max(f, g)});
      }
    }
    if (!hangs) crossing_.insert(of_pair.begin(), of_pair.end());
  }

  static const std::vector<std::size_t>& at(const std::map<Vertex, std::vector<std::size_t>>& lists,
                                            const Simplex& face) {
    static const std::vector<std::size_t> kNone;
    const auto found = lists.find(face.front());
    return found == lists.end() ? kNone : found->second;
  }
  bool is_repetition(const Simplex& f, const Simplex& g) const {
    for (const std::size_t s : at(flat_at_vertex_, f)) {
      if (has_face(sorted_[s], f) && has_face(sorted_[s], g)) return true;
    }
    if (overlaps_.empty()) return false;
    for (const std::size_t i : at(at_vertex_, f)) {
      if (!has_face(sorted_[i], f)) continue;
      for (const std::size_t j : at(at_vertex_, g)) {
        if (has_face(sorted_[j], g) && overlaps_.contains({std::min(i, j), std::max(i, j)})) {
          return true;
        }
      }
    }
    return false;
  }

  const OrientationSigns orientation_;
  std::vector<Simplex> sorted_;
  std::map<Vertex, std::vector<std::size_t>> at_vertex_, flat_at_vertex_;
  ImproperPairs pairs_;
  std::set<std::array<std::size_t, 2>> overlaps_;
  std::set<HangingVertex> hanging_;
  std::set<CrossingFaces> crossing_;
};

}  // namespace

ImproperPairs improper_pairs(const Configuration& points, const definition::ListedComplex& listed,
                             const definition::SetApart& apart,
                             const std::vector<std::size_t>& among) {
  return Pairs(points, listed, apart, among).found();
}

}  // namespace circumspect::check
