#include "command/rule/page_text.hpp"

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace circumspect::cli {
namespace {

// "[words](../page.md#heading)" becomes "words", and the page is remembered.
std::string with_words_of_links(std::string line, std::set<std::string>& pages) {
  static const std::regex link(R"(\[([^\]]*)\]\(([^)#]*)[^)]*\))");
  for (std::smatch match; std::regex_search(line, match, link);) {
    const std::filesystem::path folder = "docs/rules";
    pages.insert((folder / match[2].str()).lexically_normal().generic_string());
    line = match.prefix().str() + match[1].str() + match.suffix().str();
  }
  return line;
}

}  // namespace

std::string page_text(std::string_view markdown) {
  std::string text;
  std::set<std::string> pages;
  std::istringstream lines{std::string(markdown)};
  bool is_code = false;
  bool is_after_image = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      is_code = !is_code;
      continue;
    }
    if (is_code) {
      text += "  " + line + "\n";
      continue;
    }
    if (line.starts_with("![")) {
      is_after_image = true;
      continue;
    }
    if (is_after_image && line.empty()) continue;  // one blank line is there already
    is_after_image = false;
    if (line.starts_with("#")) line.erase(0, line.find_first_not_of("# "));
    text += with_words_of_links(std::move(line), pages) + "\n";
  }
  if (!pages.empty()) text += fmt::format("\nRead on in {}.\n", fmt::join(pages, ", "));
  return text;
}

}  // namespace circumspect::cli
