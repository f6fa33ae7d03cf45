// The bytes of a file at any place: what lets several threads read one file at once.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace circumspect::formats {

// A regular file, or a text in memory. Bytes are copied out, not mapped: a file that another program
// cuts off or changes meanwhile is then a failed read or other bytes, never a signal.
class RandomAccess {
 public:
  // None if it is no regular file, or may not be read. Who wants to know why asks load().
  static std::optional<RandomAccess> open(const std::string& path);
  // Requires: the text outlives this object.
  explicit RandomAccess(std::string_view text) : text_(text), size_(text.size()) {}

  RandomAccess(RandomAccess&& other) noexcept;
  RandomAccess(const RandomAccess&) = delete;
  RandomAccess& operator=(const RandomAccess&) = delete;
  RandomAccess& operator=(RandomAccess&&) = delete;
  ~RandomAccess();

  // As it was when the file was opened.
  std::size_t size() const { return size_; }

  // Copies `count` bytes from `offset` on; false if there are not as many. Any number of threads may
  // call this at once. Requires: `to` has room.
  bool read(std::size_t offset, std::size_t count, char* to) const;

 private:
  RandomAccess(int descriptor, std::size_t size) : descriptor_(descriptor), size_(size) {}

  int descriptor_ = -1;  // -1: the text
  std::string_view text_;
  std::size_t size_ = 0;
};

}  // namespace circumspect::formats
