#include "oracle/model/words.hpp"

#include <algorithm>
#include <cctype>

namespace circumspect {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

int small(char c) { return std::tolower(static_cast<unsigned char>(c)); }

}  // namespace

std::string_view behind_mark(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

std::string_view from_first_word(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return text.substr(std::min(first, text.size()));
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool is_word(std::string_view token, std::string_view word) {
  return std::equal(token.begin(), token.end(), word.begin(), word.end(),
                    [](char a, char b) { return small(a) == small(b); });
}

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace circumspect
