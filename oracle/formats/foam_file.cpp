#include "oracle/formats/foam_file.hpp"

#include <algorithm>
#include <utility>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {
namespace {

constexpr std::string_view kMarks = "(){};";

// The number behind a key of the architecture, "LSB;label=32;scalar=64", in bytes.
std::size_t bytes_behind(std::string_view arch, std::string_view key, std::size_t usual) {
  const std::size_t found = arch.find(key);
  if (found == std::string_view::npos) return usual;
  return arch.substr(found + key.size()).starts_with("64") ? 8 : 4;
}

}  // namespace

bool is_foam_file(std::string_view text) {
  return text.substr(0, 4096).find("FoamFile") != std::string_view::npos;
}

Result<FoamFile> FoamFile::open(const Source& source, NumberReading reading) {
  FoamFile file(source, reading);
  if (Status header = file.read_header(); !header) return tl::unexpected(header.error());
  return file;
}

std::size_t FoamFile::line() const {
  const std::string_view before = std::string_view(source_.text).substr(0, word_at_);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

tl::unexpected<FormatError> FoamFile::fail(std::string expected, std::string found) const {
  return tl::unexpected(FormatError{source_.name, line(), std::move(expected), std::move(found)});
}

tl::unexpected<FormatError> FoamFile::fail_at_word(std::string expected) const {
  return fail(std::move(expected), word_.empty() ? "the end of the file" : quote(word_));
}

void FoamFile::skip_blanks() {
  const std::string_view text = source_.text;
  while (at_ < text.size()) {
    const std::string_view rest = text.substr(at_);
    if (is_space(rest.front())) {
      ++at_;
    } else if (rest.starts_with("//")) {
      at_ = std::min(text.find('\n', at_), text.size());
    } else if (rest.starts_with("/*")) {
      const std::size_t end = text.find("*/", at_ + 2);
      at_ = end == std::string_view::npos ? text.size() : end + 2;
    } else {
      return;
    }
  }
}

std::string_view FoamFile::word() {
  skip_blanks();
  const std::string_view text = source_.text;
  word_at_ = at_;
  std::size_t end = at_;
  if (end < text.size() && text[end] == '"') {
    end = std::min(text.find('"', end + 1), text.size() - 1) + 1;
  } else {
    while (end < text.size() && !is_space(text[end]) && kMarks.find(text[end]) == kMarks.npos)
      ++end;
    if (end == at_ && end < text.size()) ++end;  // a mark
  }
  word_ = text.substr(at_, end - at_);
  at_ = end;
  return word_;
}

Status FoamFile::expect(std::string_view mark, const std::string& where) {
  if (word() == mark) return {};
  return fail_at_word("\"" + std::string(mark) + "\" " + where);
}

Status FoamFile::read_header() {
  if (word() != "FoamFile") return fail_at_word("FoamFile");
  if (Status begin = expect("{", "behind FoamFile"); !begin) return begin;
  while (word() != "}") {
    if (word_.empty()) return fail_at_word("\"}\" behind the header");
    const std::string key(word_);
    std::string value;
    while (word() != ";") {
      if (word_.empty()) return fail_at_word("\";\" behind a value of the header");
      value += word_;
    }
    if (key == "format" && value != "ascii" && value != "binary") {
      return fail("the format ascii or binary", quote(value));
    }
    if (key == "format") is_binary_ = value == "binary";
    if (key == "class") is_compact_ = value == "faceCompactList";
    if (key == "arch") {
      if (value.find("MSB") != std::string::npos) order_ = ByteOrder::kBigEndian;
      label_size_ = bytes_behind(value, "label=", label_size_);
      scalar_size_ = bytes_behind(value, "scalar=", scalar_size_);
    }
  }
  return {};
}

Result<Vertex> FoamFile::integer(const std::string& what) {
  Vertex value = 0;
  if (parse_integer(word(), value) == std::errc()) return value;
  return fail_at_word(what + ", an integer");
}

Result<std::size_t> FoamFile::count(const std::string& what) {
  const Result<Vertex> value = integer(what);
  if (!value) return tl::unexpected(value.error());
  if (*value < 0) return fail_at_word(what + ", 0 or more");
  return count_of(*value);
}

Result<std::string_view> FoamFile::stored(std::size_t count, std::size_t size,
                                          const std::string& what) {
  if (count == 0) {  // nothing, or nothing in parentheses
    const std::size_t before = at_;
    if (word() == "(") {
      if (Status end = expect(")", "behind " + what); !end) return tl::unexpected(end.error());
    } else {
      at_ = before;
    }
    return std::string_view();
  }
  if (Status begin = expect("(", "before " + what); !begin) return tl::unexpected(begin.error());
  const std::string_view rest = std::string_view(source_.text).substr(at_);
  if (count > rest.size() / size) {
    return fail(std::to_string(count) + " " + what + " of " + std::to_string(size) + " bytes",
                std::to_string(rest.size()) + " bytes");
  }
  at_ += count * size;
  if (Status end = expect(")", "behind " + what); !end) return tl::unexpected(end.error());
  return rest.substr(0, count * size);
}

Status FoamFile::read_points(PointRows& to) {
  const Result<std::size_t> points = count("the number of points");
  if (!points) return tl::unexpected(points.error());
  if (is_binary_) {
    const auto bytes = stored(*points, 3 * scalar_size_, "points");
    if (!bytes) return tl::unexpected(bytes.error());
    MixedText numbers(source_.name, *bytes, reading_);
    numbers.set_binary(order_);
    return numbers.points({NumberType::Kind::kFloating, scalar_size_}, *points,
                          {"a coordinate of ", "point", 0, *points}, to);
  }
  if (Status begin = expect("(", "before points"); !begin) return begin;
  for (std::size_t i = 0; i < *points; ++i) {
    const std::string which = "point " + std::to_string(i + 1) + " of " + std::to_string(*points);
    if (Status begin = expect("(", "before " + which); !begin) return begin;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      tl::expected<Rational, NumberError> value = parse_number(word(), reading_);
      if (!value) return fail_at_word(std::move(value.error().expected) + " of " + which);
      to.add(std::move(*value));
    }
    if (Status end = expect(")", "behind " + which); !end) return end;
  }
  return expect(")", "behind points");
}

