// The ranks of a program, their messages, and how equal items of several ranks meet on one of them.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace circumspect::distributed {

// Transfers bytes between ranks: by MPI (mpi.hpp), or within one process (turns.hpp). All ranks
// together call every member but rank(), size() and room(), in the same order.

enum class Reduction { kSum, kMost, kLeast };

class Communicator {
 public:
  virtual ~Communicator() = default;

  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;
  // How many bytes all ranks together may have in transit at a time; 0: no limit.
  virtual std::size_t room() const { return 0; }

  virtual std::uint64_t reduced(std::uint64_t own, Reduction how) = 0;
  // Gives all ranks the bytes of one rank.
  virtual void broadcast(std::byte* bytes, std::size_t count, std::size_t root) = 0;
  // Gives all ranks the bytes of each rank, the same number of each, in the order of ranks.
  virtual void gather(const std::byte* own, std::size_t count, std::byte* all) = 0;
  // Sends the i-th number of every rank to rank i, which gets them in the order of ranks.
  virtual std::vector<std::uint64_t> turned(const std::vector<std::uint64_t>& own) = 0;
  // Items of `bytes_each` bytes: how many for each rank, stored rank after rank, and how many come
  // from each.
  virtual void exchange(std::size_t bytes_each, const std::byte* sent,
                        const std::vector<std::uint64_t>& counts, std::byte* received,
                        const std::vector<std::uint64_t>& from_counts) = 0;
};

// The cost of a phase of the work on one rank.

struct Phase {
  std::array<char, 24> name = {};
  double seconds = 0;
  std::uint64_t bytes_sent = 0;  // to other ranks
  std::uint64_t messages = 0;    // that are not empty
  std::uint64_t memory = 0;      // the most bytes that the process had until its end
};

// All ranks together call every member, in the same order, except rank(), size(), is_first() and
// those that say how much is sent at a time.

class Ranks {
 public:
  // Fewer items than `few` are never sent in batches. Requires: the communicator outlives this
  // object; few > 0.
  explicit Ranks(Communicator& communicator, std::size_t few = std::size_t{1} << 15)
      : communicator_(communicator),
        rank_(communicator.rank()),
        size_(communicator.size()),
        few_(few) {}

  std::size_t rank() const { return rank_; }
  std::size_t size() const { return size_; }
  bool is_first() const { return rank_ == 0; }

  // Do ranks share the memory of one process? Then data that wait for other ranks should be small.
  bool share_memory() const { return communicator_.room() > 0; }

  // How many items of so many bytes a rank sends at a time, to all others together.
  std::size_t some(std::size_t bytes_each) const {
    const std::size_t room = communicator_.room();
    const std::size_t most = 4 * few_;
    return std::max<std::size_t>(1, room == 0 ? most : std::min(most, room / size_ / bytes_each));
  }
  // In how many rounds the ranks send their items, at most `most` for one rank and `all` together.
  // If there are many, at most about a sixteenth is in transit.
  std::size_t rounds(std::uint64_t most, std::uint64_t all, std::size_t bytes_each) const {
    const std::uint64_t usual = std::min<std::uint64_t>(16, most / few_ + 1);
    const std::size_t room = communicator_.room();
    const std::uint64_t needed = room == 0 ? 1 : all * bytes_each / room + 1;
    return static_cast<std::size_t>(std::min<std::uint64_t>(kMostRounds, std::max(usual, needed)));
  }
  static constexpr std::size_t kMostRounds = std::size_t{1} << 12;

  bool any(bool own) const { return most(own ? 1 : 0) > 0; }
  std::uint64_t sum(std::uint64_t own) const { return communicator_.reduced(own, Reduction::kSum); }
  std::uint64_t most(std::uint64_t own) const {
    return communicator_.reduced(own, Reduction::kMost);
  }
  std::uint64_t least(std::uint64_t own) const {
    return communicator_.reduced(own, Reduction::kLeast);
  }
  // The first rank with a true argument; size() if there is none.
  std::size_t first_with(bool own) const {
    return static_cast<std::size_t>(least(own ? rank_ : size_));
  }

  // Gives all ranks the value of one rank.
  template <class Value>
  Value of_rank(std::size_t root, Value value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    communicator_.broadcast(reinterpret_cast<std::byte*>(&value), sizeof(Value), root);
    if (rank_ == root) count(sizeof(Value) * (size_ - 1), size_ - 1);
    return value;
  }

  std::string of_rank(std::size_t root, std::string text) { return list_of(root, std::move(text)); }
  template <class Item>
  std::vector<Item> of_rank(std::size_t root, std::vector<Item> items) {
    return list_of(root, std::move(items));
  }

