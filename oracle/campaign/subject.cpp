#include "oracle/campaign/subject.hpp"

#include <algorithm>

namespace circumspect::campaign {
namespace {

void replace_all(std::string& text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + by.size())) {
    text.replace(at, part.size(), by);
  }
}

}  // namespace

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
