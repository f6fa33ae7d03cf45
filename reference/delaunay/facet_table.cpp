#include "reference/delaunay/facet_table.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

namespace circumspect {

namespace {

// The row of a facet, its apex yet to be filled in.
std::vector<Vertex> row_of(const OrientedFacet& facet, Vertex tag) {
  std::vector<Vertex> row;
  row.reserve(facet.vertices.size() + 2);
  row.push_back(tag);
  row.insert(row.end(), facet.vertices.begin(), facet.vertices.end());
  row.push_back(0);
  return row;
}

}  // namespace

// The place where the search for a row begins. The tag does not matter, so the two sides of a facet
// are close together: a query for one often follows a query for the other.
std::size_t FacetTable::home(const Vertex* row) const {
  std::uint64_t hash = 0;
  for (std::size_t i = 1; i + 1 < width_; ++i) {
    // The 64-bit finaliser of MurmurHash3, one round a number.
    hash ^= static_cast<std::uint64_t>(row[i]) + 0x9e3779b97f4a7c15u;
    hash *= 0xff51afd7ed558ccdu;
    hash ^= hash >> 33;
  }
  return hash & (slots_ - 1);
}

// The slot that holds the row's facet or, if none does, the empty slot where it belongs.
std::size_t FacetTable::slot_of(const Vertex* row) const {
  std::size_t slot = home(row);
  while (is_entry(slot) && !std::equal(row, row + width_ - 1, at(slot))) {
    slot = (slot + 1) & (slots_ - 1);
  }
  return slot;
}

std::optional<Vertex> FacetTable::find(const OrientedFacet& facet) const {
  if (size_ == 0) return std::nullopt;
  assert(facet.vertices.size() + 2 == width_);
  const std::vector<Vertex> row = row_of(facet, facet.reversed ? kReversed : kForward);
  const std::size_t slot = slot_of(row.data());
  if (!is_entry(slot)) return std::nullopt;
  return apex(slot);
}

bool FacetTable::insert(const OrientedFacet& facet, Vertex apex) {
  std::vector<Vertex> row = row_of(facet, facet.reversed ? kReversed : kForward);
  row.back() = apex;
  if (slots_ == 0) width_ = row.size();
  assert(row.size() == width_);
  if (4 * (size_ + 1) > 3 * slots_) grow();
  const std::size_t slot = slot_of(row.data());
  if (is_entry(slot)) return false;
  std::copy(row.begin(), row.end(), at(slot));
  ++size_;
  return true;
}

void FacetTable::erase(const OrientedFacet& facet) {
  const std::vector<Vertex> row = row_of(facet, facet.reversed ? kReversed : kForward);
  std::size_t hole = slot_of(row.data());
  assert(is_entry(hole));
  // Entries after the hole, up to the next gap, that would be searched from the hole or from before
  // it move up (Knuth's Algorithm R).
  const std::size_t mask = slots_ - 1;
  for (std::size_t next = (hole + 1) & mask; is_entry(next); next = (next + 1) & mask) {
    if (((next - home(at(next))) & mask) < ((next - hole) & mask)) continue;
    std::copy_n(at(next), width_, at(hole));
    hole = next;
  }
  *at(hole) = kEmpty;
  --size_;
}

void FacetTable::grow() {
  const std::size_t old_slots = slots_;
  const std::vector<Vertex> old_rows = std::exchange(rows_, {});
  slots_ = std::max<std::size_t>(64, 2 * old_slots);
  rows_.assign(slots_ * width_, kEmpty);
  for (std::size_t old = 0; old < old_slots; ++old) {
    const Vertex* row = &old_rows[old * width_];
    if (*row != kEmpty) std::copy_n(row, width_, at(slot_of(row)));
  }
}

OrientedFacet FacetTable::facet(std::size_t slot) const {
  const Vertex* row = at(slot);
  return {Simplex(row + 1, row + width_ - 1), *row == kReversed};
}

}  // namespace circumspect
