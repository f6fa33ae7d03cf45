// A file that has no name, or one that nobody expects, until it is complete.
#pragma once

#include <cstdint>
#include <string>

namespace circumspect::platform {

// It vanishes with the process, however that ends; where the file system has no files without
// names, it has an unpredictable one beside `path`, and a signal that ends this process removes it
// first. No existing file or link is followed, opened or truncated.
class NewFile {
 public:
  explicit NewFile(std::string path);
  // Closes it, and removes it if it was not named.
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  // To be written to; negative if it could not be opened: then errno says why.
  int descriptor() const { return descriptor_; }

  // Gives it `path` as its name, in place of the file that had it. False, and errno, if that fails:
  // then the name still belongs to the previous file, if any. Nothing may be written afterwards.
  bool give_name();

 private:
  std::string path_;
  std::string unfinished_;  // its name until it has its own; empty if it has none
  int descriptor_ = -1;
};

// The system's; where it gives none, one that nobody has soon.
std::uint64_t random_number();

// An unpredictable name in the folder of this path.
std::string unpredictable_name(const std::string& path);

// Removes all that have an unpredictable name, for a process that ends at once. May be called in a
// signal handler.
void remove_unfinished_files();

// From now on, exceeding a limit on file size is an error like a full disk, and does not end the
// command. (Programs that the command starts still get the signal.)
void let_writing_fail_at_file_limits();

}  // namespace circumspect::platform
