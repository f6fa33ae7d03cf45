#include "properties/faulty/report.hpp"

#include <algorithm>
#include <sstream>

namespace circumspect::faulty {
namespace {

// With the bars of |p|² escaped, which would part the cells of a table.
std::string in_a_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string row(const Found& found) {
  const Fault& fault = *found.fault;
  std::ostringstream line;
  line << "| `" << fault.name << "` | " << name(fault.kind) << " | " << in_a_cell(fault.about)
       << " | `" << name(fault.claim) << "` | ";
  if (!found.caught) {
    line << "not caught | | | |\n";
    return line.str();
  }
  const Catch& caught = *found.caught;
  line << caught.inputs << " | `" << caught.family << "` | `" << caught.rule << "` | "
       << caught.points << " → " << caught.least_points << " |\n";
  return line.str();
}

}  // namespace

std::vector<Found> hunt_all(const HuntOptions& options) {
  std::vector<Found> all;
  for (const Fault& fault : faults()) all.push_back({&fault, hunt(fault, options)});
  return all;
}

std::string table(const std::vector<Found>& all) {
  std::vector<std::size_t> inputs;
  for (const Found& found : all) {
    if (found.caught) inputs.push_back(found.caught->inputs);
  }
  std::sort(inputs.begin(), inputs.end());
  std::ostringstream text;
  text << "| fault | kind | the mistake | claim | inputs | family | rule | points |\n"
       << "|---|---|---|---|---:|---|---|---:|\n";
  for (const Found& found : all) text << row(found);
  text << "\n" << inputs.size() << " of " << all.size() << " caught";
  if (!inputs.empty()) {
    text << "; inputs until caught: median " << inputs[inputs.size() / 2] << ", at most "
         << inputs.back();
  }
  text << ".\n";
  return text.str();
}

}  // namespace circumspect::faulty
