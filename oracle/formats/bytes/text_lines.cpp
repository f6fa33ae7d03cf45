#include "oracle/formats/bytes/text_lines.hpp"

#include <algorithm>

namespace circumspect::formats {

TextLines::TextLines(const Source& source) : source_(source), rest_(behind_mark(source.text)) {}

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
