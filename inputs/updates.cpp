#include "inputs/updates.hpp"

#include <algorithm>
#include <map>

#include "inputs/in_doubles.hpp"

namespace circumspect::generators {
namespace {

// The places of the points that are present, one update after another. Impossible updates are
// skipped.
class Present {
 public:
  explicit Present(const UpdatesCase& whole) : whole_(whole) {
    std::vector<bool> comes(whole.set.points.size(), false);
    for (const Update& update : whole.updates) {
      if (update.kind == UpdateKind::kInsert && update.point < comes.size()) {
        comes[update.point] = true;
      }
    }
    for (std::size_t v = 0; v < comes.size(); ++v) {
      if (!comes[v]) is_sound_ = add(v) && is_sound_;
    }
  }

  // False if this is not possible now.
  bool take(const Update& update) {
    if (update.kind == UpdateKind::kRestore) return true;
    if (update.point >= whole_.set.points.size()) return false;
    return update.kind == UpdateKind::kInsert ? add(update.point) : remove(update.point);
  }
  bool began_soundly() const { return is_sound_; }
  const std::vector<std::size_t>& places() const { return places_; }

 private:
  bool add(std::size_t place) {
    if (!was_there_.insert(place).second) return false;
    if (!points_.insert(whole_.set.points[place]).second) return false;
    places_.push_back(place);
    return true;
  }
  bool remove(std::size_t place) {
    const auto found = std::find(places_.begin(), places_.end(), place);
    if (found == places_.end()) return false;
    places_.erase(found);
    points_.erase(whole_.set.points[place]);
    return true;
  }

  const UpdatesCase& whole_;
  std::vector<std::size_t> places_;
  std::set<std::size_t> was_there_;
  std::set<Point> points_;
  bool is_sound_ = true;
};

// Do the points at these places lie in a hyperplane? If not, `basis` gets some that do not.
bool are_flat(const PointsCase& set, const std::vector<std::size_t>& places, std::size_t dimension,
              std::vector<std::size_t>& basis) {
  const AffineHull hull = affine_hull(chosen(set, places).points);
  basis.clear();
  for (const std::size_t i : hull.basis) basis.push_back(places[i]);
  return hull.dimension < static_cast<int>(dimension);
}

}  // namespace

std::string_view name(UpdateKind kind) {
  switch (kind) {
    case UpdateKind::kInsert:
      return "insert";
    case UpdateKind::kDelete:
      return "delete";
    case UpdateKind::kRestore:
      return "restore";
  }
  return "";
}

bool is_sound(const UpdatesCase& whole) {
  Present present(whole);
  return present.began_soundly() &&
         std::all_of(whole.updates.begin(), whole.updates.end(),
                     [&](const Update& update) { return present.take(update); });
}

std::vector<std::size_t> first_places(const UpdatesCase& whole) { return Present(whole).places(); }

std::vector<std::size_t> last_places(const UpdatesCase& whole) {
  Present present(whole);
  for (const Update& update : whole.updates) present.take(update);
  return present.places();
}

bool is_ever_flat(const UpdatesCase& whole, std::size_t dimension) {
  Present present(whole);
  std::vector<std::size_t> basis;
  if (are_flat(whole.set, present.places(), dimension, basis)) return true;
  for (const Update& update : whole.updates) {
    present.take(update);
    const bool may_be = update.kind == UpdateKind::kDelete &&
                        std::find(basis.begin(), basis.end(), update.point) != basis.end();
    if (may_be && are_flat(whole.set, present.places(), dimension, basis)) return true;
  }
  return false;
}

UpdatesCase with_updates(Dice& dice, const PointsCase& set, const std::set<UpdateKind>& kinds) {
  UpdatesCase whole{without_repeated_points(set)};
  const std::size_t count = whole.set.points.size();
  const std::vector<UpdateKind> asked(kinds.begin(), kinds.end());
  const bool inserts = kinds.count(UpdateKind::kInsert) != 0;
  // In one case in four, all points but a few are inserted one by one; in the others, about half
  // are. In three cases in four, there are always enough points for a simplex and one more.
  const std::size_t dimension = count == 0 ? 0 : set.points.front().size();
  const std::size_t least = dice.below(4) == 0 ? 0 : std::min(dimension + 2, count);
  const std::size_t at_first = inserts ? least + dice.below(count - least + 1) : count;
  std::vector<std::size_t> present(at_first);
  for (std::size_t v = 0; v < at_first; ++v) present[v] = v;
  std::vector<Point> gone;  // whose points may come back
  std::size_t next = at_first;
  const std::size_t steps = (count - at_first) + dice.below(count + 2);
  for (std::size_t step = 0; step < steps && !asked.empty(); ++step) {
    Update update{asked[dice.below(asked.size())]};
    if (update.kind == UpdateKind::kInsert) {
      const bool comes_back = !gone.empty() && (next == count || dice.below(3) == 0);
      if (!comes_back && next == count) continue;
      if (comes_back) {
        // A new point with the coordinates of a deleted one.
        const std::size_t which = dice.below(gone.size());
        update.point = whole.set.points.size();
        whole.set.points.push_back(gone[which]);
        if (!whole.set.weights.empty()) {
          const auto first =
              std::find(whole.set.points.begin(), whole.set.points.end(), gone[which]);
          const auto place = static_cast<std::size_t>(first - whole.set.points.begin());
          whole.set.weights.push_back(whole.set.weights[place]);
        }
        gone.erase(gone.begin() + static_cast<std::ptrdiff_t>(which));
      } else {
        update.point = next++;
      }
      present.push_back(update.point);
    } else if (update.kind == UpdateKind::kDelete) {
      if (present.size() <= least) continue;
      const std::size_t which = dice.below(present.size());
      update.point = present[which];
      gone.push_back(whole.set.points[update.point]);
      present.erase(present.begin() + static_cast<std::ptrdiff_t>(which));
    }
    whole.updates.push_back(update);
  }
  // The remaining points are inserted one after another.
  for (; next < count; ++next) whole.updates.push_back({UpdateKind::kInsert, next});
  return whole;
}

}  // namespace circumspect::generators
