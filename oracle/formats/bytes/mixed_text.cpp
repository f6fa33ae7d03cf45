#include "oracle/formats/bytes/mixed_text.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {

std::string Item::words() const {
  const std::string text = std::string(what) + std::string(noun);
  if (count == 0) return text;
  return text + " " + std::to_string(place + 1) + " of " + std::to_string(count);
}

MixedText::MixedText(std::string name, std::string_view text, NumberReading reading,
                     std::size_t first_line)
    : name_(std::move(name)),
      text_(text),
      reading_(reading),
      line_(first_line),
      word_line_(first_line),
      first_line_(first_line) {}

MixedText::MixedText(const Source& source, NumberReading reading)
    : MixedText(source.name, source.text, reading) {
  at_ = text_.size() - behind_mark(text_).size();
}

void MixedText::begin_section() {
  section_ = shortened(word_);
  section_at_ = read_at_;
}

std::string_view MixedText::peek() {
  skip_blanks();
  std::size_t end = at_;
  while (end < text_.size() && !is_space(text_[end])) ++end;
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

Result<Rational> MixedText::number(NumberType type, const Item& item) {
  if (type.kind != NumberType::Kind::kFloating) {
    const Result<Vertex> value = integer(type, item);
    if (!value) return tl::unexpected(value.error());
    return Rational(to_integer(*value));
  }
  if (is_binary()) {
    const std::optional<std::uint64_t> stored = bits(type.size);
    if (!stored) return fail(item.words(), "the end of the data");
    std::optional<Rational> value = as_floating(*stored, type.size);
    if (!value) return fail(item.words() + ", a finite number", "NaN or an infinity");
    return std::move(*value);
  }
  if (word().empty()) return fail_at_word(item.words());
  tl::expected<Rational, NumberError> value = parse_number(word_, reading_);
  if (!value) return fail_at_word(item.words() + ", " + value.error().expected);
  return std::move(*value);
}

Result<Vertex> MixedText::integer(NumberType type, const Item& item) {
  if (is_binary()) {
    if (type.kind == NumberType::Kind::kFloating) {
      return fail(item.words() + ", an integer", "floating-point numbers");
    }
    const std::optional<std::uint64_t> stored = bits(type.size);
    if (!stored) return fail(item.words(), "the end of the data");
    if (type.kind == NumberType::Kind::kSigned) return as_signed(*stored, type.size);
    const auto value = static_cast<Vertex>(*stored);
    if (value < 0) return fail(item.words() + ", less than 2^63", std::to_string(*stored));
    return value;
  }
  if (word().empty()) return fail_at_word(item.words());
  Vertex value = 0;
  const std::errc error = parse_integer(word_, value);
  if (error == std::errc()) return value;
  return fail_at_word(item.words() + (error == std::errc::result_out_of_range
                                          ? ", an integer that fits 64 bits"
                                          : ", an integer"));
}

Result<std::size_t> MixedText::count(NumberType type, const Item& item) {
  const Result<Vertex> value = integer(type, item);
  if (!value) return tl::unexpected(value.error());
  if (*value < 0) return fail(item.words() + ", 0 or more", std::to_string(*value));
  return count_of(*value);
}

Result<std::size_t> MixedText::count_in_text(const Item& item) {
  const std::optional<ByteOrder> order = std::exchange(binary_, std::nullopt);
  Result<std::size_t> value = count(kUint64, item);
  binary_ = order;
  return value;
}

Status MixedText::skip_numbers(NumberType type, std::size_t count, const Item& item) {
  if (is_binary()) {
    // The count may be anything, so it is not multiplied before it is known to be small.
    if (count <= bytes_left() / type.size && skip_bytes(count * type.size)) return {};
    skip_bytes(bytes_left());
    return fail(item.words(), "the end of the data");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (word().empty()) return fail_at_word(item.words());
  }
  return {};
}

Vertex MixedText::take_slowly(NumberType type, const Item& item) {
  if (failure_) return 0;
  // The usual indices of binary files.
  const bool is_64 = type.size == 8, is_integer = type.kind != NumberType::Kind::kFloating;
  if (binary_ && is_integer && (is_64 || type.size == 4) && type.size <= bytes_left()) {
    const char* const from = text_.data() + at_;
    const bool swapped = is_swapped(*binary_);
    const Vertex value = is_64 ? stored_number<std::int64_t>(from, swapped)
                         : type.kind == NumberType::Kind::kSigned
                             ? Vertex{stored_number<std::int32_t>(from, swapped)}
                             : Vertex{stored_number<std::uint32_t>(from, swapped)};
    if (type.kind == NumberType::Kind::kSigned || value >= 0) {
      skip_bytes(type.size);
      return value;
    }
  }
  const Result<Vertex> value = integer(type, item);
  if (value) return *value;
  failure_ = value.error();
  return 0;
}

// A decimal in text that needs no exact reading; else nothing is read.
bool MixedText::read_plain(double& number) {
  skip_blanks();
  const char* const begin = text_.data() + at_;
  const char* const end = text_.data() + text_.size();
  const char* const stop = read_plain_decimal(begin, end, number);
  if (stop == nullptr || !ends_word(stop, end)) return false;
  took(static_cast<std::size_t>(stop - begin));
  return true;
}

Status MixedText::points(NumberType type, std::size_t count, Item item, PointRows& to) {
  // A number takes two bytes in text: more points than that do not fit, whatever the count says.
  const std::size_t each = to.columns() * (is_binary() ? type.size : 2);
  to.reserve(std::min(count, bytes_left() / each + 1));
  const bool is_bulk = is_binary() && type.kind == NumberType::Kind::kFloating;
  return is_bulk ? binary_points(type, count, item, to) : text_points(type, count, item, to);
}

Status MixedText::text_points(NumberType type, std::size_t count, Item item, PointRows& to) {
  const bool is_plain = !is_binary() && reading_ == NumberReading::kDouble &&
                        type.kind == NumberType::Kind::kFloating;
  for (; count > 0; --count, ++item.place) {
    for (std::size_t column = 0; column < to.columns(); ++column) {
      double plain = 0;
      if (is_plain && read_plain(plain)) {
        to.add(plain);
        continue;
      }
      Result<Rational> value = number(type, item);
      if (!value) return tl::unexpected(std::move(value.error()));
      to.add(std::move(*value));
    }
  }
  return {};
}

namespace {

// Turns so many bytes into numbers; returns how many are finite, from the first on.
template <class Stored>
std::size_t finite_numbers(const char* from, bool is_swapped, std::span<double> to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = stored_number<Stored>(from + i * sizeof(Stored), is_swapped) + 0.0;
  }
  const auto bad = std::find_if(to.begin(), to.end(), [](double x) { return !std::isfinite(x); });
  return static_cast<std::size_t>(bad - to.begin());
}

}  // namespace

