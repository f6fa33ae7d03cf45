// A file of words in text and numbers that may be binary: Gmsh's .msh, VTK's legacy files, and the
// arrays of VTK's XML files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// ---- Bytes ----
// The bytes of a binary file, read from the front; nothing beyond the end is ever touched.

enum class ByteOrder { kLittleEndian, kBigEndian };

class Bytes {
 public:
  explicit Bytes(std::string_view bytes, ByteOrder order) : rest_(bytes), order_(order) {}

  std::size_t left() const { return rest_.size(); }
  // False if there are not as many.
  bool skip(std::size_t count);
  // An unsigned integer of 1, 2, 4 or 8 bytes; none if there are not as many.
  std::optional<std::uint64_t> unsigned_integer(std::size_t size);

 private:
  std::string_view rest_;
  ByteOrder order_;
};

// The same bits as a number in two's complement.
std::int64_t as_signed(std::uint64_t bits, std::size_t size);

// The exact value of an IEEE number of 4 or 8 bytes; none if it is not finite.
std::optional<Rational> as_floating(std::uint64_t bits, std::size_t size);

// ---- Mixed text ----
// A file whose words are text and whose numbers may be binary: Gmsh's .msh, VTK's legacy files, the
// arrays of its XML files. Words and numbers follow one another, wherever lines end.

// How a binary number is stored; for text it says whether the number is an integer.
struct NumberType {
  enum class Kind { kSigned, kUnsigned, kFloating } kind = Kind::kSigned;
  std::size_t size = 0;  // in bytes: 1, 2, 4 or 8; a floating one has 4 or 8
};
inline constexpr NumberType kInt32{NumberType::Kind::kSigned, 4};
inline constexpr NumberType kUint64{NumberType::Kind::kUnsigned, 8};
inline constexpr NumberType kFloat64{NumberType::Kind::kFloating, 8};

class MixedText {
 public:
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

  // The next number; `what` names it in errors. A floating one must be finite; an integer, text or
  // binary, must fit 64 bits.
  Result<Rational> number(NumberType type, std::string_view what);
  Result<Vertex> integer(NumberType type, std::string_view what);
  Result<std::size_t> count(NumberType type, std::string_view what);
  // Read as text, even if numbers are binary.
  Result<std::size_t> count_in_text(std::string_view what);
  // Skips so many numbers without looking at them.
  Status skip_numbers(NumberType type, std::size_t count, std::string_view what);

  const std::string& name() const { return name_; }
  // The line of what was read last; 0 after binary numbers.
  std::size_t line() const { return was_binary_ ? 0 : word_line_; }
  // An error that names the place of what was read last: its line or, after binary numbers, its
  // byte and its section.
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const;
  // The same if the word that was read last is not what was expected.
  tl::unexpected<FormatError> fail_at_word(std::string expected) const;

 private:
  void skip_blanks();
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
};

}  // namespace circumspect::formats
