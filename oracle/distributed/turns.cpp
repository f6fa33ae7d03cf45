#include "oracle/distributed/turns.hpp"

#include <array>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <map>
#include <memory_resource>
#include <mutex>
#include <new>
#include <numeric>
#include <span>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace circumspect::distributed {
namespace {

constexpr std::size_t kNoPart = std::numeric_limits<std::size_t>::max();
thread_local std::size_t own_part = kNoPart;

// Large arrays are mapped anonymous files; the system writes them to the disk when it needs their
// memory.
class FileMemory : public std::pmr::memory_resource {
 public:
  explicit FileMemory(std::string folder) : folder_(std::move(folder)) {}

  // Releases the memory of a part's arrays, but keeps their contents.
  void put_away(std::size_t part) {
    const std::lock_guard lock(mutex_);
    for (const auto& [address, array] : arrays_) {
      if (array.part == part) madvise(address, array.bytes, MADV_DONTNEED);
    }
  }

 private:
  static constexpr std::size_t kLarge = std::size_t{1} << 18;

  struct Array {
    std::size_t bytes;
    std::size_t part;
  };

  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    if (bytes < kLarge) return std::pmr::new_delete_resource()->allocate(bytes, alignment);
    const int file = opened();
    // If the disk is full, access to a mapped file would raise a signal.
    const int failure = file < 0 ? errno : posix_fallocate(file, 0, static_cast<off_t>(bytes));
    void* address = MAP_FAILED;
    if (failure == 0) {
      address = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    }
    if (file >= 0) close(file);  // the mapping keeps the file alive
    if (failure != 0) {
      throw NoRoomOnDisk("expected room for " + std::to_string(bytes) + " bytes more in " +
                         folder_ + ", where --memory keeps what it puts away, found none: " +
                         std::strerror(failure) + "; TMPDIR names another folder");
    }
    if (address == MAP_FAILED) throw std::bad_alloc();
    const std::lock_guard lock(mutex_);
    arrays_[address] = {bytes, own_part};
    return address;
  }
  void do_deallocate(void* address, std::size_t bytes, std::size_t alignment) override {
    if (bytes < kLarge) {
      std::pmr::new_delete_resource()->deallocate(address, bytes, alignment);
      return;
    }
    const std::lock_guard lock(mutex_);
    arrays_.erase(address);
    munmap(address, bytes);
  }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  // An anonymous file that vanishes with the process, however it ends; −1, with errno set, if there
  // is none.
  int opened() const {
    const int flags = O_RDWR | O_CLOEXEC;
    const int file = open(folder_.c_str(), O_TMPFILE | flags, 0600);
    if (file >= 0) return file;
    std::string name = folder_ + "/circumspect-XXXXXX";
    const int named = mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0) unlink(name.c_str());
    return named;
  }

  std::string folder_;
  std::mutex mutex_;
  std::map<void*, Array> arrays_;
};

// While this object lives, containers of std::pmr take their memory from there.
class AsDefault {
 public:
  explicit AsDefault(std::pmr::memory_resource* memory)
      : before_(std::pmr::set_default_resource(memory)) {}
  ~AsDefault() { std::pmr::set_default_resource(before_); }
  AsDefault(const AsDefault&) = delete;
  AsDefault& operator=(const AsDefault&) = delete;

 private:
  std::pmr::memory_resource* before_;
};

// Thrown in parts that wait for one that has failed.
struct AnotherHasFailed {};

// What the parts have in common.
class Parts {
 public:
  Parts(const Turns& turns, FileMemory* memory) : turns_(turns), memory_(memory) {
    for (auto& some : values_) some.resize(turns.parts);
    sent_.resize(turns.parts);
  }

  const Turns& turns() const { return turns_; }

  // A part runs only between these two calls.
  void begin() {
    std::unique_lock lock(mutex_);
    go_on(lock, [] { return true; });
  }
  void end() {
    const std::lock_guard lock(mutex_);
    --running_;
    changed_.notify_all();
  }
  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
    changed_.notify_all();
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  // Returns when all parts have called it.
  void meet(std::size_t part) {
    if (memory_ != nullptr) memory_->put_away(part);
    std::unique_lock lock(mutex_);
    if (++arrived_ == turns_.parts) {
      arrived_ = 0;
      ++meetings_;
      changed_.notify_all();
      return;
    }
    --running_;
    changed_.notify_all();
    go_on(lock, [this, own = meetings_] { return meetings_ != own; });
  }

  // The bytes of all parts, valid until the second meeting from now.
  std::span<const std::string> gathered(std::size_t part, std::size_t& turn, std::string own) {
    std::vector<std::string>& all = values_[turn++ % 2];
    all[part] = std::move(own);
    meet(part);
    return all;
  }

