// A file for a library that writes to nothing else.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace circumspect::platform {

// It has no name that anybody knows, and is in memory where the system has such files.
class ScratchFile {
 public:
  // Throws std::runtime_error.
  ScratchFile();
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  std::FILE* file() { return file_; }
  // What has been written so far. Valid until more is.
  std::string_view text();

 private:
  char* bytes_ = nullptr;
  std::size_t size_ = 0;
  std::string read_;
  std::FILE* file_;
};

}  // namespace circumspect::platform
