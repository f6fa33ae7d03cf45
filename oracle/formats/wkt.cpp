#include "oracle/formats/wkt.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/rings.hpp"

namespace circumspect::formats {
namespace {

constexpr std::string_view kCollection = "GeometryCollection";

// What WKT has beside the geometries of GeoJSON.
constexpr Geometry kFurther[] = {{"Triangle", Geometry::Kind::kPolygons, 3},
                                 {"Tin", Geometry::Kind::kPolygons, 4},
                                 {"PolyhedralSurface", Geometry::Kind::kPolygons, 4}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_white(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

const Geometry* geometry_of(std::string_view word) {
  for (const Geometry& geometry : kGeometries) {
    if (is_word(word, geometry.name)) return &geometry;
  }
  for (const Geometry& geometry : kFurther) {
    if (is_word(word, geometry.name)) return &geometry;
  }
  return nullptr;
}

// The columns of a position: x y, x y z, x y m or x y z m; if nobody says, those that are there.
enum class PositionColumns { kAsListed, kXyz, kXym, kXyzm };

// Words, numbers and punctuation, and the line of each.
class Words {
 public:
  explicit Words(const Source& source) : source_(source), rest_(behind_mark(source.text)) {
    next();
  }

  // Empty at the end of the text.
  std::string_view word() const { return word_; }
  std::size_t line() const { return line_; }

  void next() {
    while (!rest_.empty() && is_white(rest_.front())) {
      line_ += rest_.front() == '\n' ? 1 : 0;
      rest_.remove_prefix(1);
    }
    std::size_t size = rest_.empty() ? 0 : 1;
    if (size == 1 && !is_punctuation(rest_.front())) {
      while (size < rest_.size() && !is_punctuation(rest_[size]) && !is_white(rest_[size])) ++size;
    }
    word_ = rest_.substr(0, size);
    rest_.remove_prefix(size);
  }
  bool take(std::string_view word) {
    if (word_ != word) return false;
    next();
    return true;
  }
  tl::unexpected<FormatError> fail(std::string expected) const {
    return tl::unexpected(FormatError{source_.name, line_, std::move(expected),
                                      word_.empty() ? "the end of the file" : quote(word_)});
  }

 private:
  static bool is_punctuation(char c) { return c == '(' || c == ')' || c == ',' || c == ';'; }

  const Source& source_;
  std::string_view rest_;
  std::string_view word_ = {};
  std::size_t line_ = 1;
};

class WktReader {
 public:
  WktReader(const Source& source, NumberReading reading)
      : words_(source), reading_(reading), rings_(source.name) {}

  Result<DomainFile> read();

 private:
  PositionColumns columns(std::string_view behind);
  Status geometry();
  Result<Coordinates> list(int depth, PositionColumns columns);
  Result<Coordinates> position(PositionColumns columns);

  Words words_;
  NumberReading reading_;
  Rings rings_;
  std::size_t collections_ = 0;  // that are open
};

// "Z" may be a word of its own, or the end of the geometry's name.
PositionColumns WktReader::columns(std::string_view behind) {
  const auto named = [](std::string_view word) -> std::optional<PositionColumns> {
    if (is_word(word, "z")) return PositionColumns::kXyz;
    if (is_word(word, "m")) return PositionColumns::kXym;
    if (is_word(word, "zm")) return PositionColumns::kXyzm;
    return std::nullopt;
  };
  if (!behind.empty()) return named(behind).value_or(PositionColumns::kAsListed);
  const auto found = named(words_.word());
  if (found) words_.next();
  return found.value_or(PositionColumns::kAsListed);
}

Result<Coordinates> WktReader::position(PositionColumns columns) {
  Coordinates position{words_.line()};
  const bool in_parentheses = words_.take("(");  // as some write the points of a MULTIPOINT
  while (!words_.word().empty() && words_.word() != "," && words_.word() != ")") {
    tl::expected<Rational, NumberError> value = parse_number(words_.word(), reading_);
    if (!value) return words_.fail(value.error().expected);
    if (position.position.size() == 4) return words_.fail("the end of a position of 4 numbers");
    position.position.push_back(std::move(*value));
    words_.next();
  }
  const std::size_t wanted = columns == PositionColumns::kXyzm ? 4 : 3;
  if (columns != PositionColumns::kAsListed && position.position.size() != wanted) {
    return words_.fail(std::to_string(wanted) + " coordinates of a position");
  }
  if (columns == PositionColumns::kXym || columns == PositionColumns::kXyzm)
    position.position.pop_back();
  if (in_parentheses && !words_.take(")")) return words_.fail("\")\" after a position");
  return position;
}

Result<Coordinates> WktReader::list(int depth, PositionColumns columns) {
  Coordinates list{words_.line()};
  if (is_word(words_.word(), "empty")) {
    words_.next();
    return list;
  }
  if (!words_.take("(")) return words_.fail("\"(\" or EMPTY");
  do {
    auto part = depth == 2 ? position(columns) : this->list(depth - 1, columns);
    if (!part) return part;
    list.parts.push_back(std::move(*part));
  } while (words_.take(","));
  if (!words_.take(")")) return words_.fail("\",\" or \")\"");
  return list;
}

Status WktReader::geometry() {
  std::string_view name = words_.word();
  std::string_view behind = {};
  const Geometry* geometry = geometry_of(name);
  for (const std::string_view ending : {"ZM", "Z", "M"}) {
    if (geometry != nullptr || name.size() <= ending.size()) continue;
    behind = name.substr(name.size() - ending.size());
    geometry = is_word(behind, ending) ? geometry_of(name.substr(0, name.size() - ending.size()))
                                       : nullptr;
  }
  if (geometry == nullptr) {
    return words_.fail("a geometry of straight lines, such as POLYGON or MULTIPOLYGON");
  }
  words_.next();
  const PositionColumns found = columns(behind);
  if (geometry->depth > 1) {
    const Result<Coordinates> listed = list(geometry->depth, found);
    return listed ? rings_.add(*geometry, *listed) : tl::unexpected(listed.error());
  }
  if (is_word(words_.word(), "empty")) {
    words_.next();
    return {};
  }
  if (words_.word() != "(") return words_.fail("\"(\" or EMPTY");
  const Result<Coordinates> only = position(found);
  return only ? rings_.add(*geometry, *only) : tl::unexpected(only.error());
}

Result<DomainFile> WktReader::read() {
  while (!words_.word().empty()) {
    const std::string_view word = words_.word();
    const std::string_view begin = word.substr(0, kCollection.size());
    if (word.size() > 5 && is_word(word.substr(0, 5), "srid=")) {
      words_.next();
    } else if (collections_ > 0 && words_.take(")")) {
      --collections_;
    } else if (word == "," || word == ";") {
      words_.next();
    } else if (is_word(begin, kCollection)) {
      words_.next();
      columns(word.substr(begin.size()));  // those of its geometries count
      if (is_word(words_.word(), "empty")) {
        words_.next();
      } else if (words_.take("(")) {
        ++collections_;
      } else {
        return words_.fail("\"(\" or EMPTY");
      }
    } else if (Status status = geometry(); !status) {
      return tl::unexpected(status.error());
    }
  }
  if (collections_ > 0) return words_.fail("\")\" after a collection");
  return rings_.finish();
}

}  // namespace

Result<DomainFile> read_wkt(const Source& source, NumberReading reading) {
  return WktReader(source, reading).read();
}

bool is_wkt(std::string_view text) {
  text = from_first_word(text);
  std::size_t size = 0;
  while (size < text.size() && size < 32 && is_letter(text[size])) ++size;
  std::string_view word = text.substr(0, size);
  if (is_word(word, "srid") && text.substr(size).starts_with("=")) return true;
  while (!word.empty() && geometry_of(word) == nullptr && !is_word(word, kCollection)) {
    const char last = word.back();
    if (last != 'Z' && last != 'M' && last != 'z' && last != 'm') return false;
    word.remove_suffix(1);
  }
  const std::size_t behind = text.find_first_not_of(" \t\r\n", size);
  return !word.empty() && behind != std::string_view::npos &&
         (text[behind] == '(' || is_letter(text[behind]));
}

}  // namespace circumspect::formats
