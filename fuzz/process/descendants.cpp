#include <cstdlib>
#include <string>

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include "fuzz/process/supervised.hpp"

namespace circumspect::campaign {
namespace {

// What the kernel says in one of its files. Nothing here waits for the disk.
std::string text_of(const std::string& path) {
  std::string text;
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return text;  // The process is gone.
  char block[4096];
  for (ssize_t count = 0; (count = read(file, block, sizeof(block))) > 0;) {
    text.append(block, static_cast<std::size_t>(count));
  }
  close(file);
  return text;
}

}  // namespace

void add_children(pid_t process, std::vector<pid_t>& found) {
  const std::string tasks = "/proc/" + std::to_string(process) + "/task";
  DIR* const folder = opendir(tasks.c_str());
  if (folder == nullptr) return;  // It is gone.
  while (const dirent* const entry = readdir(folder)) {
    if (entry->d_name[0] == '.') continue;
    const std::string children = text_of(tasks + "/" + entry->d_name + "/children");
    const char* at = children.c_str();
    for (char* end = nullptr; const long child = std::strtol(at, &end, 10); at = end) {
      found.push_back(static_cast<pid_t>(child));
    }
  }
  closedir(folder);
}

std::vector<pid_t> descendants(std::size_t enough) {
  std::vector<pid_t> found;
  add_children(getpid(), found);
  for (std::size_t i = 0; i < found.size() && found.size() < enough; ++i) {
    add_children(found[i], found);
  }
  return found;
}

}  // namespace circumspect::campaign
