// Pairs of records with the same hash, without a branch that would be a coin toss.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle/judge/fast/facet_records.hpp"

namespace circumspect::fast {

// Adds up the records of each slot of a table, chosen by bits of their hashes after the first `skipped`.
// The sum less a record is the other one where two are alone in a slot; elsewhere its hash is most likely
// not that of the record. Calls found(record, other, is_pair) for each record; those of no pair are moved
// to the front. Returns how many they are.
template <typename Found>
std::size_t pair_by_sums(const RecordLayout& layout, std::span<std::uint64_t> records, int skipped,
                         std::vector<std::uint64_t>& sums, const Found& found) {
  if (records.empty()) return 0;
  const int shift = 64 - bits_of(records.size());
  sums.assign(std::size_t{1} << (64 - shift), 0);
  const auto sum_of = [&](std::uint64_t record) -> std::uint64_t& {
    return sums[static_cast<std::size_t>(record << skipped >> shift)];
  };
  for (const std::uint64_t record : records) sum_of(record) += record;
  std::size_t left = 0;
  for (const std::uint64_t record : records) {
    const std::uint64_t other = sum_of(record) - record;
    const bool is_pair = layout.same_hash(record, other);
    found(record, other, is_pair);
    records[left] = record;
    left += static_cast<std::size_t>(!is_pair);
  }
  return left;
}

}  // namespace circumspect::fast
