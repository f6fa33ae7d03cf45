// Hunts every planted fault, and writes the table of them into properties/faulty/README.md:
//
//     faulty_report properties/faulty/README.md
//
// faulty_soak_property.cpp holds the table to what comes out.
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "properties/faulty/hunt.hpp"

namespace circumspect::faulty {
namespace {

constexpr std::string_view kBegin = "<!-- faults -->\n";
constexpr std::string_view kEnd = "<!-- end of faults -->";

int report(const std::string& path) {
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
  std::ofstream(path) << text.substr(0, from) << now << text.substr(end);
  return 0;
}

}  // namespace
}  // namespace circumspect::faulty

int main(int count, char** arguments) {
  if (count == 2) return circumspect::faulty::report(arguments[1]);
  std::cerr << "usage: faulty_report properties/faulty/README.md\n";
  return 2;
}
