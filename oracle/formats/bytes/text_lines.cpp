#include "oracle/formats/bytes/text_lines.hpp"

#include <algorithm>
#include <cctype>

namespace circumspect::formats {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

TextLines::TextLines(const Source& source) : source_(source), rest_(source.text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool TextLines::next() {
  text_ = {};
  if (rest_.empty()) return false;
  ++line_;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  text_ = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  while (text_.ends_with('\r')) text_.remove_suffix(1);
  return true;
}

tl::unexpected<FormatError> TextLines::fail(std::string expected, std::string found) const {
  return tl::unexpected(FormatError{source_.name, std::max<std::size_t>(line_, 1),
                                    std::move(expected), std::move(found)});
}

}  // namespace circumspect::formats
