#include "oracle/formats/bytes/lines.hpp"

#include <algorithm>
#include <charconv>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"

namespace circumspect::formats {

namespace {

bool is_blank(char c) { return is_space(c) && c != '\n'; }

void split(std::string_view line, char comment, std::vector<std::string_view>& tokens) {
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at != end) {
    if (*at == comment) return;
    if (is_blank(*at)) {
      ++at;
      continue;
    }
    const char* const begin = at;
    while (at != end && !is_blank(*at) && *at != comment) ++at;
    tokens.emplace_back(begin, static_cast<std::size_t>(at - begin));
  }
}

// The whole token, if it is a plain one.
bool is_plain_integer(std::string_view token, Vertex& value) {
  const char* const end = token.data() + token.size();
  return read_plain_integer(token.data(), end, value) == end;
}
bool is_plain_decimal(std::string_view token, double& value) {
  const char* const end = token.data() + token.size();
  return read_plain_decimal(token.data(), end, value) == end;
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

Lines::Lines(const Source& source, char end, char comment)
    : source_(source), rest_(behind_mark(source.text)), end_(end), comment_(comment) {}

bool Lines::next() {
  tokens_.clear();
  while (!rest_.empty()) {
    ++line_;
    const std::size_t length = std::min(rest_.find(end_), rest_.size());
    split(rest_.substr(0, length), comment_, tokens_);
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
  return count_of(*value);
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

std::optional<Vertex> Lines::plain_integer(std::size_t column) const {
  Vertex value = 0;
  return is_plain_integer(tokens_[column], value) ? std::optional(value) : std::nullopt;
}

Status Lines::integers(std::size_t first, std::size_t count, std::string_view what,
                       Simplex& to) const {
  to.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (is_plain_integer(tokens_[first + i], to[i])) continue;
    const Result<Vertex> value = integer(first + i, what);
    if (!value) return tl::unexpected(value.error());
    to[i] = *value;
  }
  return {};
}

Status Lines::add_numbers(std::size_t first, std::size_t count, NumberReading reading,
                          PointRows& to) const {
  for (std::size_t column = first; column < first + count; ++column) {
    double plain = 0;
    if (reading == NumberReading::kDouble && is_plain_decimal(tokens_[column], plain)) {
      to.add(plain);
      continue;
    }
    Result<Rational> value = number(column, reading);
    if (!value) return tl::unexpected(std::move(value.error()));
    to.add(std::move(*value));
  }
  return {};
}

Status Lines::check_numbers(std::size_t first, std::size_t count, NumberReading reading) const {
  for (std::size_t column = first; column < first + count; ++column) {
    double plain = 0;
    if (reading == NumberReading::kDouble && is_plain_decimal(tokens_[column], plain)) continue;
    const Result<Rational> value = number(column, reading);
    if (!value) return tl::unexpected(value.error());
  }
  return {};
}

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
