#include "properties/faulty/plain_delaunay.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::faulty {
namespace {

constexpr Vertex kGhost = -1;

bool is_ghost(const Simplex& simplex) { return contains(simplex, kGhost); }

class PlainDelaunay {
 public:
  PlainDelaunay(const PointArray& points, const Mistakes& mistakes)
      : exact_(exact_points(points)),
        predicates_(points, exact_, mistakes.arithmetic),
        mistakes_(mistakes) {}

  SimplexArray run();

 private:
  void start(const Simplex& first);
  void insert(Vertex u);
  bool is_conflict(const Simplex& simplex, Vertex u) const;
  bool counts_as_inside(int in_ball, const Simplex& simplex) const;
  bool is_beyond(const Simplex& simplex, std::size_t place, Vertex u) const;
  bool has_within(std::span<const std::size_t> axes, const Simplex& simplex, Vertex u) const;
  std::vector<bool> cavity(Vertex u) const;
  std::vector<bool> cavity_by_walk(Vertex u);
  bool is_seen_again(std::size_t simplex);
  std::size_t end_of_walk(Vertex u) const;
  std::optional<std::size_t> neighbor(std::size_t simplex, std::size_t place) const;
  void keep_vertices(std::vector<bool>& cavity) const;
  void fill(const std::vector<bool>& cavity, Vertex u);

  PointSet exact_;
  PlainPredicates predicates_;
  Mistakes mistakes_;
  std::vector<std::uint8_t> stamps_;  // of the insertion that saw a simplex last, or 0
  std::uint8_t stamp_ = 0;
  std::vector<Simplex> simplices_;  // positively oriented; a ghost is, if it lies outside the hull
};

SimplexArray PlainDelaunay::run() {
  if (exact_.empty()) return {};
  std::vector<Vertex> all(exact_.size());
  std::iota(all.begin(), all.end(), Vertex{0});
  const Simplex first = delaunay::first_independent(exact_, all);
  if (first.size() == 1) return {{first[0]}};
  start(mistakes_.first_as_it_comes ? first : positively_oriented(exact_, first));
  for (const Vertex u : all) {
    if (!contains(first, u)) insert(u);
  }
  SimplexArray solid;
  for (const Simplex& simplex : simplices_) {
    if (!is_ghost(simplex)) solid.emplace_back(simplex.begin(), simplex.end());
  }
  return solid;
}

// A ghost simplex on each facet, of the orientation that an outside point in the ghost's place has.
void PlainDelaunay::start(const Simplex& first) {
  simplices_.push_back(first);
  if (mistakes_.no_ghosts) return;
  for (std::size_t place = 0; place < first.size(); ++place) {
    Simplex ghost = with_vertex_replaced(first, place, kGhost);
    std::swap(ghost[0], ghost[1]);
    simplices_.push_back(ghost);
  }
}

void PlainDelaunay::insert(Vertex u) {
  std::vector<bool> deleted =
      mistakes_.search == Search::kEverySimplex ? cavity(u) : cavity_by_walk(u);
  if (mistakes_.keeps_submerged_points &&
      std::find(deleted.begin(), deleted.end(), true) == deleted.end()) {
    for (std::size_t i = 0; i < simplices_.size(); ++i) {
      deleted[i] =
          !is_ghost(simplices_[i]) && has_within(exact_.configuration().axes(), simplices_[i], u);
    }
  }
  if (mistakes_.never_removes_vertices) keep_vertices(deleted);
  fill(deleted, u);
}

bool PlainDelaunay::is_conflict(const Simplex& simplex, Vertex u) const {
  const auto ghost = std::find(simplex.begin(), simplex.end(), kGhost);
  if (ghost == simplex.end() && mistakes_.only_splits) {
    return has_within(exact_.configuration().axes(), simplex, u);
  }
  if (ghost == simplex.end()) {
    return counts_as_inside(predicates_.in_ball(exact_.configuration().axes(), simplex, u),
                            simplex);
  }
  const auto place = static_cast<std::size_t>(ghost - simplex.begin());
  const int side = predicates_.orientation(exact_.configuration().axes(),
                                           with_vertex_replaced(simplex, place, u));
  if (side != 0) return side > 0;
  if (mistakes_.ghosts_forget_their_plane) return false;
  if (mistakes_.ghosts_take_their_plane) return true;
  const Simplex facet = facet_opposite(simplex, place);
  const std::vector<std::size_t> axes = axes_of(exact_.configuration(), facet);
  if (axes.size() + 1 < facet.size()) return false;
  return mistakes_.only_splits ? has_within(axes, facet, u)
                               : predicates_.in_ball(axes, facet, u) > 0;
}

bool PlainDelaunay::counts_as_inside(int in_ball, const Simplex& simplex) const {
  if (in_ball != 0 || mistakes_.tie == Tie::kNo) return in_ball > 0;
  return mistakes_.tie == Tie::kYes || simplex[0] > simplex[1];
}

// Is u strictly on the other side of the facet opposite the vertex in that place?
bool PlainDelaunay::is_beyond(const Simplex& simplex, std::size_t place, Vertex u) const {
  return predicates_.orientation(exact_.configuration().axes(),
                                 with_vertex_replaced(simplex, place, u)) < 0;
}

// Is u in the closed simplex?
bool PlainDelaunay::has_within(std::span<const std::size_t> axes, const Simplex& simplex,
                               Vertex u) const {
  const int inside = predicates_.orientation(axes, simplex);
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const Simplex replaced = with_vertex_replaced(simplex, place, u);
    if (predicates_.orientation(axes, replaced) * inside < 0) return false;
  }
  return true;
}