  // A view of what a part has for all parts.
  struct Sent {
    const std::byte* items = nullptr;
    const std::vector<std::uint64_t>* counts = nullptr;
  };
  std::vector<Sent>& sent() { return sent_; }

 private:
  template <class Ready>
  void go_on(std::unique_lock<std::mutex>& lock, const Ready& ready) {
    changed_.wait(lock, [&] { return failure_ || (ready() && running_ < turns_.at_once); });
    ++running_;
    if (failure_) throw AnotherHasFailed();
  }

  const Turns& turns_;
  FileMemory* memory_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t running_ = 0, arrived_ = 0;
  std::uint64_t meetings_ = 0;
  std::exception_ptr failure_;
  std::array<std::vector<std::string>, 2> values_;
  std::vector<Sent> sent_;
};

class PartCommunicator : public Communicator {
 public:
  PartCommunicator(Parts& parts, std::size_t part) : parts_(parts), part_(part) {}

  std::size_t rank() const override { return part_; }
  std::size_t size() const override { return parts_.turns().parts; }
  std::size_t room() const override { return parts_.turns().room; }

  std::uint64_t reduced(std::uint64_t own, Reduction how) override {
    std::uint64_t all = own;
    const auto values = all_of(reinterpret_cast<const std::byte*>(&own), sizeof(own));
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::uint64_t value = 0;
      std::memcpy(&value, values[i].data(), sizeof(value));
      if (how == Reduction::kMost) all = std::max(all, value);
      if (how == Reduction::kLeast) all = std::min(all, value);
      if (how == Reduction::kSum && i != part_) all += value;
    }
    return all;
  }
  void broadcast(std::byte* bytes, std::size_t count, std::size_t root) override {
    const auto values = all_of(bytes, root == part_ ? count : 0);
    std::memcpy(bytes, values[root].data(), count);
  }
  void gather(const std::byte* own, std::size_t count, std::byte* all) override {
    for (const std::string& value : all_of(own, count)) {
      std::memcpy(all, value.data(), count);
      all += count;
    }
  }
  std::vector<std::uint64_t> turned(const std::vector<std::uint64_t>& own) override {
    std::vector<std::uint64_t> all(size());
    const auto values =
        all_of(reinterpret_cast<const std::byte*>(own.data()), own.size() * sizeof(std::uint64_t));
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::memcpy(&all[i], values[i].data() + part_ * sizeof(std::uint64_t), sizeof(all[i]));
    }
    return all;
  }
  void exchange(std::size_t bytes_each, const std::byte* sent,
                const std::vector<std::uint64_t>& counts, std::byte* received,
                const std::vector<std::uint64_t>& from_counts) override {
    parts_.sent()[part_] = {sent, &counts};
    parts_.meet(part_);
    for (std::size_t i = 0; i < size(); ++i) {
      const auto& [items, list] = parts_.sent()[i];
      const std::size_t before = std::accumulate(
          list->begin(), list->begin() + static_cast<std::ptrdiff_t>(part_), std::size_t{0});
      const std::size_t bytes = from_counts[i] * bytes_each;
      if (bytes > 0) std::memcpy(received, items + before * bytes_each, bytes);
      received += bytes;
    }
    parts_.meet(part_);  // until then others read from here
  }

 private:
  std::span<const std::string> all_of(const std::byte* own, std::size_t count) {
    return parts_.gathered(part_, turn_, std::string(reinterpret_cast<const char*>(own), count));
  }

  Parts& parts_;
  std::size_t part_;
  std::size_t turn_ = 0;
};

}  // namespace

void in_turns(const Turns& turns, const std::function<void(Ranks&)>& work) {
  FileMemory memory(turns.folder);
  const bool puts_away = turns.parts > turns.at_once;
  const AsDefault as_default(puts_away ? &memory : std::pmr::get_default_resource());
  Parts parts(turns, puts_away ? &memory : nullptr);
  const auto run = [&](std::size_t part) {
    own_part = part;
    try {
      parts.begin();
      PartCommunicator communicator(parts, part);
      Ranks ranks(communicator, turns.few);
      work(ranks);
    } catch (const AnotherHasFailed&) {
      // The failure of that part is reported.
    } catch (...) {
      parts.fail(std::current_exception());
    }
    parts.end();
  };
  std::vector<std::jthread> threads;
  try {
    for (std::size_t part = 0; part < turns.parts; ++part) threads.emplace_back(run, part);
  } catch (...) {
    parts.fail(std::current_exception());
  }
  threads.clear();
  parts.rethrow();
}

}  // namespace circumspect::distributed