  // Gives all ranks one value of each rank, in the order of ranks.
  template <class Value>
  std::vector<Value> of_each(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    std::vector<Value> all(size_);
    communicator_.gather(reinterpret_cast<const std::byte*>(&value), sizeof(Value),
                         reinterpret_cast<std::byte*>(all.data()));
    count(sizeof(Value) * (size_ - 1), size_ - 1);
    return all;
  }

  // Sends items to each rank, and returns those that the ranks have sent to this one, in the order
  // of ranks; `from`: how many items each rank has sent. Requires: fewer than 2^31 items in all, at
  // each rank.
  template <class Item>
  std::vector<Item> exchanged(std::vector<std::vector<Item>> out,
                              std::vector<std::uint64_t>* from = nullptr) {
    static_assert(std::is_trivially_copyable_v<Item>);
    std::vector<std::uint64_t> counts(size_);
    for (std::size_t i = 0; i < size_; ++i) {
      counts[i] = out[i].size();
      if (i != rank_ && counts[i] > 0) count(sizeof(Item) * out[i].size(), 1);
    }
    std::vector<std::uint64_t> from_counts = communicator_.turned(counts);
    std::vector<Item> sent;
    sent.reserve(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
    for (std::vector<Item>& some : out) {
      sent.insert(sent.end(), some.begin(), some.end());
      some = {};
    }
    std::vector<Item> received(
        std::accumulate(from_counts.begin(), from_counts.end(), std::size_t{0}));
    communicator_.exchange(sizeof(Item), reinterpret_cast<const std::byte*>(sent.data()), counts,
                           reinterpret_cast<std::byte*>(received.data()), from_counts);
    if (from != nullptr) *from = std::move(from_counts);
    return received;
  }

  // At the first rank, all items of all ranks in the order of ranks; elsewhere nothing.
  template <class Item>
  std::vector<Item> at_first(std::vector<Item> own) {
    std::vector<std::vector<Item>> out(size_);
    out[0] = std::move(own);
    return exchanged(std::move(out));
  }

  // Ends a phase: what was done since the previous phase, or since the beginning.
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
  template <class List>
  List list_of(std::size_t root, List list) {
    static_assert(std::is_trivially_copyable_v<typename List::value_type>);
    list.resize(of_rank(root, list.size()));
    const std::size_t bytes = list.size() * sizeof(typename List::value_type);
    communicator_.broadcast(reinterpret_cast<std::byte*>(list.data()), bytes, root);
    if (rank_ == root) count(bytes * (size_ - 1), size_ - 1);
    return list;
  }
  void count(std::uint64_t bytes, std::uint64_t messages) {
    now_.bytes_sent += bytes;
    now_.messages += messages;
  }

  Communicator& communicator_;
  std::size_t rank_;
  std::size_t size_;
  std::size_t few_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Phase now_;
  std::vector<Phase> phases_;
};

// The items of the list that are the same, group by group. `hash` and `same` are about items;
// visit(group) gets their places in the list, in no particular order.
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

// Brings equal items of all ranks together, each at the rank that its hash names: item(i) makes
// number i of this rank's `count` items, and hash(i) is its hash. There visit(items, group, post)
// sees each group of equal items and posts replies, and take(reply) receives them at the rank that
// they are posted to. It takes some hashes at a time (Ranks::rounds). Item has std::uint64_t hash()
// and bool same(other).
template <class Reply, class HashOf, class MakeItem, class Visit, class Take>
void meet(Ranks& ranks, std::size_t count, const HashOf& hash, const MakeItem& item,
          const Visit& visit, const Take& take) {
  using Item = std::decay_t<decltype(item(std::size_t{0}))>;
  // Sent, received, and the tables of those who meet.
  constexpr std::size_t kBytesEach = 2 * sizeof(Item) + 16;
  const std::size_t rounds = ranks.rounds(ranks.most(count), ranks.sum(count), kBytesEach);
  // Bits of the hash that for_each_group does not look at first.
  const auto home_of = [&](std::uint64_t one) {
    return (one >> 16 & 0xffffff) * ranks.size() >> 24;
  };
  std::pmr::vector<std::uint32_t> order;  // own items, by rounds
  std::vector<std::size_t> begins(rounds + 1, 0);
  begins.back() = count;
  if (rounds > 1) {
    std::vector<std::uint16_t> round_of(count);
    std::vector<std::size_t> next(rounds + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
      round_of[i] = static_cast<std::uint16_t>((hash(i) & 0xffff) * rounds >> 16);
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

// The same without replies.
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
