#include "oracle/formats/netcdf.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace circumspect::formats {
namespace {

constexpr Vertex kDimensions = 10, kVariables = 11, kAttributes = 12;
constexpr std::size_t kAligned = 4;
constexpr Vertex kText = 2;

// Types 1 to 11; text has no numbers.
constexpr std::array kTypes = {
    NumberType{NumberType::Kind::kSigned, 1},   NumberType{NumberType::Kind::kUnsigned, 1},
    NumberType{NumberType::Kind::kSigned, 2},   NumberType{NumberType::Kind::kSigned, 4},
    NumberType{NumberType::Kind::kFloating, 4}, NumberType{NumberType::Kind::kFloating, 8},
    NumberType{NumberType::Kind::kUnsigned, 1}, NumberType{NumberType::Kind::kUnsigned, 2},
    NumberType{NumberType::Kind::kUnsigned, 4}, NumberType{NumberType::Kind::kSigned, 8},
    NumberType{NumberType::Kind::kUnsigned, 8},
};
constexpr NumberType kInt64{NumberType::Kind::kSigned, 8};

class NetcdfReader {
 public:
  explicit NetcdfReader(const Source& source)
      : source_(source), text_(source.name, source.text, NumberReading::kDouble) {
    text_.set_binary(ByteOrder::kBigEndian);
  }

  Result<NetcdfVariables> read();

 private:
  using Texts = std::map<std::string, std::string>;

  // A count or a length.
  Result<std::size_t> count(const char* what) { return text_.count(counts_, what); }
  Result<Vertex> type(const char* what);
  // So many bytes, and those that fill up four.
  Result<std::string> bytes(std::size_t size, const char* what);
  Result<std::string> name(const char* what);
  // How many there are in a list, which begins with its tag unless it is empty.
  Result<std::size_t> list(Vertex tag, const char* what);
  Status read_dimensions();
  Status read_attributes(Texts& texts);
  Status read_variable();