Status MixedText::binary_points(NumberType type, std::size_t count, Item item, PointRows& to) {
  const std::size_t columns = to.columns();
  const std::size_t there = bytes_left() / type.size;
  const bool are_there = count <= there / columns;
  const std::size_t numbers = are_there ? count * columns : there;
  const std::size_t before = to.numbers();
  UninitializedVector<double> own;
  std::span<double> room = to.grow(numbers);
  if (room.empty() && numbers > 0) {  // there are exact numbers before
    own.resize(numbers);
    room = own;
  }
  const bool swapped = is_swapped(*binary_);
  const char* const from = text_.data() + at_;
  const std::size_t finite = type.size == 4 ? finite_numbers<float>(from, swapped, room)
                                            : finite_numbers<double>(from, swapped, room);
  for (const double number : own) {
    if (to.numbers() < before + finite) to.add(number);
  }
  if (finite == numbers && are_there) {
    skip_bytes(numbers * type.size);
    if (numbers > 0) read_at_ = at_ - type.size;
    return {};
  }
  // The message is that of the first number that is wrong or missing.
  to.shrink_to(before + finite);
  skip_bytes(finite * type.size);
  item.place += finite / columns;
  const Result<Rational> value = number(type, item);
  return tl::unexpected(value.error());
}

namespace {

// Turns so many bytes into indices; false if one does not fit 32 bits.
template <class Stored>
bool narrow_indices(const char* from, bool is_swapped, std::span<std::int32_t> to) {
  bool fit = true;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const auto value = stored_number<Stored>(from + i * sizeof(Stored), is_swapped);
    to[i] = static_cast<std::int32_t>(value);
    fit &= static_cast<Stored>(to[i]) == value && (std::is_signed_v<Stored> || to[i] >= 0);
  }
  return fit;
}

bool narrow_indices(NumberType type, const char* from, bool is_swapped,
                    std::span<std::int32_t> to) {
  const bool is_signed = type.kind == NumberType::Kind::kSigned;
  if (type.kind == NumberType::Kind::kFloating) return false;
  switch (type.size) {
    case 1:
      return is_signed ? narrow_indices<std::int8_t>(from, is_swapped, to)
                       : narrow_indices<std::uint8_t>(from, is_swapped, to);
    case 2:
      return is_signed ? narrow_indices<std::int16_t>(from, is_swapped, to)
                       : narrow_indices<std::uint16_t>(from, is_swapped, to);
    case 4:
      return is_signed ? narrow_indices<std::int32_t>(from, is_swapped, to)
                       : narrow_indices<std::uint32_t>(from, is_swapped, to);
    default:
      return is_signed ? narrow_indices<std::int64_t>(from, is_swapped, to)
                       : narrow_indices<std::uint64_t>(from, is_swapped, to);
  }
}

}  // namespace

Status MixedText::integers(NumberType type, std::size_t count, const Item& item, Indices& to) {
  const std::size_t each = is_binary() ? type.size : 2;
  to.reserve(to.size() + std::min(count, bytes_left() / each + 1));
  const std::size_t before = to.size();
  if (is_binary() && count > 0 && count <= bytes_left() / type.size) {
    const std::span<std::int32_t> room = to.grow(count);
    if (!room.empty() && narrow_indices(type, text_.data() + at_, is_swapped(*binary_), room)) {
      skip_bytes(count * type.size);
      read_at_ = at_ - type.size;
      return {};
    }
    to.shrink_to(before);
  }
  for (; count > 0 && !failure_; --count) {
    const Vertex value = take(type, item);
    if (!failure_) to.push_back(value);
  }
  if (!failure_) return {};
  FormatError error = std::move(*failure_);
  failure_.reset();
  return tl::unexpected(std::move(error));
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