std::vector<bool> PlainDelaunay::cavity(Vertex u) const {
  std::vector<bool> deleted;
  for (const Simplex& simplex : simplices_) deleted.push_back(is_conflict(simplex, u));
  return deleted;
}

// Has the search for this point been there before? Says so of others too, once the stamps wrap
// round.
bool PlainDelaunay::is_seen_again(std::size_t simplex) {
  if (!mistakes_.stamps_in_a_byte) return false;
  return std::exchange(stamps_[simplex], stamp_) == stamp_;
}

std::vector<bool> PlainDelaunay::cavity_by_walk(Vertex u) {
  std::vector<bool> deleted(simplices_.size());
  stamps_.resize(simplices_.size());
  ++stamp_;
  if (simplices_.empty()) return deleted;
  std::vector<std::size_t> layer = {end_of_walk(u)};
  deleted[layer[0]] = true;
  for (std::size_t count = 0; count < mistakes_.most_layers && !layer.empty(); ++count) {
    std::vector<std::size_t> next;
    for (const std::size_t one : layer) {
      for (std::size_t place = 0; place < simplices_[one].size(); ++place) {
        const auto across = neighbor(one, place);
        if (!across || deleted[*across] || is_seen_again(*across) ||
            !is_conflict(simplices_[*across], u) || next.size() == mistakes_.most_waiting) {
          continue;
        }
        deleted[*across] = true;
        next.push_back(*across);
      }
    }
    layer = next;
  }
  return deleted;
}

// A visibility walk from the simplex made last, until no facet has the point beyond it.
std::size_t PlainDelaunay::end_of_walk(Vertex u) const {
  std::size_t here = simplices_.size();
  while (here > 1 && is_ghost(simplices_[here - 1])) --here;
  here = here == 0 ? 0 : here - 1;
  for (std::size_t step = 0; step < mistakes_.most_steps; ++step) {
    if (is_ghost(simplices_[here])) return here;
    std::size_t place = 0;
    while (place < simplices_[here].size() && !is_beyond(simplices_[here], place, u)) ++place;
    if (place == simplices_[here].size()) return here;
    const auto across = neighbor(here, place);
    if (!across) return here;
    here = *across;
  }
  return here;
}

std::optional<std::size_t> PlainDelaunay::neighbor(std::size_t simplex, std::size_t place) const {
  const Simplex facet = facet_opposite(simplices_[simplex], place);
  for (std::size_t i = 0; i < simplices_.size(); ++i) {
    const auto has = [&](Vertex v) { return contains(simplices_[i], v); };
    if (i != simplex && std::all_of(facet.begin(), facet.end(), has)) return i;
  }
  return std::nullopt;
}

// Takes simplices out of the cavity as long as some vertex would be left with none.
void PlainDelaunay::keep_vertices(std::vector<bool>& deleted) const {
  std::map<Vertex, std::size_t> left;
  for (std::size_t i = 0; i < simplices_.size(); ++i) {
    for (const Vertex v : simplices_[i]) left[v] += deleted[i] ? 0u : 1u;
  }
  for (std::size_t i = 0; i < simplices_.size(); ++i) {
    const auto is_lost = [&left](Vertex v) { return left[v] == 0; };
    if (!deleted[i] || std::none_of(simplices_[i].begin(), simplices_[i].end(), is_lost)) continue;
    deleted[i] = false;
    for (const Vertex v : simplices_[i]) ++left[v];
  }
}

// Replaces the deleted simplices by one for each facet of the cavity.
void PlainDelaunay::fill(const std::vector<bool>& deleted, Vertex u) {
  std::vector<Simplex> kept, cavity;
  std::vector<std::uint8_t> stamps;
  for (std::size_t i = 0; i < simplices_.size(); ++i) {
    (deleted[i] ? cavity : kept).push_back(simplices_[i]);
    if (!deleted[i] && i < stamps_.size()) stamps.push_back(stamps_[i]);
  }
  stamps_ = std::move(stamps);
  for (const auto uses : ByFacet(facet_uses(cavity))) {
    if (uses.size() > 1) continue;
    kept.push_back(with_vertex_replaced(cavity[uses[0].simplex], uses[0].opposite, u));
  }
  simplices_ = std::move(kept);
}

}  // namespace

SimplexArray plain_delaunay(const PointArray& points, const Mistakes& mistakes) {
  return PlainDelaunay(points, mistakes).run();
}

}  // namespace circumspect::faulty
