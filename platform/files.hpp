// Files by their paths, which are UTF-8, and by the descriptors that C's library has of open ones.
// A function that fails says why in errno.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace circumspect::platform {

inline constexpr int kStandardInput = 0;
inline constexpr int kStandardOutput = 1;
inline constexpr int kStandardError = 2;

enum class FileKind { kRegular, kPipe, kFolder, kDevice };

struct FileStatus {
  FileKind kind = FileKind::kRegular;
  std::size_t size = 0;
  // Two regular files with these in common are one.
  std::uint64_t device = 0;
  std::uint64_t number = 0;
};

// Nothing is opened for it: to open a device can already have an effect.
std::optional<FileStatus> status_of(const std::string& path);
std::optional<FileStatus> status_of(int descriptor);

// Negative if it fails.
int open_to_read(const std::string& path);
void close_file(int descriptor);

// At most `count` bytes, and how many they were: 0 at the end, negative if it fails.
std::ptrdiff_t read_some(int descriptor, char* to, std::size_t count);
std::ptrdiff_t write_some(int descriptor, const char* from, std::size_t count);
// The same from an offset on, by any number of threads at once.
std::ptrdiff_t read_some_at(int descriptor, char* to, std::size_t count, std::size_t offset);

// Waits until the disk has all of a file.
bool put_on_disk(int descriptor);

// The characters that end the name of a folder in a path.
extern const std::string_view kSeparators;
// Does a path begin at the folder that one is in?
bool is_relative(std::string_view path);
// For std::filesystem, which on some systems expects other bytes than UTF-8.
std::filesystem::path path_of(const std::string& text);

}  // namespace circumspect::platform