  const Source& source_;
  MixedText text_;
  NumberType counts_ = kInt32, places_ = kInt32;
  std::vector<std::size_t> dimensions_;  // 0: as many as there are records
  NetcdfVariables variables_;
};

Result<Vertex> NetcdfReader::type(const char* what) {
  const Result<Vertex> found = text_.integer(kInt32, what);
  if (!found || (*found >= 1 && *found <= static_cast<Vertex>(kTypes.size()))) return found;
  return text_.fail(std::string(what) + " from 1 to 11", std::to_string(*found));
}

Result<std::string> NetcdfReader::bytes(std::size_t size, const char* what) {
  const std::string_view rest =
      std::string_view(source_.text).substr(source_.text.size() - text_.bytes_left());
  const std::size_t padding = (kAligned - size % kAligned) % kAligned;
  if (size > rest.size() || !text_.skip_bytes(size + padding)) {
    return text_.fail(std::to_string(size) + " bytes of " + what, "the end of the file");
  }
  return std::string(rest.substr(0, size));
}

Result<std::string> NetcdfReader::name(const char* what) {
  const Result<std::size_t> size = count("the length of a name");
  if (!size) return tl::unexpected(size.error());
  return bytes(*size, what);
}

Result<std::size_t> NetcdfReader::list(Vertex tag, const char* what) {
  const Result<Vertex> found = text_.integer(kInt32, what);
  if (!found) return tl::unexpected(found.error());
  const Result<std::size_t> size = count(what);
  if (!size || *found == tag || (*found == 0 && *size == 0)) return size;
  return text_.fail(std::string(what) + ", " + std::to_string(tag), std::to_string(*found));
}

Status NetcdfReader::read_dimensions() {
  const Result<std::size_t> size = list(kDimensions, "the list of dimensions");
  if (!size) return tl::unexpected(size.error());
  for (std::size_t i = 0; i < *size; ++i) {
    if (const auto named = name("the name of a dimension"); !named) {
      return tl::unexpected(named.error());
    }
    const Result<std::size_t> length = count("the length of a dimension");
    if (!length) return tl::unexpected(length.error());
    dimensions_.push_back(*length);
  }
  return {};
}

Status NetcdfReader::read_attributes(Texts& texts) {
  const Result<std::size_t> size = list(kAttributes, "the list of attributes");
  if (!size) return tl::unexpected(size.error());
  for (std::size_t i = 0; i < *size; ++i) {
    Result<std::string> named = name("the name of an attribute");
    if (!named) return tl::unexpected(named.error());
    const Result<Vertex> of = type("the type of an attribute");
    if (!of) return tl::unexpected(of.error());
    const Result<std::size_t> values = count("the number of values of an attribute");
    if (!values) return tl::unexpected(values.error());
    std::size_t length = 0;
    if (__builtin_mul_overflow(*values, kTypes[static_cast<std::size_t>(*of - 1)].size, &length)) {
      length = source_.text.size() + 1;
    }
    Result<std::string> value = bytes(length, "an attribute");
    if (!value) return tl::unexpected(value.error());
    if (*of == kText) texts[std::move(*named)] = std::move(*value);
  }
  return {};
}

Status NetcdfReader::read_variable() {
  Result<std::string> named = name("the name of a variable");
  if (!named) return tl::unexpected(named.error());
  NetcdfVariable variable;
  const Result<std::size_t> axes = count("the number of dimensions of a variable");
  if (!axes) return tl::unexpected(axes.error());
  for (std::size_t i = 0; i < *axes; ++i) {
    const Result<std::size_t> axis = count("a dimension of a variable");
    if (!axis) return tl::unexpected(axis.error());
    if (*axis >= dimensions_.size()) {
      return text_.fail("a dimension, one of " + std::to_string(dimensions_.size()),
                        std::to_string(*axis));
    }
    variable.lengths.push_back(dimensions_[*axis]);
    if (dimensions_[*axis] == 0) variable.is_plain = false;
  }
  if (Status read = read_attributes(variable.texts); !read) return read;
  const Result<Vertex> of = type("the type of a variable");
  if (!of) return tl::unexpected(of.error());
  variable.type = kTypes[static_cast<std::size_t>(*of - 1)];
  if (*of == kText) variable.is_plain = false;
  // The size says too little where it does not fit, and the lengths say it as well.
  if (const auto size = text_.integer(counts_, "the size of a variable"); !size) {
    return tl::unexpected(size.error());
  }
  const Result<std::size_t> begin = text_.count(places_, "where a variable begins");
  if (!begin) return tl::unexpected(begin.error());
  variable.begin = *begin;
  variables_[std::move(*named)] = std::move(variable);
  return {};
}

Result<NetcdfVariables> NetcdfReader::read() {
  if (!is_netcdf(source_.text)) return text_.fail("CDF and the version 1, 2 or 5", "other bytes");
  const char version = source_.text[3];
  if (version == 5) counts_ = kInt64;
  if (version != 1) places_ = kInt64;
  text_.skip_bytes(4);
  // All bits are set while the file is being written.
  Status status;
  if (!text_.skip_bytes(counts_.size)) status = text_.fail("the number of records", "none");
  if (status) status = read_dimensions();
  Texts of_file;
  if (status) status = read_attributes(of_file);
  if (!status) return tl::unexpected(status.error());
  const Result<std::size_t> size = list(kVariables, "the list of variables");
  if (!size) return tl::unexpected(size.error());
  for (std::size_t i = 0; i < *size; ++i) {
    if (Status variable = read_variable(); !variable) return tl::unexpected(variable.error());
  }
  return std::move(variables_);
}

}  // namespace

bool is_netcdf(std::string_view bytes) {
  return bytes.size() >= 4 && bytes.starts_with("CDF") &&
         (bytes[3] == 1 || bytes[3] == 2 || bytes[3] == 5);
}

Result<NetcdfVariables> read_netcdf(const Source& source) { return NetcdfReader(source).read(); }

Result<MixedText> netcdf_numbers(const Source& source, const std::string& name,
                                 const NetcdfVariable& variable, NumberReading reading) {
  const auto fail = [&](std::string found) {
    return tl::unexpected(
        FormatError{source.name, 0, "the numbers of " + quote(name), std::move(found)});
  };
  if (!variable.is_plain) return fail("text, or a series of records");
  std::size_t size = variable.type.size, end = 0;
  for (const std::size_t length : variable.lengths) {
    if (__builtin_mul_overflow(size, length, &size)) return fail("more than a file can have");
  }
  if (__builtin_add_overflow(variable.begin, size, &end) || end > source.text.size()) {
    return fail("the end of the file at byte " + std::to_string(source.text.size()));
  }
  MixedText numbers(source.name, std::string_view(source.text).substr(variable.begin, size),
                    reading, 0);
  numbers.set_binary(ByteOrder::kBigEndian);
  return numbers;
}

}  // namespace circumspect::formats
