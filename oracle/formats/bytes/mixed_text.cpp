#include "oracle/formats/bytes/mixed_text.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {

bool Bytes::skip(std::size_t count) {
  if (count > rest_.size()) return false;
  rest_.remove_prefix(count);
  return true;
}

std::optional<std::uint64_t> Bytes::unsigned_integer(std::size_t size) {
  if (size > rest_.size()) return std::nullopt;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = order_ == ByteOrder::kBigEndian ? i : size - 1 - i;
    value = value << 8U | static_cast<unsigned char>(rest_[place]);
  }
  rest_.remove_prefix(size);
  return value;
}

std::int64_t as_signed(std::uint64_t bits, std::size_t size) {
  const std::size_t unused = 8 * (8 - size);
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

std::optional<Rational> as_floating(std::uint64_t bits, std::size_t size) {
  const double value = size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                                 : std::bit_cast<double>(bits);
  if (!std::isfinite(value)) return std::nullopt;
  return exact_value(value);
}

// ---- Mixed text ----

namespace {

constexpr std::string_view kBlanksAndEnds = " \t\r\n\v\f";

}  // namespace

MixedText::MixedText(std::string name, std::string_view text, NumberReading reading,
                     std::size_t first_line)
    : name_(std::move(name)),
      text_(text),
      reading_(reading),
      line_(first_line),
      word_line_(first_line),
      first_line_(first_line) {}

void MixedText::begin_section() {
  section_ = word_;
  section_at_ = read_at_;
}

void MixedText::skip_blanks() {
  const std::size_t end = std::min(text_.find_first_not_of(kBlanksAndEnds, at_), text_.size());
  line_ +=
      static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                          text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
  at_ = end;
}

std::string_view MixedText::peek() {
  skip_blanks();
  const std::size_t end = std::min(text_.find_first_of(kBlanksAndEnds, at_), text_.size());
  return text_.substr(at_, end - at_);
}

std::string_view MixedText::word() {
  word_ = peek();
  if (!word_.empty()) word_line_ = line_;
  read_at_ = at_;
  at_ += word_.size();
  return word_;
}

std::string_view MixedText::rest_of_line() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string_view rest = text_.substr(at_, end - at_);
  word_line_ = line_;
  read_at_ = at_;
  at_ = std::min(end + 1, text_.size());
  if (end < text_.size()) ++line_;
  while (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  return rest;
}

bool MixedText::skip_behind(std::string_view text, bool begins_line) {
  std::size_t found = text_.find(text, at_);
  while (begins_line && found != std::string_view::npos && found > 0 && text_[found - 1] != '\n') {
    found = text_.find(text, found + 1);
  }
  const std::size_t end = found == std::string_view::npos ? text_.size() : found + text.size();
  line_ +=
      static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                          text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
  at_ = end;
  word_ = found == std::string_view::npos ? std::string_view() : text;
  word_line_ = line_;
  return found != std::string_view::npos;
}

bool MixedText::skip_bytes(std::size_t count) {
  read_at_ = at_;
  was_binary_ = true;
  if (count > bytes_left()) {
    at_ = text_.size();
    return false;
  }
  at_ += count;
  return true;
}

bool MixedText::is_at_end() {
  if (!is_binary()) skip_blanks();
  return at_ == text_.size();
}

std::optional<std::uint64_t> MixedText::bits(std::size_t size) {
  Bytes bytes(text_.substr(at_), *binary_);
  const std::optional<std::uint64_t> value = bytes.unsigned_integer(size);
  skip_bytes(size);
  return value;
}

Result<Rational> MixedText::number(NumberType type, std::string_view what) {
  if (type.kind != NumberType::Kind::kFloating) {
    const Result<Vertex> value = integer(type, what);
    if (!value) return tl::unexpected(value.error());
    return Rational(to_integer(*value));
  }
  if (is_binary()) {
    const std::optional<std::uint64_t> stored = bits(type.size);
    if (!stored) return fail(std::string(what), "the end of the data");
    std::optional<Rational> value = as_floating(*stored, type.size);
    if (!value) return fail(std::string(what) + ", a finite number", "NaN or an infinity");
    return std::move(*value);
  }
  if (word().empty()) return fail_at_word(std::string(what));
  tl::expected<Rational, NumberError> value = parse_number(word_, reading_);
  if (!value) return fail_at_word(std::string(what) + ", " + value.error().expected);
  return std::move(*value);
}

Result<Vertex> MixedText::integer(NumberType type, std::string_view what) {
  if (is_binary()) {
    const std::optional<std::uint64_t> stored = bits(type.size);
    if (!stored) return fail(std::string(what), "the end of the data");
    if (type.kind == NumberType::Kind::kSigned) return as_signed(*stored, type.size);
    const auto value = static_cast<Vertex>(*stored);
    if (value < 0) return fail(std::string(what) + ", less than 2^63", std::to_string(*stored));
    return value;
  }
  if (word().empty()) return fail_at_word(std::string(what));
  Vertex value = 0;
  const std::errc error = parse_integer(word_, value);
  if (error == std::errc()) return value;
  return fail_at_word(std::string(what) + (error == std::errc::result_out_of_range
                                               ? ", an integer that fits 64 bits"
                                               : ", an integer"));
}

Result<std::size_t> MixedText::count(NumberType type, std::string_view what) {
  const Result<Vertex> value = integer(type, what);
  if (!value) return tl::unexpected(value.error());
  if (*value < 0) return fail(std::string(what) + ", 0 or more", std::to_string(*value));
  return count_of(*value);
}

Result<std::size_t> MixedText::count_in_text(std::string_view what) {
  const std::optional<ByteOrder> order = std::exchange(binary_, std::nullopt);
  Result<std::size_t> value = count(kUint64, what);
  binary_ = order;
  return value;
}

Status MixedText::skip_numbers(NumberType type, std::size_t count, std::string_view what) {
  if (is_binary()) {
    // The count may be anything, so it is not multiplied before it is known to be small.
    if (count <= bytes_left() / type.size && skip_bytes(count * type.size)) return {};
    skip_bytes(bytes_left());
    return fail(std::string(what), "the end of the data");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (word().empty()) return fail_at_word(std::string(what));
  }
  return {};
}

tl::unexpected<FormatError> MixedText::fail(std::string expected, std::string found) const {
  std::size_t line = this->line();
  if (was_binary_) {
    found += " at byte " + std::to_string(read_at_);
    if (!section_.empty()) {
      if (section_at_ != read_at_) found += ", in " + section_;
      const std::string_view before = text_.substr(0, section_at_);
      line = first_line_ + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    }
  }
  return tl::unexpected(FormatError{name_, line, std::move(expected), std::move(found)});
}

tl::unexpected<FormatError> MixedText::fail_at_word(std::string expected) const {
  return fail(std::move(expected), word_.empty() ? "the end of the file" : quote(word_));
}

}  // namespace circumspect::formats
