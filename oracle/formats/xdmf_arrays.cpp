#include "oracle/formats/xdmf_arrays.hpp"

#include <algorithm>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/hdf5.hpp"
#include "oracle/formats/vtu_arrays.hpp"

namespace circumspect::formats {
namespace {

constexpr std::size_t kMostDimensions = 8;

// How many numbers an array of these lengths has. Requires: as many fit 64 bits.
std::size_t product(const std::vector<std::size_t>& lengths) {
  std::size_t count = 1;
  for (const std::size_t length : lengths) count *= length;
  return count;
}

std::string_view attribute_of(pugi::xml_node node, const char* name, const char* other) {
  return node.attribute(name) ? node.attribute(name).value() : node.attribute(other).value();
}

void add_grids(pugi::xml_node within, std::vector<pugi::xml_node>& grids) {
  for (const pugi::xml_node grid : within.children("Grid")) {
    grids.push_back(grid);
    // A collection of collections is the deepest that programs write.
    for (const pugi::xml_node inner : grid.children("Grid")) {
      grids.push_back(inner);
      for (const pugi::xml_node last : inner.children("Grid")) grids.push_back(last);
    }
  }
}

}  // namespace

std::size_t XdmfArray::numbers() const { return product(dimensions); }

Status XdmfArray::expect_end(const std::string& what) {
  if (text.is_at_end()) return {};
  const std::string more =
      text.is_binary() ? std::to_string(text.bytes_left()) + " more bytes" : quote(text.word());
  return text.fail("the end of " + what, more);
}

Result<std::unique_ptr<XdmfDocument>> XdmfDocument::parse(const Source& source,
                                                          NumberReading reading) {
  std::unique_ptr<XdmfDocument> file(new XdmfDocument(source, reading));
  const pugi::xml_parse_result parsed = file->document_.load_buffer(
      source.text.data(), source.text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) {
    const auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
    return tl::unexpected(FormatError{source.name, line_at(source.text, place), "XML",
                                      "a fault: " + std::string(parsed.description())});
  }
  if (file->root()) return file;
  return tl::unexpected(FormatError{source.name, 1, "the element Xdmf",
                                    quote(file->document_.document_element().name())});
}

std::vector<pugi::xml_node> XdmfDocument::grids() const {
  std::vector<pugi::xml_node> grids;
  for (const pugi::xml_node domain : root().children("Domain")) add_grids(domain, grids);
  return grids;
}

std::size_t XdmfDocument::line_of(pugi::xml_node node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  return offset < 0 ? 0 : line_at(source_.text, static_cast<std::size_t>(offset));
}

tl::unexpected<FormatError> XdmfDocument::fail(pugi::xml_node node, std::string expected,
                                               std::string found) const {
  return tl::unexpected(
      FormatError{source_.name, line_of(node), std::move(expected), std::move(found)});
}

Result<std::vector<std::size_t>> XdmfDocument::dimensions(pugi::xml_node item) const {
  const std::string said = item.attribute("Dimensions").value();
  const Source text{"", said};
  Lines lines(text);
  std::vector<std::size_t> found;
  std::size_t numbers = 1;
  const std::string expected = "Dimensions=\"N M\", whole numbers whose product fits 64 bits";
  if (!lines.next() || lines.size() > kMostDimensions) {
    return fail(item, expected, said.empty() ? "none" : quote(said));
  }
  for (const std::string_view token : lines.tokens()) {
    Vertex length = 0;
    if (parse_integer(token, length) != std::errc() || length < 0 ||
        __builtin_mul_overflow(numbers, count_of(length), &numbers)) {
      return fail(item, expected, quote(said));
    }
    found.push_back(count_of(length));
  }
  return found;
}

Result<NumberType> XdmfDocument::type_of(pugi::xml_node item) const {
  std::string_view name = attribute_of(item, "NumberType", "DataType");
  if (name.empty()) name = "Float";
  const std::string precision = item.attribute("Precision").as_string("4");
  const bool is_byte = is_word(name, "char") || is_word(name, "uchar");
  const std::size_t size = is_byte ? 1 : precision == "8" ? 8 : precision == "4" ? 4 : 0;
  const bool is_real = is_word(name, "float");
  const bool is_unsigned = is_word(name, "uint") || is_word(name, "uchar");
  if (size == 0 || !(is_real || is_unsigned || is_word(name, "int") || is_byte)) {
    return fail(item, "NumberType=\"Float\", \"Int\" or \"UInt\" of Precision=\"4\" or \"8\"",
                quote(name) + " of " + quote(precision));
  }
  return NumberType{is_real       ? NumberType::Kind::kFloating
                    : is_unsigned ? NumberType::Kind::kUnsigned
                                  : NumberType::Kind::kSigned,
                    size};
}

Result<const Source*> XdmfDocument::other_file(pugi::xml_node item, std::string_view path) {
  const std::size_t slash = source_.name.rfind('/');
  const std::string whole =
      (slash == std::string::npos ? "" : source_.name.substr(0, slash + 1)) + std::string(path);
  for (const auto& other : others_) {
    if (other->name == whole) return other.get();
  }
  const bool is_below = !path.empty() && path.front() != '/' && path.find("..") == path.npos;
  if (!is_below || !is_regular(whole)) {
    return fail(item, "a file in the same folder or below it",
                (is_below ? "no file " : "") + quote(path));
  }
  Result<Source> other = load_unpacked(whole);
  if (!other) return tl::unexpected(other.error());
  others_.push_back(std::make_unique<Source>(std::move(*other)));
  return others_.back().get();
}

Result<XdmfArray> XdmfDocument::from_hdf5(pugi::xml_node item, std::string_view text,
                                          const std::vector<std::size_t>& dimensions) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) {
    return fail(item, "FILE.h5:/PATH of a data set", quote(text));
  }
  const Result<const Source*> file = other_file(item, text.substr(0, colon));
  if (!file) return tl::unexpected(file.error());
  Result<Hdf5Array> read = read_hdf5(**file, text.substr(colon + 1));
  if (!read) return tl::unexpected(read.error());
  if (product(read->dimensions) != product(dimensions)) {
    return fail(item, std::to_string(product(dimensions)) + " numbers, by its Dimensions",
                std::to_string(product(read->dimensions)) + " in " + quote(text));
  }
  auto own = std::make_unique<std::string>(std::move(read->bytes));
  MixedText numbers(source_.name + ":" + std::to_string(line_of(item)), *own, reading_);
  numbers.set_binary(read->order);
  return XdmfArray{dimensions, read->type, std::move(own), std::move(numbers)};
}

