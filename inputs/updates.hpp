// Points that come and go, to test a dynamic structure.
#pragma once

#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"

namespace circumspect::generators {

enum class UpdateKind {
  kInsert,   // a point comes
  kDelete,   // a point goes
  kRestore,  // the structure is written, destroyed, and read again
};

std::string_view name(UpdateKind kind);

struct Update {
  UpdateKind kind = UpdateKind::kRestore;
  std::size_t point = 0;  // its place in UpdatesCase::set; kRestore: nothing

  bool operator==(const Update&) const = default;
};

// All points that are ever present, and the updates. Points that no update inserts are present from
// the beginning. A point is inserted at most once and deleted at most once; one that comes back is
// a new point with the same coordinates.
struct UpdatesCase {
  PointsCase set;
  std::vector<Update> updates = {};
};

// Is each update possible when its turn comes, and are no two equal points present at the same
// time?
bool is_sound(const UpdatesCase& whole);

// The places of the points that are present at first, and of those present in the end, in the order
// of insertion, beginning with those present from the start. Requires: the updates are sound.
std::vector<std::size_t> first_places(const UpdatesCase& whole);
std::vector<std::size_t> last_places(const UpdatesCase& whole);
inline PointsCase last_points(const UpdatesCase& whole) {
  return chosen(whole.set, last_places(whole));
}

// Is there a time at which the points present lie in a hyperplane, perhaps because they are too
// few?
bool is_ever_flat(const UpdatesCase& whole, std::size_t dimension);

// Updates of the kinds asked for, about as many as there are points: some of the points are
// inserted later, some are deleted, and some of those come back. Equal points are used once.
UpdatesCase with_updates(Dice& dice, const PointsCase& set, const std::set<UpdateKind>& kinds);

}  // namespace circumspect::generators
