#include "platform/new_file.hpp"

#include <cerrno>
#include <cstdint>
#include <exception>
#include <random>
#include <utility>

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include "platform/windows/wide.hpp"

namespace circumspect::platform {
namespace {

// Is the file to vanish when its last handle is closed, as all are when the process ends?
bool set_vanishing(int descriptor, bool vanishes) {
  FILE_DISPOSITION_INFO how = {};
  how.DeleteFile = vanishes ? TRUE : FALSE;
  return SetFileInformationByHandle(reinterpret_cast<HANDLE>(_get_osfhandle(descriptor)),
                                    FileDispositionInfo, &how, sizeof how) != 0;
}

}  // namespace

std::uint64_t random_number() {
  try {
    std::random_device device;
    return std::uint64_t{device()} << 32U ^ device();
  } catch (const std::exception&) {
    static int place;
    return reinterpret_cast<std::uintptr_t>(&place);
  }
}

NewFile::NewFile(std::string path) : path_(std::move(path)) {
  unfinished_ = unpredictable_name(path_);
  const HANDLE file =
      CreateFileW(to_wide(unfinished_).c_str(), GENERIC_WRITE | DELETE, FILE_SHARE_DELETE, nullptr,
                  CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file == INVALID_HANDLE_VALUE) {
    errno = last_error();
    unfinished_.clear();
    return;
  }
  descriptor_ = _open_osfhandle(reinterpret_cast<std::intptr_t>(file), _O_WRONLY | _O_BINARY);
  if (descriptor_ >= 0) set_vanishing(descriptor_, true);
}

NewFile::~NewFile() {
  if (descriptor_ >= 0) _close(descriptor_);
  if (!unfinished_.empty()) DeleteFileW(to_wide(unfinished_).c_str());
}

// A file is renamed after it is closed, as scanners of viruses like it best.
bool NewFile::give_name() {
  if (!set_vanishing(descriptor_, false)) {
    errno = last_error();
    return false;
  }
  _close(std::exchange(descriptor_, -1));
  if (MoveFileExW(to_wide(unfinished_).c_str(), to_wide(path_).c_str(),
                  MOVEFILE_REPLACE_EXISTING) == 0) {
    errno = last_error();
    return false;
  }
  unfinished_.clear();
  return true;
}

// The system does.
void remove_unfinished_files() {}

// There are no such limits.
void let_writing_fail_at_file_limits() {}

}  // namespace circumspect::platform
