// Hunts every planted fault, and writes the table into properties/faulty/README.md, or compares it:
//
//     faulty_report README.md --check    exit 1 if the table there is not what comes out
//     faulty_report README.md --update   writes it
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "properties/faulty/hunt.hpp"

namespace circumspect::faulty {
namespace {

constexpr std::string_view kBegin = "<!-- faults -->\n";
constexpr std::string_view kEnd = "<!-- end of faults -->";

int report(const std::string& path, bool update) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t begin = text.find(kBegin), end = text.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos) {
    std::cerr << path << ": no lines '<!-- faults -->' and '" << kEnd
              << "' found, between which the table is to stand\n";
    return 2;
  }
  const std::size_t from = begin + kBegin.size();
  const std::string now = "\n" + table(hunt_all()) + "\n";
  if (update) {
    std::ofstream(path) << text.substr(0, from) << now << text.substr(end);
    return 0;
  }
  if (text.substr(from, end - from) == now) return 0;
  std::cerr << path << ": the table is not what the faults come to now:\n"
            << now << "Run `faulty_report " << path << " --update`.\n";
  return 1;
}

}  // namespace
}  // namespace circumspect::faulty

int main(int count, char** arguments) {
  const std::string mode = count == 3 ? arguments[2] : "";
  if (mode != "--check" && mode != "--update") {
    std::cerr << "usage: faulty_report properties/faulty/README.md --check|--update\n";
    return 2;
  }
  return circumspect::faulty::report(arguments[1], mode == "--update");
}
