#include <algorithm>
#include <map>

#include "oracle/formats/ply.hpp"

namespace circumspect::formats {
namespace {

std::optional<PlyType> type_of(std::string_view name) {
  using enum PlyType::Kind;
  static const std::map<std::string_view, PlyType> types = {
      {"char", {kSigned, 1}},     {"int8", {kSigned, 1}},      {"uchar", {kUnsigned, 1}},
      {"uint8", {kUnsigned, 1}},  {"short", {kSigned, 2}},     {"int16", {kSigned, 2}},
      {"ushort", {kUnsigned, 2}}, {"uint16", {kUnsigned, 2}},  {"int", {kSigned, 4}},
      {"int32", {kSigned, 4}},    {"uint", {kUnsigned, 4}},    {"uint32", {kUnsigned, 4}},
      {"float", {kFloating, 4}},  {"float32", {kFloating, 4}}, {"double", {kFloating, 8}},
      {"float64", {kFloating, 8}}};
  const auto found = types.find(name);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

Result<PlyType> read_type(const Lines& lines, std::size_t column, bool is_count) {
  const std::optional<PlyType> type =
      column < lines.size() ? type_of(lines.tokens()[column]) : std::nullopt;
  if (type && !(is_count && type->kind == PlyType::Kind::kFloating)) return *type;
  return lines.fail_at(column, is_count ? "the type of a count, an integer type"
                                        : "a type (char, uchar, short, ushort, int, uint, float, "
                                          "double)");
}

Status expect_size(const Lines& lines, std::size_t size) {
  if (lines.size() == size) return {};
  return lines.fail_at(std::min(size, lines.size()),
                       lines.size() < size ? "more words" : "the end of the line");
}

Status read_format(const Lines& lines, PlyHeader& header) {
  if (Status size = expect_size(lines, 3); !size) return size;
  const std::string_view format = lines.tokens()[1];
  if (format == "binary_little_endian") {
    header.binary = ByteOrder::kLittleEndian;
  } else if (format == "binary_big_endian") {
    header.binary = ByteOrder::kBigEndian;
  } else if (format != "ascii") {
    return lines.fail_at(1, "ascii, binary_little_endian or binary_big_endian");
  }
  if (lines.tokens()[2] != "1.0") return lines.fail_at(2, "version 1.0");
  return {};
}

Status read_element(const Lines& lines, PlyHeader& header) {
  if (Status size = expect_size(lines, 3); !size) return size;
  const Result<std::size_t> count = lines.count(2, "the number of elements");
  if (!count) return tl::unexpected(count.error());
  header.elements.push_back({std::string(lines.tokens()[1]), *count});
  return {};
}

// "property TYPE NAME" or "property list TYPE TYPE NAME".
Status read_property(const Lines& lines, PlyHeader& header) {
  if (header.elements.empty()) return lines.fail_at(0, "\"element\" before the first property");
  const bool is_list = lines.size() > 1 && lines.tokens()[1] == "list";
  if (Status size = expect_size(lines, is_list ? 5 : 3); !size) return size;
  PlyProperty property;
  if (is_list) {
    const Result<PlyType> count = read_type(lines, 2, true);
    if (!count) return tl::unexpected(count.error());
    property.count = *count;
  }
  const Result<PlyType> type = read_type(lines, is_list ? 3 : 1, false);
  if (!type) return tl::unexpected(type.error());
  property.type = *type;
  property.name = lines.tokens().back();
  header.elements.back().properties.push_back(std::move(property));
  return {};
}

Status check_elements(const Lines& lines, const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (!element.properties.empty()) continue;
    return lines.fail("a property of each element", "none of " + quote(element.name));
  }
  return {};
}

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property, bool is_list) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property && properties[i].count.has_value() == is_list) return i;
  }
  return std::nullopt;
}

Result<PlyHeader> read_ply_header(Lines& lines) {
  if (!lines.next() || lines.tokens()[0] != "ply" || lines.size() != 1) {
    return lines.fail_at(0, "the keyword ply");
  }
  PlyHeader header;
  if (!lines.next() || lines.tokens()[0] != "format") return lines.fail_at(0, "\"format\"");
  if (Status format = read_format(lines, header); !format) return tl::unexpected(format.error());
  while (lines.next()) {
    const std::string_view word = lines.tokens()[0];
    Status status;
    if (word == "end_header") {
      status = check_elements(lines, header);
      if (!status) return tl::unexpected(status.error());
      return header;
    }
    if (word == "element") {
      status = read_element(lines, header);
    } else if (word == "property") {
      status = read_property(lines, header);
    } else if (word != "comment" && word != "obj_info") {
      status = lines.fail_at(0, "\"element\", \"property\", \"comment\" or \"end_header\"");
    }
    if (!status) return tl::unexpected(status.error());
  }
  return lines.fail_at(0, "\"end_header\"");
}

}  // namespace circumspect::formats
