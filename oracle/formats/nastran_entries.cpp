#include "oracle/formats/nastran_entries.hpp"

#include <algorithm>
#include <utility>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {
namespace {

constexpr std::size_t kColumns = 8;  // of a small field; a large one has twice as many
constexpr std::size_t kSmallFields = 8;
constexpr std::size_t kLargeFields = 4;

// The line at which bulk data begins; 0 if none says so.
std::size_t line_of_bulk(const Source& source) {
  TextLines lines(source);
  while (lines.next()) {
    const std::string_view text = without_blanks(lines.text());
    if (text.size() < 5 || upper(text.substr(0, 5)) != "BEGIN") continue;
    if (upper(without_blanks(text.substr(5))).starts_with("BULK")) return lines.line();
  }
  return 0;
}

// A tab goes to the next small field.
std::string without_tabs(std::string_view text) {
  std::string expanded;
  for (const char c : text) {
    if (c == '\t') {
      expanded.append(kColumns - expanded.size() % kColumns, ' ');
    } else {
      expanded += c;
    }
  }
  return expanded;
}

// The first field of a line: a name, the mark of a continuation, or nothing.
std::string_view first_field(std::string_view text) {
  const std::size_t comma = text.find(',');
  return without_blanks(text.substr(0, comma == std::string_view::npos ? kColumns : comma));
}

bool is_mark(std::string_view field) { return field.starts_with('+') || field.starts_with('*'); }

// "1.5e-3" of 1.5-3 and of 1.5D-3.
std::string with_exponent(std::string_view field) {
  std::string text;
  for (const char c : field) {
    const bool is_sign = c == '+' || c == '-';
    if (is_sign && !text.empty() && text.back() != 'e') text += 'e';
    text += c == 'E' || c == 'd' || c == 'D' ? 'e' : c;
  }
  return text;
}

}  // namespace

NastranEntries::NastranEntries(const Source& source) : lines_(source) {
  const std::size_t bulk = line_of_bulk(source);
  while (lines_.line() < bulk) lines_.next();
  is_there_ = next_line();
}

bool NastranEntries::next_line() {
  while (lines_.next()) {
    const std::string_view text = lines_.text();
    text_ = without_tabs(text.substr(0, text.find('$')));
    if (!without_blanks(text_).empty()) return true;
  }
  return false;
}

bool NastranEntries::continues() const {
  const std::string_view field = first_field(text_);
  return field.empty() || is_mark(field);
}

bool NastranEntries::next() {
  if (!is_there_) return false;
  entry_.fields.clear();
  entry_.line = lines_.line();
  entry_.name = upper(first_field(text_));
  const bool has_star = entry_.name.ends_with('*');
  if (has_star) entry_.name = without_blanks(entry_.name.substr(0, entry_.name.size() - 1));
  if (entry_.name == "ENDDATA") return false;
  do {
    add_fields();
    is_there_ = next_line();
  } while (is_there_ && continues());
  return true;
}

void NastranEntries::add_fields() {
  const std::string_view first = first_field(text_);
  const bool is_large = first.starts_with('*') || first.ends_with('*');
  const std::size_t count = is_large ? kLargeFields : kSmallFields;
  const std::size_t all = entry_.fields.size() + count;
  std::string_view rest = text_;
  std::size_t comma = rest.find(',');
  if (comma == std::string_view::npos) {
    const std::size_t width = is_large ? 2 * kColumns : kColumns;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t begin = std::min(kColumns + i * width, rest.size());
      entry_.fields.push_back(
          {std::string(without_blanks(rest.substr(begin, width))), lines_.line()});
    }
    return;
  }
  while (comma != std::string_view::npos && entry_.fields.size() < all) {
    rest.remove_prefix(comma + 1);
    comma = rest.find(',');
    const std::string_view field = without_blanks(rest.substr(0, comma));
    // A mark may stand behind the last field, before the tenth.
    const bool is_last = comma == std::string_view::npos;
    const bool is_number =
        field.size() > 1 && field.find_first_not_of("+0123456789.eEdD-") == field.npos;
    if (is_last && is_mark(field) && !is_number) break;
    entry_.fields.push_back({std::string(field), lines_.line()});
  }
  while (entry_.fields.size() < all) entry_.fields.push_back({"", lines_.line()});
}

Result<std::optional<Vertex>> NastranEntries::integer(std::size_t place,
                                                      std::string_view what) const {
  if (place >= entry_.fields.size() || entry_.fields[place].text.empty()) return std::nullopt;
  Vertex value = 0;
  if (parse_integer(entry_.fields[place].text, value) == std::errc()) return value;
  return fail_at(place, std::string(what) + ", an integer of 64 bits");
}

Result<std::optional<Rational>> NastranEntries::number(std::size_t place,
                                                       NumberReading reading) const {
  if (place >= entry_.fields.size() || entry_.fields[place].text.empty()) return std::nullopt;
  tl::expected<Rational, NumberError> value =
      parse_number(with_exponent(entry_.fields[place].text), reading);
  if (!value) return fail_at(place, std::move(value.error().expected));
  return std::move(*value);
}

tl::unexpected<FormatError> NastranEntries::fail_at(std::size_t place, std::string expected) const {
  const bool is_there = place < entry_.fields.size();
  const std::string found = !is_there                           ? "the end of the entry"
                            : entry_.fields[place].text.empty() ? "an empty field"
                                                                : quote(entry_.fields[place].text);
  return tl::unexpected(FormatError{lines_.file(),
                                    is_there ? entry_.fields[place].line : entry_.line,
                                    std::move(expected), found});
}

tl::unexpected<FormatError> NastranEntries::fail_at_end(std::string expected) const {
  return lines_.fail(std::move(expected), "the end of the file");
}

}  // namespace circumspect::formats
