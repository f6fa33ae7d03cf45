#include "oracle/formats/vtu_arrays.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

#include <zlib.h>

#include "oracle/formats/base64.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/lz4.hpp"
#include "oracle/formats/lzma.hpp"

namespace circumspect::formats {

namespace {

// How many numbers a file may have: so many in any case, and more for each of its bytes. A number
// has at least one byte. If zlib has packed them, the numbers of meshes take about two bytes each,
// even if cells and points are in rows.
constexpr std::size_t kNumbersOfSmallFile = 100'000;
constexpr std::size_t kNumbersPerByte = 1;
constexpr std::size_t kNumbersPerPackedByte = 12;

bool unpack_zlib(std::string_view block, std::span<char> to) {
  uLongf made = to.size();
  return ::uncompress(reinterpret_cast<Bytef*>(to.data()), &made,
                      reinterpret_cast<const Bytef*>(block.data()), block.size()) == Z_OK &&
         made == to.size();
}

}  // namespace

std::size_t line_at(std::string_view text, std::size_t offset) {
  text = text.substr(0, offset);
  std::size_t line = 1;
  // Arrays in base 64 are one long line, which `find` passes much faster than `count` does.
  for (std::size_t at = text.find('\n'); at < text.size(); at = text.find('\n', at + 1)) ++line;
  return line;
}

Result<std::unique_ptr<VtuDocument>> VtuDocument::parse(const Source& source,
                                                        NumberReading reading) {
  std::unique_ptr<VtuDocument> file(new VtuDocument(source, reading));
  file->skeleton_ = XmlSkeleton(source.text);
  file->appended_ = file->skeleton_.appended();
  const std::string& xml = file->skeleton_.text();
  const pugi::xml_parse_result parsed =
      file->document_.load_buffer(xml.data(), xml.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) {
    const auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
    return tl::unexpected(FormatError{source.name,
                                      line_at(source.text, file->skeleton_.in_file(place)), "XML",
                                      "a fault: " + std::string(parsed.description())});
  }
  if (Status attributes = file->read_attributes(); !attributes) {
    return tl::unexpected(attributes.error());
  }
  return file;
}

std::size_t VtuDocument::line_of(pugi::xml_node node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  if (offset < 0) return 0;
  return line_at(source_.text, skeleton_.in_file(static_cast<std::size_t>(offset)));
}

tl::unexpected<FormatError> VtuDocument::fail(pugi::xml_node node, std::string expected,
                                              std::string found) const {
  return tl::unexpected(
      FormatError{source_.name, line_of(node), std::move(expected), std::move(found)});
}

Result<std::size_t> VtuDocument::count(pugi::xml_node node, const char* attribute) const {
  const std::string text = node.attribute(attribute).value();
  Vertex value = 0;
  const std::errc error = parse_integer(without_blanks(text), value);
  if (error == std::errc() && value >= 0) return count_of(value);
  return fail(node, std::string(attribute) + "=\"N\", an integer, 0 or more",
              text.empty() ? "none" : quote(text));
}

Status VtuDocument::read_attributes() {
  if (!root()) {
    return tl::unexpected(
        FormatError{source_.name, 1, "the element VTKFile", quote(document_.first_child().name())});
  }
  const std::string order = root().attribute("byte_order").as_string("LittleEndian");
  if (order != "LittleEndian" && order != "BigEndian") {
    return fail(root(), "byte_order=\"LittleEndian\" or \"BigEndian\"", quote(order));
  }
  if (order == "BigEndian") order_ = ByteOrder::kBigEndian;
  const std::string lengths = root().attribute("header_type").as_string("UInt32");
  if (lengths != "UInt32" && lengths != "UInt64") {
    return fail(root(), "header_type=\"UInt32\" or \"UInt64\"", quote(lengths));
  }
  if (lengths == "UInt64") size_of_lengths_ = 8;
  const std::string compressor = root().attribute("compressor").value();
  if (compressor == "vtkZLibDataCompressor") unpack_ = unpack_zlib;
  if (compressor == "vtkLZ4DataCompressor") unpack_ = unpack_lz4;
  if (compressor == "vtkLZMADataCompressor") {
    unpack_ = lzma_unpacker();
    if (unpack_ == nullptr) {
      return fail(root(), "no compressor, vtkZLibDataCompressor or vtkLZ4DataCompressor",
                  quote(compressor) +
                      " (write it with another, or build Circumspect where Debian's liblzma-dev is "
                      "installed)");
    }
  }
  if (unpack_ == nullptr && !compressor.empty()) {
    return fail(root(),
                "no compressor, vtkZLibDataCompressor, vtkLZ4DataCompressor or "
                "vtkLZMADataCompressor",
                quote(compressor));
  }
  const std::size_t per_byte = unpack_ != nullptr ? kNumbersPerPackedByte : kNumbersPerByte;
  most_numbers_ = kNumbersOfSmallFile + per_byte * source_.text.size();
  is_appended_base64_ =
      std::string_view(root().child("AppendedData").attribute("encoding").value()) == "base64";
  return {};
}

Status VtuDocument::take_numbers(pugi::xml_node node, std::size_t bytes, std::size_t bytes_each) {
  const std::size_t numbers = bytes / bytes_each;
  if (numbers <= most_numbers_ - numbers_) {
    numbers_ += numbers;
    return {};
  }
  return fail(node,
              "at most " + std::to_string(most_numbers_) + " numbers in all arrays of a file of " +
                  std::to_string(source_.text.size()) + " bytes",
              "more, with this array (one that several pieces share counts for each of them)");
}

std::optional<VtuDocument::Stored> VtuDocument::first_bytes(std::string_view stored, bool is_base64,
                                                            std::size_t count) {
  if (!is_base64) return Stored{nullptr, stored.substr(0, count)};
  std::optional<std::string> bytes = decode_base64(stored, count);
  if (!bytes) return std::nullopt;
  Stored decoded{std::make_unique<std::string>(std::move(*bytes))};
  decoded.bytes = *decoded.own;
  return decoded;
}

// After one length, so many bytes follow.
Result<VtuDocument::Stored> VtuDocument::decode(pugi::xml_node node, std::string_view stored,
                                                bool is_base64, std::size_t bytes_each) {
  const auto head = first_bytes(stored, is_base64, size_of_lengths_);
  if (!head) return fail(node, "bytes in base 64", "other characters");
  const auto length = Bytes(head->bytes, order_).unsigned_integer(size_of_lengths_);
  if (!length) return fail(node, "the number of bytes of the array", "the end of the data");
  const std::size_t most = stored.size();  // base 64 never holds more
  const Status taken = take_numbers(node, std::min<std::size_t>(*length, most), bytes_each);
  if (!taken) return tl::unexpected(taken.error());
  auto all =
      first_bytes(stored, is_base64, size_of_lengths_ + std::min<std::size_t>(*length, most));
  if (!all) return fail(node, "bytes in base 64", "other characters");
  all->bytes.remove_prefix(size_of_lengths_);
  if (all->bytes.size() < *length) {
    return fail(node, std::to_string(*length) + " bytes of the array",
                std::to_string(all->bytes.size()));
  }
  return std::move(*all);
}

// After the number of blocks: their size, the size of the last one, and the compressed size of
// each.
Result<VtuDocument::Stored> VtuDocument::inflate(pugi::xml_node node, std::string_view stored,
                                                 bool is_base64, std::size_t bytes_each) {
  const std::size_t most = stored.size();  // base 64 never holds more
  const auto beginning = first_bytes(stored, is_base64, size_of_lengths_);
  if (!beginning) return fail(node, "bytes in base 64", "other characters");
  const auto blocks = Bytes(beginning->bytes, order_).unsigned_integer(size_of_lengths_);
  if (!blocks) return fail(node, "the number of compressed blocks", "the end of the data");
  if (*blocks == 0) return Stored{};
  if (*blocks > most / size_of_lengths_) {
    return fail(node, "compressed blocks", std::to_string(*blocks) + ", more than there are bytes");
  }
  const std::size_t head_size = (3 + *blocks) * size_of_lengths_;
  const auto head = first_bytes(stored, is_base64, head_size);
  if (!head) return fail(node, "bytes in base 64", "other characters");
  if (head->bytes.size() < head_size) {
    return fail(node, "the sizes of " + std::to_string(*blocks) + " compressed blocks",
                "the end of the data");
  }
  Bytes lengths(head->bytes, order_);
  lengths.skip(size_of_lengths_);
  const std::size_t whole = *lengths.unsigned_integer(size_of_lengths_);
  const std::size_t last = *lengths.unsigned_integer(size_of_lengths_);
  std::vector<std::size_t> sizes;
  std::size_t total = 0;
  while (sizes.size() < *blocks) {
    sizes.push_back(*lengths.unsigned_integer(size_of_lengths_));
    if (sizes.back() > most - total) return fail(node, "compressed blocks", "the end of the data");
    total += sizes.back();
  }
  const auto all = first_bytes(stored, is_base64, head_size + total);
  if (!all) return fail(node, "bytes in base 64", "other characters");
  if (all->bytes.size() < head_size + total) {
    return fail(node, "compressed blocks", "the end of the data");
  }
  const std::size_t of_last = last != 0 ? last : whole;
  std::size_t all_made = 0;
  if (__builtin_mul_overflow(*blocks - 1, whole, &all_made) ||
      __builtin_add_overflow(all_made, of_last, &all_made)) {
    all_made = std::numeric_limits<std::size_t>::max();
  }
  if (Status taken = take_numbers(node, all_made, bytes_each); !taken) {
    return tl::unexpected(taken.error());
  }
  std::string_view rest = all->bytes.substr(head_size);
  Stored made_of{std::make_unique<std::string>()};
  for (std::size_t i = 0; i < *blocks; ++i) {
    const std::size_t wanted = i + 1 == *blocks ? of_last : whole;
    made_of.own->resize(made_of.own->size() + wanted);
    if (!unpack_(rest.substr(0, sizes[i]), std::span(*made_of.own).last(wanted))) {
      return fail(node,
                  "block " + std::to_string(i + 1) + " of " + std::to_string(*blocks) +
                      ", compressed, of " + std::to_string(wanted) + " bytes",
                  "other data");
    }
    rest.remove_prefix(sizes[i]);
  }
  made_of.bytes = *made_of.own;
  return made_of;
}

Result<VtuDocument::Array> VtuDocument::array(pugi::xml_node node) {
  using enum NumberType::Kind;
  static const std::map<std::string, NumberType, std::less<>> types = {
      {"Int8", {kSigned, 1}},     {"UInt8", {kUnsigned, 1}},  {"Int16", {kSigned, 2}},
      {"UInt16", {kUnsigned, 2}}, {"Int32", {kSigned, 4}},    {"UInt32", {kUnsigned, 4}},
      {"Int64", {kSigned, 8}},    {"UInt64", {kUnsigned, 8}}, {"Float32", {kFloating, 4}},
      {"Float64", {kFloating, 8}}};
  const std::string_view type_name = node.attribute("type").value();
  const auto type = types.find(type_name);
  if (type == types.end()) {
    return fail(node, "a type of numbers, as Float64", quote(type_name));
  }
  const std::string_view format = node.attribute("format").value();
  const pugi::xml_node content =
      node.find_child([](pugi::xml_node child) { return child.type() == pugi::node_pcdata; });
  const auto left_out = skeleton_.content_of(
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
  const std::string_view own = left_out.value_or(std::string_view(content.value()));
  if (format == "ascii") {
    const std::size_t line =
        left_out ? line_at(source_.text, static_cast<std::size_t>(own.data() - source_.text.data()))
        : content ? line_of(content)
                  : line_of(node);
    return Array{type->second, nullptr, MixedText(source_.name, own, reading_, line)};
  }
  std::string_view stored = own;
  if (format == "appended") {
    const Result<std::size_t> offset = count(node, "offset");
    if (!offset) return tl::unexpected(offset.error());
    if (*offset > appended_.size()) {
      return fail(
          node,
          "an offset within the " + std::to_string(appended_.size()) + " bytes of AppendedData",
          std::to_string(*offset));
    }
    stored = appended_.substr(*offset);
  } else if (format != "binary") {
    return fail(node, "format=\"ascii\", \"binary\" or \"appended\"", quote(format));
  }
  const bool is_base64 = format == "binary" || is_appended_base64_;
  const std::size_t each = type->second.size;
  Result<Stored> bytes = unpack_ != nullptr ? inflate(node, stored, is_base64, each)
                                            : decode(node, stored, is_base64, each);
  if (!bytes) return tl::unexpected(bytes.error());
  MixedText text(source_.name + ":" + std::to_string(line_of(node)), bytes->bytes, reading_);
  text.set_binary(order_);
  return Array{type->second, std::move(bytes->own), std::move(text)};
}

}  // namespace circumspect::formats