Result<XdmfArray> XdmfDocument::from_bytes(pugi::xml_node item, std::string_view path,
                                           XdmfArray array) {
  const std::string order = item.attribute("Endian").as_string("Native");
  const std::string packed = item.attribute("Compression").as_string("Raw");
  const std::string seek = item.attribute("Seek").as_string("0");
  if (order != "Native" && order != "Little" && order != "Big") {
    return fail(item, "Endian=\"Native\", \"Little\" or \"Big\"", quote(order));
  }
  if (packed != "Raw" || seek != "0") {
    return fail(item, "bytes as they are, without Compression or Seek",
                quote(packed != "Raw" ? packed : seek));
  }
  const Result<const Source*> file = other_file(item, path);
  if (!file) return tl::unexpected(file.error());
  const std::size_t bytes = (*file)->text.size();
  if (bytes % array.type.size != 0 || bytes / array.type.size != array.numbers()) {
    return fail(item,
                std::to_string(array.numbers()) + " numbers of " + std::to_string(array.type.size) +
                    " bytes in " + quote(path),
                std::to_string(bytes) + " bytes");
  }
  array.text = MixedText((*file)->name, (*file)->text, reading_);
  array.text.set_binary(order == "Big" ? ByteOrder::kBigEndian : ByteOrder::kLittleEndian);
  return array;
}

Result<XdmfArray> XdmfDocument::array(pugi::xml_node item, pugi::xml_node of) {
  if (!item) return fail(of, "a DataItem in " + std::string(of.name()), "none");
  const std::string kind = item.attribute("ItemType").as_string("Uniform");
  if (kind != "Uniform" || item.attribute("Reference")) {
    return fail(item, "a DataItem with numbers of its own",
                kind != "Uniform" ? "ItemType=" + quote(kind) : "a Reference");
  }
  Result<std::vector<std::size_t>> lengths = dimensions(item);
  if (!lengths) return tl::unexpected(lengths.error());
  const Result<NumberType> type = type_of(item);
  if (!type) return tl::unexpected(type.error());
  const std::string format = item.attribute("Format").as_string("XML");
  const pugi::xml_node content = item.first_child();
  const std::string_view text = content.value();
  if (format == "HDF") return from_hdf5(item, without_blanks(text), *lengths);
  XdmfArray array{std::move(*lengths), *type, nullptr,
                  MixedText(source_.name, text, reading_, line_of(content ? content : item))};
  if (format == "Binary") return from_bytes(item, without_blanks(text), std::move(array));
  if (format != "XML") return fail(item, "Format=\"XML\", \"HDF\" or \"Binary\"", quote(format));
  // A number has a character at least.
  if (array.numbers() <= text.size()) return array;
  return fail(item, std::to_string(array.numbers()) + " numbers, by its Dimensions",
              "a text of " + std::to_string(text.size()) + " characters");
}

}  // namespace circumspect::formats
