// Points that come and go: what a structure that lives is tried with.
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
  kRestore,  // the structure is written somewhere, forgotten, and read again
};

std::string_view name(UpdateKind kind);

struct Update {
  UpdateKind kind = UpdateKind::kRestore;
  std::size_t point = 0;  // its place in UpdatesCase::set; kRestore: nothing

  bool operator==(const Update&) const = default;
};

// Every point that is ever there, and what happens. Those that no update inserts are there from the beginning. A point
// is inserted once and deleted once at most; one that comes back is another one with the same coordinates.
struct UpdatesCase {
  PointsCase set;
  std::vector<Update> updates = {};
};

// Is each update possible when its turn comes, and are no two equal points there at the same time?
bool is_sound(const UpdatesCase& whole);

// The places of the points that are there at first, and those that are there in the end, in the order in which they
// came: those of the beginning first. Requires: it is sound.
std::vector<std::size_t> first_places(const UpdatesCase& whole);
std::vector<std::size_t> last_places(const UpdatesCase& whole);
inline PointsCase last_points(const UpdatesCase& whole) {
  return chosen(whole.set, last_places(whole));
}

// Is there a time at which the points that are there lie in a hyperplane, or are too few not to?
bool is_ever_flat(const UpdatesCase& whole, std::size_t dimension);

// Updates of the kinds asked for, about as many as there are points: some of the points come later, some go,
// some of those come back. Of equal points one is taken.
UpdatesCase with_updates(Dice& dice, const PointsCase& set, const std::set<UpdateKind>& kinds);

}  // namespace circumspect::generators