Result<Indices> FoamFile::read_label_list(const std::string& what) {
  const Result<std::size_t> labels = count("the number of " + what);
  if (!labels) return tl::unexpected(labels.error());
  Indices values;
  if (is_binary_) {
    const auto bytes = stored(*labels, label_size_, what);
    if (!bytes) return tl::unexpected(bytes.error());
    MixedText numbers(source_.name, *bytes, reading_);
    numbers.set_binary(order_);
    const Status read =
        numbers.integers({NumberType::Kind::kSigned, label_size_}, *labels, what, values);
    if (!read) return tl::unexpected(read.error());
    return values;
  }
  if (Status begin = expect("(", "before " + what); !begin) return tl::unexpected(begin.error());
  for (std::size_t i = 0; i < *labels; ++i) {
    const Result<Vertex> value = integer("one of " + std::to_string(*labels) + " " + what);
    if (!value) return tl::unexpected(value.error());
    values.push_back(*value);
  }
  if (Status end = expect(")", "behind " + what); !end) return tl::unexpected(end.error());
  return values;
}

Result<Indices> FoamFile::read_labels() { return read_label_list("cells"); }

Result<SimplexRows> FoamFile::read_faces() {
  SimplexRows faces;
  Simplex face;
  if (is_compact_) {
    const Result<Indices> begins = read_label_list("places at which faces begin");
    if (!begins) return tl::unexpected(begins.error());
    const Result<Indices> vertices = read_label_list("vertices of faces");
    if (!vertices) return tl::unexpected(vertices.error());
    for (std::size_t i = 0; i + 1 < begins->size(); ++i) {
      const Vertex begin = (*begins)[i];
      const Vertex end = (*begins)[i + 1];
      if (begin < 0 || end < begin || end > static_cast<Vertex>(vertices->size())) {
        return fail("places of faces that go up to " + std::to_string(vertices->size()),
                    std::to_string(begin) + ", then " + std::to_string(end));
      }
      face.clear();
      for (Vertex v = begin; v < end; ++v) face.push_back((*vertices)[static_cast<std::size_t>(v)]);
      faces.push_back(face);
    }
    return faces;
  }
  if (is_binary_) return fail("faces of the class faceCompactList in a binary file", "others");
  const Result<std::size_t> all = count("the number of faces");
  if (!all) return tl::unexpected(all.error());
  if (Status begin = expect("(", "before faces"); !begin) return tl::unexpected(begin.error());
  for (std::size_t i = 0; i < *all; ++i) {
    const std::string which = "face " + std::to_string(i + 1) + " of " + std::to_string(*all);
    const Result<std::size_t> size = count("the number of vertices of " + which);
    if (!size) return tl::unexpected(size.error());
    if (Status begin = expect("(", "before " + which); !begin) return tl::unexpected(begin.error());
    face.clear();
    for (std::size_t j = 0; j < *size; ++j) {
      const Result<Vertex> vertex = integer("a vertex of " + which);
      if (!vertex) return tl::unexpected(vertex.error());
      face.push_back(*vertex);
    }
    if (Status end = expect(")", "behind " + which); !end) return tl::unexpected(end.error());
    faces.push_back(face);
  }
  if (Status end = expect(")", "behind faces"); !end) return tl::unexpected(end.error());
  return faces;
}

}  // namespace circumspect::formats
