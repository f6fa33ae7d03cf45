#include "oracle/formats/json_text.hpp"

#include <algorithm>

namespace circumspect::formats {
namespace {

// nlohmann-json's number for "does not fit a double".
constexpr int kNumberOverflow = 406;

}  // namespace

std::size_t JsonText::line() {
  // The parser has read the token, and after a number one more character.
  const char* const end = position_ == source_.text.data() ? position_ : position_ - 1;
  if (end > counted_) {
    line_ += static_cast<std::size_t>(std::count(counted_, end, '\n'));
    counted_ = end;
  }
  return line_;
}

FormatError JsonText::fault(const std::string& last_token, const nlohmann::json::exception& error,
                            std::string_view beyond) {
  const auto found = [this](std::string expected, std::string what) {
    return FormatError{source_.name, line(), std::move(expected), std::move(what)};
  };
  if (error.id == kNumberOverflow) {
    return found("a number within the range of double" + std::string(beyond), quote(last_token));
  }
  // The message ends with the parser's own: "…- invalid literal; last read: 'nan'".
  const std::string_view message = error.what();
  const std::string_view reason = message.substr(std::min(message.find(" - ") + 3, message.size()));
  const std::string_view why = reason.substr(0, reason.find(';'));
  if (why == "unexpected end of input")
    return found("the rest of the JSON text", "the end of the file");
  return found("valid JSON", quote(end_of_what_was_read()) + " (" +
                                 std::string(why.substr(0, 2 * kLongestQuote)) + ")");
}

std::string_view JsonText::end_of_what_was_read() const {
  constexpr std::size_t kEnough = kLongestQuote / 2;
  const std::string_view text = source_.text;
  std::string_view read = text.substr(0, static_cast<std::size_t>(position_ - text.data()));
  if (read.size() > kEnough) read.remove_prefix(read.size() - kEnough);
  const std::size_t line_start = read.find_last_of('\n', read.size() - 2) + 1;
  return read.size() < 2 ? read : read.substr(line_start);
}

std::string as_written(std::string number) {
  for (char& c : number) {
    if (std::string_view("0123456789+-eE").find(c) == std::string_view::npos) c = '.';
  }
  return number;
}

}  // namespace circumspect::formats
