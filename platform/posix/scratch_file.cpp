#include "platform/scratch_file.hpp"

#include <cstdlib>
#include <stdexcept>

namespace circumspect::platform {

ScratchFile::ScratchFile() : file_(open_memstream(&bytes_, &size_)) {
  if (file_ == nullptr) throw std::runtime_error("no memory for a file in memory");
}

ScratchFile::~ScratchFile() {
  std::fclose(file_);
  std::free(bytes_);
}

std::string_view ScratchFile::text() {
  std::fflush(file_);
  return {bytes_, size_};
}

}  // namespace circumspect::platform
