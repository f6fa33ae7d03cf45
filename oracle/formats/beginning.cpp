#include "oracle/formats/beginning.hpp"

#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {

Beginning::Beginning(const Source& source) : text(source.text) {
  Lines lines(source);
  if (!lines.next()) return;
  first_token = lines.tokens()[0];
  on_first_line = lines.size();
  if (on_first_line > 1) second_token = lines.tokens()[1];
  // "points dimension [attributes [markers]]" announces an index and so many numbers for each.
  columns_announced = 1;
  for (std::size_t column = 1; column < on_first_line && column < 4; ++column) {
    Vertex number = 0;
    const bool is_count = parse_integer(lines.tokens()[column], number) == std::errc();
    columns_announced += is_count && number >= 0 ? count_of(number) : 0;
  }
  if (lines.next()) on_second_line = lines.size();
}

bool Beginning::is_number() const {
  // There may be a sign.
  return first_token.empty() || first_token.find_first_of("0123456789") <= 1;
}

bool Beginning::is_list() const {
  return on_first_line > 1 && on_first_line == on_second_line &&
         columns_announced != on_second_line;
}

bool begins_with(std::string_view text, char c) { return from_first_word(text).starts_with(c); }

}  // namespace circumspect::formats
