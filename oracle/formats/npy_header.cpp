#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include "oracle/formats/npy.hpp"

namespace circumspect::formats {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

// NumPy itself refuses longer ones.
constexpr std::size_t kLongestHeader = 10000;

tl::unexpected<FormatError> header_fault(const std::string& name, std::string expected,
                                         std::string found) {
  return tl::unexpected(FormatError{name, 0, std::move(expected), std::move(found)});
}

// Parses the dictionary.
class Literal {
 public:
  explicit Literal(std::string_view text) : rest_(text) {}

  std::string_view rest() const { return rest_; }

  bool take(char c) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool take_word(std::string_view word) {
    skip_blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  // The text between quotes of either kind. No name or type that NumPy writes has a backslash.
  std::optional<std::string> take_string() {
    skip_blanks();
    if (rest_.empty() || (rest_.front() != '\'' && rest_.front() != '"')) return std::nullopt;
    const std::size_t end = rest_.find(rest_.front(), 1);
    if (end == std::string_view::npos) return std::nullopt;
    std::string text(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return text;
  }

  // An integer, 0 or more, perhaps with the L of Python 2.
  std::optional<std::size_t> take_integer() {
    skip_blanks();
    std::size_t value = 0;
    const char* const last = rest_.data() + rest_.size();
    const auto [end, error] = std::from_chars(rest_.data(), last, value);
    if (error != std::errc()) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    take_word("L");
    return value;
  }

  std::optional<std::vector<std::size_t>> take_tuple() {
    if (!take('(')) return std::nullopt;
    std::vector<std::size_t> values;
    while (!take(')')) {
      const std::optional<std::size_t> value = take_integer();
      if (!value) return std::nullopt;
      values.push_back(*value);
      if (take(',')) continue;
      if (!take(')')) return std::nullopt;
      break;
    }
    return values;
  }

  // A type: a string, or the list of the fields of a structured one, which ends with its bracket.
  std::optional<std::string> take_type() {
    if (std::optional<std::string> type = take_string()) return type;
    if (rest_.empty() || rest_.front() != '[') return std::nullopt;
    std::size_t depth = 0;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (rest_[i] == '[') ++depth;
      if (rest_[i] != ']' || --depth > 0) continue;
      std::string type(rest_.substr(0, i + 1));
      rest_.remove_prefix(i + 1);
      return type;
    }
    return std::nullopt;
  }

 private:
  void skip_blanks() {
    const std::size_t first = rest_.find_first_not_of(" \t\r\n");
    rest_.remove_prefix(std::min(first, rest_.size()));
  }

  std::string_view rest_;
};

constexpr std::array<std::string_view, 3> kKeys = {"descr", "fortran_order", "shape"};

// The value of a key; false if it has the wrong type.
bool take_value(Literal& literal, std::string_view key, NpyHeader& header) {
  if (key == "descr") {
    const std::optional<std::string> type = literal.take_type();
    header.type = type.value_or("");
    return type.has_value();
  }
  if (key == "shape") {
    std::optional<std::vector<std::size_t>> shape = literal.take_tuple();
    if (shape) header.shape = std::move(*shape);
    return shape.has_value();
  }
  header.fortran_order = literal.take_word("True");
  return header.fortran_order || literal.take_word("False");
}

// The three keys, in any order, each once. False if the text is anything else.
bool take_dictionary(Literal& literal, NpyHeader& header) {
  std::array<bool, kKeys.size()> seen = {};
  if (!literal.take('{')) return false;
  while (!literal.take('}')) {
    const std::string_view before = literal.rest();
    const std::optional<std::string> key = literal.take_string();
    const auto known = std::find(kKeys.begin(), kKeys.end(), key.value_or(""));
    const auto place = static_cast<std::size_t>(known - kKeys.begin());
    if (known == kKeys.end() || seen[place]) {
      literal = Literal(before);
      return false;
    }
    seen[place] = true;
    if (!literal.take(':') || !take_value(literal, *known, header)) return false;
    if (literal.take(',')) continue;
    if (!literal.take('}')) return false;
    break;
  }
  return std::all_of(seen.begin(), seen.end(), [](bool one) { return one; });
}

struct Place {
  std::size_t begin = 0;
  std::size_t length = 0;
};

// The place of the dictionary: versions after the first store its length in four bytes instead of
// two.
Result<Place> place_of_dictionary(const RandomAccess& file, const std::string& name) {
  std::array<char, 12> bytes = {};
  const std::size_t size = std::min(bytes.size(), file.size());
  if (!file.read(0, size, bytes.data()) || !is_npy({bytes.data(), size})) {
    return header_fault(
        name, "an .npy file, which begins with \\x93NUMPY",
        size == 0 ? "an empty file" : quote({bytes.data(), std::min(size, kMagic.size())}));
  }
  const auto byte = [&bytes](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
  };
  const std::size_t version = byte(6);
  const std::size_t begin = version == 1 ? 10 : 12;
  if (size < begin) return header_fault(name, "a header", "the end of the file");
  if (version < 1 || version > 3) {
    return header_fault(name, "version 1, 2 or 3 of the format",
                        "version " + std::to_string(version) + "." + std::to_string(byte(7)));
  }
  std::size_t length = byte(8) | byte(9) << 8U;
  if (version > 1) length |= byte(10) << 16U | byte(11) << 24U;
  return Place{begin, length};
}

}  // namespace

bool is_npy(std::string_view beginning) { return beginning.starts_with(kMagic); }

std::string NpyHeader::shape_in_words() const {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
  }
  return text + (shape.size() == 1 ? ",)" : ")");
}

Result<NpyHeader> read_npy_header(const RandomAccess& file, const std::string& name) {
  const Result<Place> place = place_of_dictionary(file, name);
  if (!place) return tl::unexpected(place.error());
  const auto [begin, length] = *place;
  if (length > kLongestHeader) {
    return header_fault(name, "a header of at most " + std::to_string(kLongestHeader) + " bytes",
                        "one of " + std::to_string(length));
  }
  std::string text(length, ' ');
  if (!file.read(begin, length, text.data())) {
    return header_fault(name, "a header of " + std::to_string(length) + " bytes",
                        std::to_string(file.size() - begin));
  }
  Literal literal(text);
  NpyHeader header;
  if (!take_dictionary(literal, header) ||
      literal.rest().find_first_not_of(" \n") != std::string::npos) {
    return header_fault(
        name, "a header of NumPy such as {'descr': '<f8', 'fortran_order': False, 'shape': (4, 3)}",
        literal.rest().empty() ? "the end of the header" : quote(literal.rest()));
  }
  header.end = begin + length;
  return header;
}

}  // namespace circumspect::formats
