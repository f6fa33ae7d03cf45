// A file that appears complete or not at all: it gets its name when it is complete.
#pragma once

#include <array>
#include <ostream>
#include <streambuf>
#include <string>

namespace circumspect::formats {

// Writes to a file that is open, and remembers why that failed.
class FileBuffer : public std::streambuf {
 public:
  FileBuffer() { setp(block_.data(), block_.data() + block_.size()); }

  int file = -1;
  int failure = 0;  // errno of what failed first

 protected:
  int_type overflow(int_type c) override;
  int sync() override;

 private:
  bool write_out();

  std::array<char, 1 << 14> block_ = {};
};

// What is written goes to a file without a name (O_TMPFILE), of which nothing is left however this process ends.
// Where the file system has none, it has a name that nobody can know beforehand, and a signal that ends this
// process removes it first. Nothing that has a name is followed, opened or emptied.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::string path);
  // Removes what was not finished.
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  std::ostream& stream() { return stream_; }
  // Gives the file its name; `to_disk`: after all of it is on the disk. Returns 0, or errno
  // of what was not possible: then what had that name before still has it. Nothing may be written afterwards.
  int finish(bool to_disk = false);

 private:
  bool open_named();
  bool give_name();

  std::string path_;
  std::string unfinished_;  // its name; empty if it has none
  FileBuffer buffer_;
  std::ostream stream_;
};

// Writes a whole text so; it is on the disk afterwards. Returns 0, or errno of what was not possible.
int write_whole_file(const std::string& path, const std::string& text);

// For who ends at once: removes what UnfinishedFile would have. May be called by the handler of a signal.
void remove_unfinished_files();

// From now on writing beyond a limit on the size of files is an error like a full disk, and does not
// end the command. (Programs that the command starts get the signal all the same.)
void let_writing_fail_at_file_limits();

}  // namespace circumspect::formats
