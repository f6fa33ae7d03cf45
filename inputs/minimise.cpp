#include "inputs/minimise.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect::generators {
namespace {

// How often, and how long, the predicate may still be asked.
class Budget {
 public:
  explicit Budget(const MinimiseLimits& limits) : limits_(limits) {}

  bool is_spent() const {
    return (limits_.stop != nullptr && *limits_.stop) || tries_ >= limits_.tries ||
           std::chrono::steady_clock::now() - start_ >= limits_.time;
  }
  // Counts a try; false if there is none left.
  bool take() {
    if (is_spent()) return false;
    ++tries_;
    return true;
  }

 private:
  MinimiseLimits limits_;
  std::size_t tries_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// A sublist of `items` that `accepts` still accepts and from which no single item can be left out,
// unless the budget runs out first. Chunks are halved until they are single items; those at the end
// go first. Returns whether anything was dropped.
template <class Item>
bool drop_items(std::vector<Item>& items, const Budget& budget,
                const std::function<bool(const std::vector<Item>&)>& accepts) {
  const std::size_t before = items.size();
  std::size_t chunk = std::max<std::size_t>(items.size() / 2, 1);
  while (!items.empty() && !budget.is_spent()) {
    bool dropped = false;
    for (std::size_t end = items.size(); end > 0 && !budget.is_spent();) {
      const std::size_t begin = end > chunk ? end - chunk : 0;
      std::vector<Item> rest(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(begin));
      rest.insert(rest.end(), items.begin() + static_cast<std::ptrdiff_t>(end), items.end());
      if (accepts(rest)) {
        items = std::move(rest);
        dropped = true;
      }
      end = begin;
    }
    if (chunk == 1 && !dropped) break;
    chunk = std::max<std::size_t>(std::min(chunk / 2, items.size() / 2), 1);
  }
  return items.size() < before;
}

std::size_t distinct_points(const PointsCase& set) {
  return std::set<Point>(set.points.begin(), set.points.end()).size();
}

std::vector<std::size_t> places(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

bool leave_out_points(PointsCase& set, const Budget& budget,
                      const StillFails<PointsCase>& accepts) {
  std::vector<std::size_t> kept = places(set.points.size());
  const PointsCase whole = set;
  const bool dropped = drop_items<std::size_t>(
      kept, budget,
      [&](const std::vector<std::size_t>& part) { return accepts(chosen(whole, part)); });
  if (dropped) set = chosen(whole, kept);
  return dropped;
}

// A point is removed with everything that happens to it.
UpdatesCase chosen(const UpdatesCase& whole, const std::vector<std::size_t>& kept) {
  UpdatesCase part{chosen(whole.set, kept)};
  for (Update update : whole.updates) {
    const auto place = std::lower_bound(kept.begin(), kept.end(), update.point);
    const bool is_there = place != kept.end() && *place == update.point;
    if (update.kind != UpdateKind::kRestore && !is_there) continue;
    update.point = static_cast<std::size_t>(place - kept.begin());
    if (update.kind == UpdateKind::kRestore) update.point = 0;
    part.updates.push_back(update);
  }
  return part;
}

bool leave_out_points(UpdatesCase& whole, const Budget& budget,
                      const StillFails<UpdatesCase>& accepts) {
  std::vector<std::size_t> kept = places(whole.set.points.size());
  const UpdatesCase all = whole;
  const bool dropped = drop_items<std::size_t>(
      kept, budget,
      [&](const std::vector<std::size_t>& part) { return accepts(chosen(all, part)); });
  if (dropped) whole = chosen(all, kept);
  return dropped;
}

// The cells of a domain and its vertices, each an item that may be dropped.
struct Part {
  std::vector<std::size_t> polygons;
  std::vector<std::size_t> segments;
  std::vector<std::size_t> hole_seeds;
};

template <class T>
std::vector<T> those(const std::vector<T>& all, const std::vector<std::size_t>& which) {
  std::vector<T> part;
  for (const std::size_t i : which) part.push_back(all[i]);
  return part;
}

PiecewiseLinearInput with_cells(const PiecewiseLinearInput& input,
                                const std::vector<std::size_t>& cells) {
  Part part;
  const std::size_t polygons = input.polygons.size();
  const std::size_t segments = input.segments.size();
  for (const std::size_t cell : cells) {
    if (cell < polygons) {
      part.polygons.push_back(cell);
    } else if (cell < polygons + segments) {
      part.segments.push_back(cell - polygons);
    } else {
      part.hole_seeds.push_back(cell - polygons - segments);
    }
  }
  PiecewiseLinearInput result = input;
  result.polygons = those(input.polygons, part.polygons);
  result.segments = those(input.segments, part.segments);
  result.hole_seeds = those(input.hole_seeds, part.hole_seeds);
  return result;
}

using AcceptsInput = std::function<bool(const PiecewiseLinearInput&)>;

bool drop_cells(PiecewiseLinearInput& input, const Budget& budget, const AcceptsInput& accepts) {
  const std::size_t count = input.polygons.size() + input.segments.size() + input.hole_seeds.size();
  std::vector<std::size_t> kept = places(count);
  const PiecewiseLinearInput whole = input;
  const bool dropped = drop_items<std::size_t>(
      kept, budget,
      [&](const std::vector<std::size_t>& part) { return accepts(with_cells(whole, part)); });
  if (dropped) input = with_cells(whole, kept);
  return dropped;
}

PiecewiseLinearInput without(PiecewiseLinearInput input, const std::vector<std::size_t>& unused,
                             const std::vector<std::size_t>& kept) {
  std::vector<bool> dropped(input.points.size(), false);
  for (const std::size_t v : unused) dropped[v] = true;
  for (const std::size_t v : kept) dropped[v] = false;
  drop_points(input, dropped);
  return input;
}

bool drop_unused_points(PiecewiseLinearInput& input, const Budget& budget,
                        const AcceptsInput& accepts) {
  const std::vector<bool> used = is_used(input);
  std::vector<std::size_t> unused;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) unused.push_back(v);
  }
  std::vector<std::size_t> kept = unused;
  const PiecewiseLinearInput whole = input;
  const bool dropped = drop_items<std::size_t>(
      kept, budget,
      [&](const std::vector<std::size_t>& part) { return accepts(without(whole, unused, part)); });
  if (dropped) input = without(whole, unused, kept);
  return dropped;
}

// The vertices and hole seeds of a domain as a set of points, and back.
PointsCase all_points(const PiecewiseLinearInput& input) {
  PointsCase set{input.points, {}};
  set.points.insert(set.points.end(), input.hole_seeds.begin(), input.hole_seeds.end());
  for (const PolygonLines& polygon : input.polygons) {
    set.points.insert(set.points.end(), polygon.hole_seeds.begin(), polygon.hole_seeds.end());
  }
  return set;
}

PiecewiseLinearInput with_points(PiecewiseLinearInput input, const PointsCase& set) {
  auto next = set.points.begin();
  for (Point& point : input.points) point = *next++;
  for (Point& seed : input.hole_seeds) seed = *next++;
  for (PolygonLines& polygon : input.polygons) {
    for (Point& seed : polygon.hole_seeds) seed = *next++;
  }
  return input;
}

bool move_points(PiecewiseLinearInput& input, const Budget& budget, const AcceptsInput& accepts) {
  PointsCase set = all_points(input);
  const bool simpler = simplify_numbers(
      set, [&](const PointsCase& moved) { return accepts(with_points(input, moved)); },
      [&] { return budget.is_spent(); });
  if (simpler) input = with_points(input, set);
  return simpler;
}

}  // namespace

