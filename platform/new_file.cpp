#include "platform/new_file.hpp"

#include <cstdio>

#include "platform/files.hpp"

namespace circumspect::platform {

std::string unpredictable_name(const std::string& path) {
  const std::size_t separator = path.find_last_of(kSeparators);
  const std::string folder = separator == std::string::npos ? "./" : path.substr(0, separator + 1);
  char name[64];
  std::snprintf(name, sizeof(name), ".unfinished-%016llx",
                static_cast<unsigned long long>(random_number()));
  return folder + name;
}

}  // namespace circumspect::platform
