// The ranks of an MPI program, what they send each other, and how equal things meet that several ranks have.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <mpi.h>
#include <sys/resource.h>

namespace circumspect::distributed {

// ---- Course ----
// What a phase of the work cost one rank.

struct Phase {
  std::array<char, 24> name = {};
  double seconds = 0;
  std::uint64_t bytes_sent = 0;  // to other ranks
  std::uint64_t messages = 0;    // that are not empty
  std::uint64_t memory = 0;      // the most bytes that the process had until its end
};

// ---- Ranks ----
// Every member but rank(), size(), is_first() and few() is called by all ranks together, in the same order.

class Ranks {
 public:
  // Fewer items than `few` are never worth sending some at a time. Requires: MPI is initialized, and `communicator`
  // outlives this object; few > 0.
  explicit Ranks(MPI_Comm communicator, std::size_t few = std::size_t{1} << 15)
      : communicator_(communicator), few_(few) {
    int number = 0;
    MPI_Comm_rank(communicator_, &number);
    rank_ = static_cast<std::size_t>(number);
    MPI_Comm_size(communicator_, &number);
    size_ = static_cast<std::size_t>(number);
  }

  std::size_t rank() const { return rank_; }
  std::size_t size() const { return size_; }
  bool is_first() const { return rank_ == 0; }
  std::size_t few() const { return few_; }

  bool any(bool own) const { return most(own ? 1 : 0) > 0; }
  std::uint64_t sum(std::uint64_t own) const { return reduced(own, MPI_SUM); }
  std::uint64_t most(std::uint64_t own) const { return reduced(own, MPI_MAX); }
  std::uint64_t least(std::uint64_t own) const { return reduced(own, MPI_MIN); }
  // The first rank that says yes; size() if none does.
  std::size_t first_with(bool own) const {
    return static_cast<std::size_t>(least(own ? rank_ : size_));
  }

  // The value of one rank, at all.
  template <class Value>
  Value of_rank(std::size_t root, Value value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    MPI_Bcast(&value, sizeof(Value), MPI_BYTE, static_cast<int>(root), communicator_);
    if (rank_ == root) count(sizeof(Value) * (size_ - 1), size_ - 1);
    return value;
  }

  std::string of_rank(std::size_t root, std::string text) {
    text.resize(of_rank(root, text.size()));
    MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_BYTE, static_cast<int>(root),
              communicator_);
    return text;
  }

  // One value of each rank, in their order, at all.
  template <class Value>
  std::vector<Value> of_each(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    std::vector<Value> all(size_);
    MPI_Allgather(&value, sizeof(Value), MPI_BYTE, all.data(), sizeof(Value), MPI_BYTE,
                  communicator_);
    count(sizeof(Value) * (size_ - 1), size_ - 1);
    return all;
  }

  // What other ranks have for this one, in their order, for what it has for each of them; `from`: how many items
  // each of them has sent. Requires: fewer than 2^31 items in all, at each rank.
  template <class Item>
  std::vector<Item> exchanged(std::vector<std::vector<Item>> out,
                              std::vector<int>* from = nullptr) {
    static_assert(std::is_trivially_copyable_v<Item>);
    std::vector<int> counts(size_), from_counts(size_), begins(size_), from_begins(size_);
    for (std::size_t i = 0; i < size_; ++i) {
      counts[i] = static_cast<int>(out[i].size());
      if (i != rank_ && counts[i] > 0) count(sizeof(Item) * out[i].size(), 1);
    }
    MPI_Alltoall(counts.data(), 1, MPI_INT, from_counts.data(), 1, MPI_INT, communicator_);
    std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
    std::exclusive_scan(from_counts.begin(), from_counts.end(), from_begins.begin(), 0);
    std::vector<Item> sent;
    sent.reserve(static_cast<std::size_t>(begins.back() + counts.back()));
    for (std::vector<Item>& some : out) {
      sent.insert(sent.end(), some.begin(), some.end());
      some = {};
    }
    std::vector<Item> received(static_cast<std::size_t>(from_begins.back() + from_counts.back()));
    MPI_Datatype item = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(sizeof(Item), MPI_BYTE, &item);
    MPI_Type_commit(&item);
    MPI_Alltoallv(sent.data(), counts.data(), begins.data(), item, received.data(),
                  from_counts.data(), from_begins.data(), item, communicator_);
    MPI_Type_free(&item);
    if (from != nullptr) *from = std::move(from_counts);
    return received;
  }

  // All items of all ranks, in their order, at the first rank; elsewhere nothing.
  template <class Item>
  std::vector<Item> at_first(std::vector<Item> own) {
    std::vector<std::vector<Item>> out(size_);
    out[0] = std::move(own);
    return exchanged(std::move(out));
  }

  // What was done since the phase before, or since the beginning.
  void end_phase(const std::string& name) {
    const auto now = std::chrono::steady_clock::now();
    now_.name = {};
    name.copy(now_.name.data(), now_.name.size() - 1);
    now_.seconds = std::chrono::duration<double>(now - begin_).count();
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    now_.memory = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
    phases_.push_back(std::exchange(now_, Phase{}));
    begin_ = now;
  }
  const std::vector<Phase>& phases() const { return phases_; }

