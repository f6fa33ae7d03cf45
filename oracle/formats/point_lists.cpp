#include "oracle/formats/point_lists.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {

namespace {

// The fields of a line, without the blanks and quotes around them.
std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  constexpr std::string_view kAround = " \t\r\"";
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = std::min(line.find(separator), line.size());
    std::string_view field = line.substr(0, end);
    const std::size_t first = std::min(field.find_first_not_of(kAround), field.size());
    field.remove_prefix(first);
    field = field.substr(0, field.find_last_not_of(kAround) + 1);
    fields.push_back(field);
    if (end == line.size()) return fields;
    line.remove_prefix(end + 1);
  }
}

// Does a field begin like a number?
bool is_number(std::string_view field) { return field.find_first_of("0123456789") <= 1; }

// Which coordinate a column of this name holds; nothing for other columns.
std::optional<std::size_t> axis_of(std::string_view name) {
  constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
  constexpr std::array<std::string_view, 3> kOfParaView = {"points:0", "points:1", "points:2"};
  std::string lower(name);
  for (char& c : lower) {
    c = c == '_' ? ':' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (std::size_t axis = 0; axis < kNames.size(); ++axis) {
    if (lower == kNames[axis] || lower == kOfParaView[axis]) return axis;
  }
  return std::nullopt;
}

class CsvReader {
 public:
  CsvReader(const Source& source, NumberReading reading)
      : name_(source.name), rest_(behind_mark(source.text)), reading_(reading) {}

  Result<PointFile> read() {
    bool is_first = true;
    while (next()) {
      Status status;
      if (is_first) {
        status = read_first();
        is_first = false;
      } else {
        status = read_point();
      }
      if (!status) return tl::unexpected(status.error());
    }
    if (!is_first) return std::move(file_);
    return fail("a point, or the names of columns", "the end of the file");
  }

 private:
  // Goes to the next non-empty line.
  bool next() {
    while (!rest_.empty()) {
      ++line_;
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      const std::string_view text = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      if (text.find_first_not_of(" \t\r") == std::string_view::npos) continue;
      if (separator_ == 0) {
        const bool has_commas = text.find(',') != std::string_view::npos;
        separator_ = has_commas                                  ? ','
                     : text.find(';') != std::string_view::npos  ? ';'
                     : text.find('\t') != std::string_view::npos ? '\t'
                                                                 : ',';
      }
      fields_ = fields_of(text, separator_);
      return true;
    }
    return false;
  }

  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return tl::unexpected(
        FormatError{name_, std::max<std::size_t>(line_, 1), std::move(expected), std::move(found)});
  }

  // A point, or the names of the columns.
  Status read_first() {
    columns_ = fields_.size();
    if (is_number(fields_.front())) {
      for (std::size_t i = 0; i < columns_; ++i) places_.push_back(i);
    } else {
      std::array<std::optional<std::size_t>, 3> found;
      for (std::size_t i = 0; i < columns_; ++i) {
        const auto axis = axis_of(fields_[i]);
        if (!axis) continue;
        if (found[*axis]) return fail("one column " + std::string(fields_[i]), "two");
        found[*axis] = i;
      }
      for (const auto& place : found) {
        if (place) places_.push_back(*place);
      }
      if (!found[0] || (found[2] && !found[1])) {
        return fail("a number, or columns named x, y and z", quote(fields_.front()));
      }
    }
    if (places_.size() > kLargestDimension) {
      return fail("at most " + std::to_string(kLargestDimension) + " coordinates",
                  std::to_string(places_.size()));
    }
    file_.dimension = places_.size();
    return is_number(fields_.front()) ? read_point() : Status{};
  }

  Status read_point() {
    if (fields_.size() != columns_) {
      return fail(std::to_string(columns_) + " columns, as on the first line",
                  std::to_string(fields_.size()));
    }
    Point point;
    for (const std::size_t place : places_) {
      tl::expected<Rational, NumberError> number = parse_number(fields_[place], reading_);
      if (!number) return fail(std::move(number.error().expected), quote(fields_[place]));
      point.push_back(std::move(*number));
    }
    file_.points.push_back(std::move(point));
    return {};
  }

  std::string name_;
  std::string_view rest_;
  NumberReading reading_;
  std::size_t line_ = 0;
  char separator_ = 0;
  std::vector<std::string_view> fields_;
  std::size_t columns_ = 0;
  std::vector<std::size_t> places_;  // the columns of the coordinates
  PointFile file_;
};

}  // namespace

Result<PointFile> read_xyz(const Source& source, NumberReading reading) {
  Lines lines(source);
  PointFile file;
  while (lines.next()) {
    if (file.points.empty()) {
      if (!is_number(lines.tokens()[0])) {
        return lines.fail_at(0, "a line of coordinates for each point");
      }
      file.dimension = lines.size();
      if (file.dimension > kLargestDimension) {
        return lines.fail("at most " + std::to_string(kLargestDimension) + " coordinates",
                          std::to_string(file.dimension));
      }
    }
    if (lines.size() != file.dimension) {
      return lines.fail(std::to_string(file.dimension) + " coordinates, as on the first line",
                        std::to_string(lines.size()));
    }
    file.points.set_columns(file.dimension);
    const Status point = lines.add_numbers(0, lines.size(), reading, file.points);
    if (!point) return tl::unexpected(point.error());
  }
  if (!file.points.empty()) return file;
  return lines.fail_at(0, "a line of coordinates for each point");
}

Result<PointFile> read_csv(const Source& source, NumberReading reading) {
  return CsvReader(source, reading).read();
}

}  // namespace circumspect::formats
