// A file whose words are text and whose numbers may be binary: Gmsh's .msh, VTK's legacy files, the
// arrays of its XML files. Words and numbers follow one another, wherever lines end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/binary.hpp"
#include "oracle/formats/bytes/indices.hpp"
#include "oracle/formats/bytes/plain_number.hpp"
#include "oracle/formats/bytes/point_rows.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// How a binary number is stored; for text it says whether the number is an integer.
struct NumberType {
  enum class Kind { kSigned, kUnsigned, kFloating } kind = Kind::kSigned;
  std::size_t size = 0;  // in bytes: 1, 2, 4 or 8; a floating one has 4 or 8
};
inline constexpr NumberType kInt32{NumberType::Kind::kSigned, 4};
inline constexpr NumberType kUint64{NumberType::Kind::kUnsigned, 8};
inline constexpr NumberType kFloat64{NumberType::Kind::kFloating, 8};

// What is read, for messages: "a vertex of " "cell" 3 of 8. It is put into words only if an error
// needs them. Requires: the texts outlive it.
struct Item {
  Item(std::string_view text) : what(text) {}
  Item(const char* text) : what(text) {}
  Item(const std::string& text) : what(text) {}
  Item(std::string_view text, std::string_view one, std::size_t at = 0, std::size_t of = 0)
      : what(text), noun(one), place(at), count(of) {}

  // "a vertex of cell 4 of 8"; without a count "a vertex of cell".
  std::string words() const;

  std::string_view what;
  std::string_view noun = {};
  std::size_t place = 0;  // from 0
  std::size_t count = 0;
};

class MixedText {
 public:
  // A whole file, whose byte order mark is skipped. Requires: the source outlives this object.
  MixedText(const Source& source, NumberReading reading);
  // `first_line`: the line of the file on which the text begins. Requires: the text outlives this
  // object.
  MixedText(std::string name, std::string_view text, NumberReading reading,
            std::size_t first_line = 1);

  // From here on numbers are binary, or text again. Words are always text.
  void set_binary(std::optional<ByteOrder> order) { binary_ = order; }
  bool is_binary() const { return binary_.has_value(); }

  // The word that was read last begins a section: errors after binary numbers name the section, and
  // the line on which it begins. (Lines are counted as editors count them, whatever bytes are
  // between line ends.)
  void begin_section();

  // The next word; empty at the end. Blanks and ends of lines are skipped.
  std::string_view word();
  // The next word, which remains to be read.
  std::string_view peek();
  // Skips and returns the rest of the current line.
  std::string_view rest_of_line();
  // Skips everything up to the end of this text, at its first occurrence at the beginning of a line
  // or, if that is not required, anywhere; false if there is none.
  bool skip_behind(std::string_view text, bool begins_line);
  // Skips so many bytes; false if there are fewer.
  bool skip_bytes(std::size_t count);
  // Are no bytes left or, if numbers are text, only blanks?
  bool is_at_end();
  std::size_t bytes_left() const { return text_.size() - at_; }

  // The next number; `item` names it in errors. A floating one must be finite; an integer, text or
  // binary, must fit 64 bits.
  Result<Rational> number(NumberType type, const Item& item);
  Result<Vertex> integer(NumberType type, const Item& item);
  Result<std::size_t> count(NumberType type, const Item& item);
  // Read as text, even if numbers are binary.
  Result<std::size_t> count_in_text(const Item& item);
  // Skips so many numbers without looking at them.
  Status skip_numbers(NumberType type, std::size_t count, const Item& item);

  // The same for many at once. The first point, or the first integer, is `item`; the place of those
  // that follow goes up. Requires of points: they have a number of coordinates.
  Status points(NumberType type, std::size_t count, Item item, PointRows& to);
  Status integers(NumberType type, std::size_t count, const Item& item, Indices& to);

  // The next integer in a loop; after the first error all are 0, and failure() is that error. The
  // common case is in the header, because it is what reading takes.
  Vertex take(NumberType type, const Item& item) {
    if (!binary_) {
      skip_blanks();
      std::int64_t value = 0;
      const char* const begin = text_.data() + at_;
      const char* const end = text_.data() + text_.size();
      const char* const stop = read_plain_integer(begin, end, value);
      if (stop != nullptr && ends_word(stop, end)) {
        took(static_cast<std::size_t>(stop - begin));
        return value;
      }
    }
    return take_slowly(type, item);
  }
  // Has one that was taken failed? Requires of failure(): yes.
  bool has_failed() const { return failure_.has_value(); }
  tl::unexpected<FormatError> failure() const { return tl::unexpected(*failure_); }

  const std::string& name() const { return name_; }
  // The line of what was read last; 0 after binary numbers.
  std::size_t line() const { return was_binary_ ? 0 : word_line_; }
  // An error that names the place of what was read last: its line or, after binary numbers, its
  // byte and its section.
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const;
  // The same if the word that was read last is not what was expected.
  tl::unexpected<FormatError> fail_at_word(std::string expected) const;

 private:
  static bool ends_word(const char* at, const char* end) { return at == end || is_space(*at); }
  void skip_blanks() {
    while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
  }
  // A word of so many bytes has been read.
  void took(std::size_t size) {
    word_ = text_.substr(at_, size);
    word_line_ = line_;
    read_at_ = at_;
    at_ += size;
  }
  Vertex take_slowly(NumberType type, const Item& item);
  bool read_plain(double& number);
  Status text_points(NumberType type, std::size_t count, Item item, PointRows& to);
  Status binary_points(NumberType type, std::size_t count, Item item, PointRows& to);
  // The bytes of a binary number; none, with all bytes read, if there are not as many.
  std::optional<std::uint64_t> bits(std::size_t size);

  std::string name_;
  std::string_view text_;
  NumberReading reading_;
  std::optional<ByteOrder> binary_;
  std::size_t at_ = 0;
  std::size_t line_;
  std::string_view word_;       // read last
  std::size_t word_line_;       // its line
  std::size_t read_at_ = 0;     // where the item that was read last begins
  std::string section_;         // its first word; empty before any
  std::size_t section_at_ = 0;  // where that word is
  std::size_t first_line_;
  bool was_binary_ = false;  // lines can no longer be counted
  std::optional<FormatError> failure_;
};

}  // namespace circumspect::formats