 private:
  std::uint64_t reduced(std::uint64_t own, MPI_Op operation) const {
    std::uint64_t all = 0;
    MPI_Allreduce(&own, &all, 1, MPI_UINT64_T, operation, communicator_);
    return all;
  }
  void count(std::uint64_t bytes, std::uint64_t messages) {
    now_.bytes_sent += bytes;
    now_.messages += messages;
  }

  MPI_Comm communicator_;
  std::size_t rank_ = 0;
  std::size_t size_ = 1;
  std::size_t few_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Phase now_;
  std::vector<Phase> phases_;
};

// ---- Meeting ----

// The items of the list that are the same, group by group. `hash` and `same` are about items; visit(group) gets
// their places in the list, in no particular order.
template <class Item, class Hash, class Same, class Visit>
void for_each_group(std::span<const Item> items, const Hash& hash, const Same& same,
                    const Visit& visit) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  int bits = 1;
  while ((std::size_t{1} << bits) < 2 * items.size()) ++bits;
  const std::size_t mask = (std::size_t{1} << bits) - 1;
  std::vector<std::uint32_t> firsts(mask + 1, kNone), nexts(items.size(), kNone);
  for (std::size_t i = 0; i < items.size(); ++i) {
    auto slot = static_cast<std::size_t>(hash(items[i]) >> (64 - bits));
    while (firsts[slot] != kNone && !same(items[firsts[slot]], items[i])) slot = (slot + 1) & mask;
    nexts[i] = firsts[slot];
    firsts[slot] = static_cast<std::uint32_t>(i);
  }
  std::vector<std::uint32_t> group;
  for (const std::uint32_t first : firsts) {
    if (first == kNone) continue;
    group.clear();
    for (std::uint32_t i = first; i != kNone; i = nexts[i]) group.push_back(i);
    visit(std::span<const std::uint32_t>(group));
  }
}

// Replies to ranks.
template <class Reply>
using Post = std::vector<std::vector<Reply>>;

// Brings the same things of all ranks together, each at the rank that its hash names: item(i) makes number i of
// the `count` own ones, and hash(i) is its hash. There visit(items, group, post) sees each group of the same and
// posts replies, and take(reply) gets them where they are posted to. Some hashes at a time, so that no more than
// about a sixteenth of the items are on their way. Item has std::uint64_t hash() and bool same(other).
template <class Reply, class HashOf, class MakeItem, class Visit, class Take>
void meet(Ranks& ranks, std::size_t count, const HashOf& hash, const MakeItem& item,
          const Visit& visit, const Take& take) {
  using Item = std::decay_t<decltype(item(std::size_t{0}))>;
  constexpr std::size_t kMostRounds = 16;
  const auto rounds = static_cast<std::size_t>(
      std::min<std::uint64_t>(kMostRounds, ranks.most(count) / ranks.few() + 1));
  // Bits of the hash that for_each_group does not look at first.
  const auto home_of = [&](std::uint64_t one) {
    return (one >> 16 & 0xffffff) * ranks.size() >> 24;
  };
  std::vector<std::uint32_t> order;  // own items, by rounds
  std::vector<std::size_t> begins(rounds + 1, 0);
  begins.back() = count;
  if (rounds > 1) {
    std::vector<std::uint8_t> round_of(count);
    std::vector<std::size_t> next(rounds + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
      round_of[i] = static_cast<std::uint8_t>((hash(i) & 0xffff) * rounds >> 16);
      ++next[round_of[i] + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    begins = next;
    order.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      order[next[round_of[i]]++] = static_cast<std::uint32_t>(i);
    }
  }
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<std::vector<Item>> out(ranks.size());
    for (std::vector<Item>& some : out) {
      some.reserve((begins[round + 1] - begins[round]) / ranks.size() * 9 / 8 + 8);
    }
    for (std::size_t k = begins[round]; k < begins[round + 1]; ++k) {
      const Item one = item(rounds > 1 ? order[k] : k);
      out[home_of(one.hash())].push_back(one);
    }
    const std::vector<Item> items = ranks.exchanged(std::move(out));
    Post<Reply> post(ranks.size());
    for_each_group(
        std::span<const Item>(items), [](const Item& one) { return one.hash(); },
        [](const Item& a, const Item& b) { return a.same(b); },
        [&](std::span<const std::uint32_t> group) { visit(items, group, post); });
    for (const Reply& reply : ranks.exchanged(std::move(post))) take(reply);
  }
}

// The same where there is nothing to reply.
struct NoReply {};
template <class MakeItem, class Visit>
void meet(Ranks& ranks, std::size_t count, const MakeItem& item, const Visit& visit) {
  meet<NoReply>(
      ranks, count, [&](std::size_t i) { return item(i).hash(); }, item,
      [&](const auto& items, std::span<const std::uint32_t> group, Post<NoReply>&) {
        visit(items, group);
      },
      [](NoReply) {});
}

}  // namespace circumspect::distributed
