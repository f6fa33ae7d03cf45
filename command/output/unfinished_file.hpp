// A file that is written under a temporary name beside its own, so that it is there whole or not at all.
#pragma once

#include <fstream>
#include <ostream>
#include <string>

namespace circumspect::cli {

// Under which name a file is written until it is complete: beside it, so that it can be renamed.
std::string name_until_complete(const std::string& path);

// While there is one, a signal that ends the command removes it first. One at a time.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::string path);
  // Removes what was not finished.
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  std::ostream& stream() { return stream_; }
  // Gives the file its name. False if not all could be written: then what had that name before still has
  // it. Nothing may be written afterwards.
  bool finish();

 private:
  std::string path_;
  std::string unfinished_;
  std::ofstream stream_;
  bool is_there_ = false;
};

// From now on writing beyond a limit on the size of files is an error like a full disk, and does not
// end the command. (Programs that the command starts get the signal all the same.)
void let_writing_fail_at_file_limits();

}  // namespace circumspect::cli
