#include "platform/scratch_file.hpp"

#include <cstdint>
#include <stdexcept>

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include "platform/new_file.hpp"
#include "platform/windows/wide.hpp"

namespace circumspect::platform {
namespace {

// C's tmpfile() would make one in the root of the disk, where few may.
std::FILE* temporary_file() {
  wchar_t folder[MAX_PATH + 1] = {};
  if (GetTempPathW(MAX_PATH + 1, folder) == 0) return nullptr;
  const std::wstring name = to_wide(unpredictable_name(to_utf8(folder)));
  const HANDLE file =
      CreateFileW(name.c_str(), GENERIC_READ | GENERIC_WRITE | DELETE, FILE_SHARE_DELETE, nullptr,
                  CREATE_NEW, FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (file == INVALID_HANDLE_VALUE) return nullptr;
  return _fdopen(_open_osfhandle(reinterpret_cast<std::intptr_t>(file), _O_RDWR | _O_BINARY),
                 "w+b");
}

}  // namespace

ScratchFile::ScratchFile() : file_(temporary_file()) {
  if (file_ == nullptr) throw std::runtime_error("no file could be made in the folder of TEMP");
}

ScratchFile::~ScratchFile() { std::fclose(file_); }

std::string_view ScratchFile::text() {
  std::fflush(file_);
  read_.clear();
  std::rewind(file_);
  char block[1 << 14];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file_)) {
    read_.append(block, count);
  }
  std::fseek(file_, 0, SEEK_END);
  return read_;
}

}  // namespace circumspect::platform
