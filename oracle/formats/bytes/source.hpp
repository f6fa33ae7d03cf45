// The text of a file with access to its bytes, and the error of a reader, which is one line for
// people.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace circumspect::formats {

struct FormatError {
  std::string file;
  std::size_t line = 0;  // from 1; 0: the file as a whole
  std::string expected;
  std::string found;

  // "file:line: expected X, found Y": always one line, whatever bytes the parts hold.
  std::string to_string() const;
};

template <class T>
using Result = tl::expected<T, FormatError>;

// Success, or the error.
using Status = Result<void>;

// Bytes of a file as a message may show them: in quotes, truncated after kLongestQuote characters,
// with everything that is not printable ASCII written as \xNN.
inline constexpr std::size_t kLongestQuote = 40;
std::string quote(std::string_view bytes);
// The same without quotes, for a name that the file gives to a part of it; what is not printable is
// left for FormatError to escape.
std::string shortened(std::string_view bytes);

// The text of a file, and the name under which messages speak of it.
struct Source {
  std::string name;
  std::string text;
};

// The name of standard input in messages.
inline constexpr std::string_view kStandardInputName = "<stdin>";

// Reads a whole file, or a pipe; "-" is standard input. A directory, a device, a file that is not
// there or may not be read is an error that says so.
Result<Source> load(const std::string& path);

// Is there a file, of whatever kind, at this path?
bool exists(const std::string& path);

// Is there a folder at this path?
bool is_folder(const std::string& path);

// Is it a regular file, and not a pipe, device or folder?
bool is_regular(const std::string& path);

// Access to the bytes of a file at any place, so that several threads can read one file at once.

// A regular file, or a text in memory. Bytes are copied, not mapped: if another program truncates
// or changes the file meanwhile, a read fails or gives other bytes, but no signal is raised.
class RandomAccess {
 public:
  // Nothing if it is not a regular file, or may not be read; load() says why.
  static std::optional<RandomAccess> open(const std::string& path);
  // Requires: the text outlives this object.
  explicit RandomAccess(std::string_view text) : text_(text), size_(text.size()) {}

  RandomAccess(RandomAccess&& other) noexcept;
  RandomAccess(const RandomAccess&) = delete;
  RandomAccess& operator=(const RandomAccess&) = delete;
  RandomAccess& operator=(RandomAccess&&) = delete;
  ~RandomAccess();

  // The size when the file was opened.
  std::size_t size() const { return size_; }

  // Copies `count` bytes from `offset` on; false if there are not as many. Any number of threads
  // may call this at once. Requires: `to` has room.
  bool read(std::size_t offset, std::size_t count, char* to) const;

 private:
  RandomAccess(int descriptor, std::size_t size) : descriptor_(descriptor), size_(size) {}

  int descriptor_ = -1;  // -1: the text
  std::string_view text_;
  std::size_t size_ = 0;
};

}  // namespace circumspect::formats