PointsCase minimised(PointsCase set, const StillFails<PointsCase>& still_fails,
                     const MinimiseLimits& limits) {
  Budget budget(limits);
  const bool may_repeat = distinct_points(set) < set.points.size();
  const StillFails<PointsCase> accepts = [&](const PointsCase& candidate) {
    if (budget.is_spent()) return false;
    if (!may_repeat && distinct_points(candidate) < candidate.points.size()) return false;
    return budget.take() && still_fails(candidate);
  };
  const auto is_over = [&] { return budget.is_spent(); };
  leave_out_points(set, budget, accepts);
  while (simplify_numbers(set, accepts, is_over) && leave_out_points(set, budget, accepts)) {
  }
  return set;
}

UpdatesCase minimised(UpdatesCase whole, const StillFails<UpdatesCase>& still_fails,
                      const MinimiseLimits& limits) {
  Budget budget(limits);
  const StillFails<UpdatesCase> accepts = [&](const UpdatesCase& candidate) {
    if (budget.is_spent() || !is_sound(candidate)) return false;
    return budget.take() && still_fails(candidate);
  };
  for (bool again = true; again;) {
    again = leave_out_points(whole, budget, accepts);
    const UpdatesCase before = whole;
    again = drop_items<Update>(whole.updates, budget,
                               [&](const std::vector<Update>& part) {
                                 return accepts({before.set, part});
                               }) ||
            again;
    again = simplify_numbers(
                whole.set,
                [&](const PointsCase& moved) {
                  return accepts({moved, whole.updates});
                },
                [&] { return budget.is_spent(); }) ||
            again;
  }
  return whole;
}

ComplexCase minimised(ComplexCase whole, const StillFails<ComplexCase>& still_fails,
                      const MinimiseLimits& limits) {
  Budget budget(limits);
  const bool is_valid = validated(whole.input, 1).has_value();
  const AcceptsInput accepts = [&](const PiecewiseLinearInput& candidate) {
    if (candidate.points.empty() || budget.is_spent()) return false;
    if (is_valid && !validated(candidate, 1)) return false;
    return budget.take() && still_fails({whole.family, candidate});
  };
  for (bool again = true; again;) {
    again = drop_cells(whole.input, budget, accepts);
    again = drop_unused_points(whole.input, budget, accepts) || again;
    again = move_points(whole.input, budget, accepts) || again;
  }
  return whole;
}

}  // namespace circumspect::generators
