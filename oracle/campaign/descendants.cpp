#include <cstdio>
#include <fstream>

#include <dirent.h>
#include <unistd.h>

#include "oracle/campaign/supervised.hpp"

namespace circumspect::campaign {
namespace {

// Adds the children that the kernel lists for each thread of a process.
void add_children(pid_t process, std::vector<pid_t>& found) {
  const std::string tasks = "/proc/" + std::to_string(process) + "/task";
  DIR* const folder = opendir(tasks.c_str());
  if (folder == nullptr) return;  // It is gone.
  while (const dirent* const entry = readdir(folder)) {
    if (entry->d_name[0] == '.') continue;
    std::ifstream children(tasks + "/" + entry->d_name + "/children");
    for (pid_t child = 0; children >> child;) found.push_back(child);
  }
  closedir(folder);
}

}  // namespace

std::vector<pid_t> descendants() {
  std::vector<pid_t> found;
  add_children(getpid(), found);
  for (std::size_t i = 0; i < found.size(); ++i) add_children(found[i], found);
  return found;
}

}  // namespace circumspect::campaign
