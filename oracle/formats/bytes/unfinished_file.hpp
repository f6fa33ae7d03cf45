// A file that appears complete or not at all, because it gets its name when it is complete.
#pragma once

#include <array>
#include <ostream>
#include <streambuf>
#include <string>

#include "platform/new_file.hpp"

namespace circumspect::formats {

// Writes to an open file, and remembers why that failed.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(int descriptor) : file_(descriptor) {
    setp(block_.data(), block_.data() + block_.size());
  }

  int failure = 0;  // errno of the first failure

 protected:
  int_type overflow(int_type c) override;
  int sync() override;

 private:
  bool write_out();

  int file_;
  std::array<char, 1 << 14> block_ = {};
};

// A file as platform::NewFile has it, written to as a stream.
class UnfinishedFile {
 public:
  // The file is removed with this object, if it was not finished.
  explicit UnfinishedFile(const std::string& path);
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  std::ostream& stream() { return stream_; }
  // Gives the file its name; `to_disk`: after all of it is on the disk. Returns 0, or errno of the
  // call that failed: then the name still belongs to the previous file, if any. Nothing may be
  // written afterwards.
  int finish(bool to_disk = false);

 private:
  platform::NewFile file_;
  FileBuffer buffer_;
  std::ostream stream_;
};

// Writes a whole text in this way; it is on the disk afterwards. Returns 0, or errno of the call
// that failed.
int write_whole_file(const std::string& path, const std::string& text);

}  // namespace circumspect::formats
