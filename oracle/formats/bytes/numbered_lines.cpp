#include "oracle/formats/bytes/numbered_lines.hpp"

#include <algorithm>
#include <utility>

namespace circumspect::formats {

NumberedLines::NumberedLines(const Source& source, std::string one, std::string many)
    : lines_(source), one_(std::move(one)), many_(std::move(many)) {}

Status NumberedLines::read_header(const std::string& layout, std::size_t fewest, std::size_t most) {
  if (!lines_.next()) return lines_.fail("a header \"" + layout + "\"", "the end of the file");
  return read_count(layout, fewest, most);
}

Result<bool> NumberedLines::read_optional_header(const std::string& layout, std::size_t fewest,
                                                 std::size_t most) {
  if (!lines_.next()) return false;
  if (Status status = read_count(layout, fewest, most); !status) {
    return tl::unexpected(status.error());
  }
  return true;
}

Status NumberedLines::read_count(const std::string& layout, std::size_t fewest, std::size_t most) {
  const std::string expected = "a header \"" + layout + "\"";
  if (lines_.size() < fewest) return lines_.fail_at(lines_.size(), expected);
  if (lines_.size() > most) return lines_.fail_at(most, expected + " and the end of the line");
  const Result<std::size_t> count = lines_.count(0, "the number of " + many_);
  if (!count) return tl::unexpected(count.error());
  count_ = *count;
  return {};
}

Result<std::size_t> NumberedLines::header_count(std::size_t column, std::string_view what) const {
  if (column >= lines_.size()) return std::size_t{0};
  return lines_.count(column, what);
}

void NumberedLines::begin_list(std::string one, std::string many) {
  one_ = std::move(one);
  many_ = std::move(many);
  count_ = 0;
  done_ = 0;
  first_index_ = 0;
  any_index_ = false;
}

void NumberedLines::expect_columns(std::size_t columns, std::string meaning) {
  columns_ = columns;
  meaning_ = std::move(meaning);
}

Result<bool> NumberedLines::next() {
  const Result<bool> more = next_in_list();
  if (!more || *more) return more;
  if (Status end = expect_end(); !end) return tl::unexpected(end.error());
  return false;
}

Status NumberedLines::expect_end() {
  if (!lines_.next()) return {};
  return lines_.fail_at(0, "the end of the file after " + std::to_string(count_) + " " + many_);
}

Result<bool> NumberedLines::next_in_list() {
  if (done_ == count_) return false;
  if (!lines_.next()) {
    return lines_.fail(one_ + " " + std::to_string(done_ + 1) + " of " + std::to_string(count_),
                       "the end of the file");
  }
  if (Status index = check_index(); !index) return tl::unexpected(index.error());
  if (columns_ != 0 && lines_.size() != columns_) {
    return lines_.fail(std::to_string(columns_) + " columns (" + meaning_ + ")",
                       std::to_string(lines_.size()));
  }
  ++done_;
  return true;
}

Status NumberedLines::check_index() {
  Vertex index = 0;
  if (parse_integer(lines_.tokens()[0], index) != std::errc()) {
    return tl::unexpected(lines_.integer(0, "the index of a " + one_).error());
  }
  if (done_ == 0) first_index_ = index;
  if (any_index_) return {};
  Vertex due = 0;
  const bool overflows = __builtin_add_overflow(first_index_, static_cast<Vertex>(done_), &due);
  if (overflows) return lines_.fail_at(0, "indices that fit 64 bits");
  if (index == due) return {};
  return lines_.fail_at(0, "index " + std::to_string(due) + ", one more than the line before");
}

std::size_t NumberedLines::lines_at_most() const {
  // A column takes at least one character and a separator.
  const std::size_t fit =
      lines_.bytes_left() / (2 * std::clamp<std::size_t>(columns_, 1, lines_.bytes_left() + 1)) + 1;
  return std::min(count_ - done_, fit);
}

void write_numbered(std::ostream& out, Vertex first_index,
                    const std::vector<std::vector<Vertex>>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vertex index = first_index + static_cast<Vertex>(i);
    out << std::to_string(index) + " " + joined(rows[i]) + "\n";
  }
}

}  // namespace circumspect::formats
