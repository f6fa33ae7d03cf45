#include "fuzz/campaign/subject.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/process/process.hpp"

namespace circumspect::campaign {

std::vector<std::string> filled_in(const Subject& subject, const Paths& paths) {
  std::vector<std::string> arguments = subject.command;
  for (std::string& argument : arguments) {
    replace_all(argument, "{points}", paths.input);
    replace_all(argument, "{domain}", paths.input);
    replace_all(argument, "{mesh}", paths.mesh);
    replace_all(argument, "{folder}", paths.folder);
  }
  return arguments;
}

bool mentions(const std::vector<std::string>& command, const std::string& placeholder) {
  return std::any_of(command.begin(), command.end(), [&](const std::string& argument) {
    return argument.find(placeholder) != std::string::npos;
  });
}

}  // namespace circumspect::campaign
