#include "platform/files.hpp"

#include <algorithm>
#include <cerrno>
#include <limits>

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include "platform/windows/wide.hpp"

namespace circumspect::platform {
namespace {

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor)); }

// A call takes no more than this at a time.
unsigned at_most(std::size_t count) {
  constexpr std::size_t kMost = std::numeric_limits<int>::max();
  return static_cast<unsigned>(std::min(count, kMost));
}

std::optional<FileStatus> status_of_handle(HANDLE file) {
  const DWORD type = GetFileType(file);
  if (type == FILE_TYPE_PIPE) return FileStatus{.kind = FileKind::kPipe};
  if (type == FILE_TYPE_CHAR) return FileStatus{.kind = FileKind::kDevice};
  BY_HANDLE_FILE_INFORMATION about = {};
  if (GetFileInformationByHandle(file, &about) == 0) {
    errno = last_error();
    return std::nullopt;
  }
  const bool is_folder = (about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  const auto joined = [](DWORD high, DWORD low) { return std::uint64_t{high} << 32U | low; };
  return FileStatus{.kind = is_folder ? FileKind::kFolder : FileKind::kRegular,
                    .size = joined(about.nFileSizeHigh, about.nFileSizeLow),
                    .device = about.dwVolumeSerialNumber,
                    .number = joined(about.nFileIndexHigh, about.nFileIndexLow)};
}

}  // namespace

const std::string_view kSeparators = "/\\:";

bool is_relative(std::string_view path) {
  return !path.starts_with('/') && !path.starts_with('\\') && path.find(':') == path.npos;
}

std::filesystem::path path_of(const std::string& text) { return to_wide(text); }

std::optional<FileStatus> status_of(const std::string& path) {
  // With no access asked for, only its attributes are. A folder is opened by the same call.
  const HANDLE file =
      CreateFileW(to_wide(path).c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                  nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (file == INVALID_HANDLE_VALUE) {
    errno = last_error();
    return std::nullopt;
  }
  const auto status = status_of_handle(file);
  CloseHandle(file);
  return status;
}

std::optional<FileStatus> status_of(int descriptor) {
  return status_of_handle(handle_of(descriptor));
}

// Others may rename, replace or remove it meanwhile, as they may on other systems.
int open_to_read(const std::string& path) {
  const HANDLE file = CreateFileW(to_wide(path).c_str(), GENERIC_READ,
                                  FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                  OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file == INVALID_HANDLE_VALUE) {
    errno = last_error();
    return -1;
  }
  return _open_osfhandle(reinterpret_cast<std::intptr_t>(file), _O_RDONLY | _O_BINARY);
}

void close_file(int descriptor) { _close(descriptor); }

std::ptrdiff_t read_some(int descriptor, char* to, std::size_t count) {
  return _read(descriptor, to, at_most(count));
}

std::ptrdiff_t write_some(int descriptor, const char* from, std::size_t count) {
  return _write(descriptor, from, at_most(count));
}

// It also moves the place from which read_some would go on, which nobody mixes with it.
std::ptrdiff_t read_some_at(int descriptor, char* to, std::size_t count, std::size_t offset) {
  OVERLAPPED place = {};
  place.Offset = static_cast<DWORD>(offset & 0xffffffffU);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32U);
  DWORD got = 0;
  if (ReadFile(handle_of(descriptor), to, at_most(count), &got, &place) != 0) return got;
  if (GetLastError() == ERROR_HANDLE_EOF) return 0;
  errno = last_error();
  return -1;
}

bool put_on_disk(int descriptor) { return _commit(descriptor) == 0; }

}  // namespace circumspect::platform
