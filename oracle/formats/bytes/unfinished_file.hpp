// A file that appears complete or not at all, because it gets its name when it is complete.
#pragma once

#include <array>
#include <ostream>
#include <streambuf>
#include <string>

namespace circumspect::formats {

// Writes to an open file, and remembers why that failed.
class FileBuffer : public std::streambuf {
 public:
  FileBuffer() { setp(block_.data(), block_.data() + block_.size()); }

  int file = -1;
  int failure = 0;  // errno of the first failure

 protected:
  int_type overflow(int_type c) override;
  int sync() override;

 private:
  bool write_out();

  std::array<char, 1 << 14> block_ = {};
};

// Writes to an anonymous file (O_TMPFILE), which vanishes with the process, however it ends. If the
// file system does not support these, the file has an unpredictable name, and a signal that ends
// this process removes it first. No existing file or link is followed, opened or truncated.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::string path);
  // Removes the file if it was not finished.
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  std::ostream& stream() { return stream_; }
  // Gives the file its name; `to_disk`: after all of it is on the disk. Returns 0, or errno of the
  // call that failed: then the name still belongs to the previous file, if any. Nothing may be
  // written afterwards.
  int finish(bool to_disk = false);

 private:
  bool open_named();
  bool give_name();

  std::string path_;
  std::string unfinished_;  // its name; empty if it has none
  FileBuffer buffer_;
  std::ostream stream_;
};

// Writes a whole text in this way; it is on the disk afterwards. Returns 0, or errno of the call
// that failed.
int write_whole_file(const std::string& path, const std::string& text);

// Removes all unfinished files, for a process that ends at once. May be called in a signal handler.
void remove_unfinished_files();

// From now on, exceeding a limit on file size is an error like a full disk, and does not end the
// command. (Programs that the command starts still get the signal.)
void let_writing_fail_at_file_limits();

}  // namespace circumspect::formats
