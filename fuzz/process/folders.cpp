#include "fuzz/process/folders.hpp"

#include <algorithm>
#include <cerrno>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace circumspect::campaign {
namespace {

constexpr int kOpenFolder = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

// An open folder, which is closed at the end.
class Folder {
 public:
  Folder(int parent, const char* name) {
    const int file = openat(parent, name, kOpenFolder);
    if (file < 0) return;
    stream_ = fdopendir(file);
    if (stream_ == nullptr) close(file);
  }
  ~Folder() {
    if (stream_ != nullptr) closedir(stream_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  bool is_open() const { return stream_ != nullptr; }
  int file() const { return dirfd(stream_); }

  // The next entry other than the folder itself and its parent, or null.
  const char* next() {
    while (const dirent* const entry = readdir(stream_)) {
      const std::string_view name = entry->d_name;
      if (name != "." && name != "..") return entry->d_name;
    }
    return nullptr;
  }
  std::vector<std::string> names() {
    std::vector<std::string> all;
    rewinddir(stream_);
    while (const char* const name = next()) all.emplace_back(name);
    return all;
  }

 private:
  DIR* stream_ = nullptr;
};

void add_bytes(int parent, const char* name, int depth, std::uint64_t enough,
               std::uint64_t& bytes) {
  Folder folder(parent, name);
  if (!folder.is_open()) return;
  if (depth > kDeepest) bytes = std::max(bytes, enough);
  while (bytes < enough) {
    const char* const entry = folder.next();
    if (entry == nullptr) return;
    struct stat status {};
    // Files that are deleted meanwhile do not count.
    if (fstatat(folder.file(), entry, &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
    bytes += std::max(static_cast<std::uint64_t>(status.st_blocks) * 512, kEntryBytes);
    if (S_ISDIR(status.st_mode)) add_bytes(folder.file(), entry, depth + 1, enough, bytes);
  }
}

// Requires: no link of that name.
void open_to_owner(int parent, const char* name) { fchmodat(parent, name, S_IRWXU, 0); }

bool is_folder(int parent, const char* name) {
  struct stat status {};
  return fstatat(parent, name, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISDIR(status.st_mode);
}

// Moves a folder into another one, under a name that nothing has there.
bool moved(int from, const char* name, int to, unsigned& number) {
  for (int tries = 0; tries < 1000; ++tries) {
    const std::string fresh = "moved-" + std::to_string(number++);
    if (renameat(from, name, to, fresh.c_str()) == 0) return true;
    if (errno != EEXIST && errno != ENOTEMPTY && errno != ENOTDIR) return false;
  }
  return false;
}

// Deletes a folder in `top`. The folders in it are moved up to `top` first: so neither paths nor
// the stack grow with the depth.
bool flattened(const Folder& top, const char* name, unsigned& number) {
  open_to_owner(top.file(), name);
  {
    Folder folder(top.file(), name);
    if (!folder.is_open()) return false;
    for (const std::string& entry : folder.names()) {
      if (unlinkat(folder.file(), entry.c_str(), 0) == 0) continue;
      if (!is_folder(folder.file(), entry.c_str())) return false;
      open_to_owner(folder.file(), entry.c_str());
      if (!moved(folder.file(), entry.c_str(), top.file(), number)) return false;
    }
  }
  return unlinkat(top.file(), name, AT_REMOVEDIR) == 0;
}

}  // namespace

std::uint64_t bytes_in(const std::string& folder, std::uint64_t enough) {
  std::uint64_t bytes = 0;
  add_bytes(AT_FDCWD, folder.c_str(), 0, enough, bytes);
  return bytes;
}

bool is_folder(const std::string& path) { return is_folder(AT_FDCWD, path.c_str()); }

bool emptied(const std::string& folder) {
  struct stat status {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return false;
  if ((status.st_mode & 07777U) != S_IRWXU) open_to_owner(AT_FDCWD, folder.c_str());
  Folder top(AT_FDCWD, folder.c_str());
  if (!top.is_open()) return false;
  unsigned number = 0;
  for (auto names = top.names(); !names.empty(); names = top.names()) {
    bool has_folders = false;
    for (const std::string& name : names) {
      if (unlinkat(top.file(), name.c_str(), 0) == 0) continue;
      has_folders = true;
      if (!flattened(top, name.c_str(), number)) return false;
    }
    if (!has_folders) return true;
  }
  return true;
}

bool removed(const std::string& path) {
  if (unlink(path.c_str()) == 0 || errno == ENOENT) return true;
  return emptied(path) && rmdir(path.c_str()) == 0;
}

}  // namespace circumspect::campaign
