#include "platform/new_file.hpp"

#include <cstdint>
#include <cstdio>
#include <exception>
#include <random>

#include "platform/files.hpp"

namespace circumspect::platform {
namespace {

std::uint64_t random_number() {
  try {
    std::random_device device;
    return std::uint64_t{device()} << 32U ^ device();
  } catch (const std::exception&) {  // the system gives none: then a name that nobody has soon
    static int place;
    return reinterpret_cast<std::uintptr_t>(&place);
  }
}

}  // namespace

std::string unpredictable_name(const std::string& path) {
  const std::size_t separator = path.find_last_of(kSeparators);
  const std::string folder = separator == std::string::npos ? "./" : path.substr(0, separator + 1);
  char name[64];
  std::snprintf(name, sizeof(name), ".unfinished-%016llx",
                static_cast<unsigned long long>(random_number()));
  return folder + name;
}

}  // namespace circumspect::platform
