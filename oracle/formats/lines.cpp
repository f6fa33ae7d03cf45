#include "oracle/formats/lines.hpp"

#include <algorithm>
#include <charconv>

#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

void split(std::string_view line, std::vector<std::string_view>& tokens) {
  std::size_t at = 0;
  while (at < line.size()) {
    if (line[at] == '#') return;
    if (is_blank(line[at])) {
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    while (end < line.size() && !is_blank(line[end]) && line[end] != '#') ++end;
    tokens.push_back(line.substr(at, end - at));
    at = end;
  }
}

}  // namespace

std::errc parse_integer(std::string_view token, Vertex& value) {
  const bool has_plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  if (has_plus) token.remove_prefix(1);
  const char* const last = token.data() + token.size();
  const auto [end, error] = std::from_chars(token.data(), last, value);
  return end == last ? error : std::errc::invalid_argument;
}

tl::expected<Rational, NumberError> parse_number(std::string_view token, NumberReading reading) {
  if (token.size() > kLongestNumber) {
    return tl::unexpected(
        NumberError{"a number of at most " + std::to_string(kLongestNumber) + " characters"});
  }
  return read_number(token, reading);
}

Lines::Lines(const Source& source) : source_(source), rest_(source.text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    rest_.remove_prefix(kByteOrderMark.size());
  }
}

bool Lines::next() {
  tokens_.clear();
  while (!rest_.empty()) {
    ++line_;
    const std::size_t length = std::min(rest_.find('\n'), rest_.size());
    split(rest_.substr(0, length), tokens_);
    rest_.remove_prefix(std::min(length + 1, rest_.size()));
    if (!tokens_.empty()) return true;
  }
  line_ = std::max<std::size_t>(line_, 1);
  return false;
}

tl::unexpected<FormatError> Lines::fail(std::string expected, std::string found) const {
  return tl::unexpected(FormatError{source_.name, line_, std::move(expected), std::move(found)});
}

tl::unexpected<FormatError> Lines::fail_at(std::size_t column, std::string expected) const {
  if (tokens_.empty()) return fail(std::move(expected), "the end of the file");
  if (column >= tokens_.size()) return fail(std::move(expected), "the end of the line");
  return fail(std::move(expected), quote(tokens_[column]));
}

Result<Vertex> Lines::integer(std::size_t column, std::string_view what) const {
  Vertex value = 0;
  const std::errc error = parse_integer(tokens_[column], value);
  if (error == std::errc()) return value;
  const bool is_integer = error == std::errc::result_out_of_range;
  return fail_at(
      column, std::string(what) + (is_integer ? ", an integer that fits 64 bits" : ", an integer"));
}

Result<std::size_t> Lines::count(std::size_t column, std::string_view what) const {
  const Result<Vertex> value = integer(column, what);
  if (!value) return tl::unexpected(value.error());
  if (*value < 0) return fail_at(column, std::string(what) + ", 0 or more");
  return static_cast<std::size_t>(*value);
}

Result<Rational> Lines::number(std::size_t column, NumberReading reading) const {
  tl::expected<Rational, NumberError> value = parse_number(tokens_[column], reading);
  if (!value) return fail_at(column, std::move(value.error().expected));
  return std::move(*value);
}

Result<std::vector<Vertex>> Lines::integers(std::size_t first, std::size_t count,
                                            std::string_view what) const {
  std::vector<Vertex> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (parse_integer(tokens_[first + i], values[i]) == std::errc()) continue;
    return tl::unexpected(integer(first + i, what).error());
  }
  return values;
}

Result<std::vector<Rational>> Lines::numbers(std::size_t first, std::size_t count,
                                             NumberReading reading) const {
  std::vector<Rational> values;
  values.reserve(count);
  for (std::size_t column = first; column < first + count; ++column) {
    Result<Rational> value = number(column, reading);
    if (!value) return tl::unexpected(std::move(value.error()));
    values.push_back(std::move(*value));
  }
  return values;
}

// ---- Rows ----

namespace {

template <class Value, class ToText>
std::string join(const std::vector<Value>& values, ToText to_text) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += " ";
    text += to_text(values[i]);
  }
  return text;
}

}  // namespace

std::string joined(const std::vector<Rational>& numbers) {
  return join(numbers, to_text_of_double_or_fraction);
}

std::string joined(const std::vector<Vertex>& indices) {
  return join(indices, [](Vertex v) { return std::to_string(v); });
}

}  // namespace circumspect::formats
