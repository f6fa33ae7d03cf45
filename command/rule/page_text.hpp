// Pages of docs/rules, as they are read in a terminal.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace circumspect::cli {

// The pages, by the identifiers of rules and breaches. command/CMakeLists.txt writes them.
const std::map<std::string, std::string, std::less<>>& rule_pages();

// A page without what only a browser shows: images are left out, links are their words, and what
// stands in a block of code is indented instead of fenced. A last line names the pages to which
// links lead, by their paths in the project.
std::string page_text(std::string_view markdown);

}  // namespace circumspect::cli
