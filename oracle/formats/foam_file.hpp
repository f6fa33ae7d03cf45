// A file of OpenFOAM's: a header, and lists of numbers as text or binary.
//
//     FoamFile
//     {
//         format      ascii;                      or binary, with the numbers of this machine
//         class       faceList;
//         arch        "LSB;label=32;scalar=64";
//     }
//     2                                           how many, then these
//     (
//     3(0 1 2)
//     4(1 2 3 4)
//     )
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/indices.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/point_rows.hpp"
#include "oracle/formats/bytes/simplex_rows.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// Does a text begin as such a file does?
bool is_foam_file(std::string_view text);

class FoamFile {
 public:
  // Reads the header. Requires: the source outlives this object.
  static Result<FoamFile> open(const Source& source, NumberReading reading);

  // The list that the file holds.
  Status read_points(PointRows& to);
  Result<Indices> read_labels();
  Result<SimplexRows> read_faces();

 private:
  FoamFile(const Source& source, NumberReading reading) : source_(source), reading_(reading) {}

  Status read_header();
  // The next word: a name, a number, or one of ( ) { } ; alone. Comments are skipped.
  std::string_view word();
  void skip_blanks();
  Status expect(std::string_view mark, const std::string& where);
  Result<std::size_t> count(const std::string& what);
  Result<Vertex> integer(const std::string& what);
  // So many bytes of numbers in parentheses.
  Result<std::string_view> stored(std::size_t count, std::size_t size, const std::string& what);
  Result<Indices> read_label_list(const std::string& what);
  std::size_t line() const;
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const;
  tl::unexpected<FormatError> fail_at_word(std::string expected) const;

  const Source& source_;
  NumberReading reading_;
  std::size_t at_ = 0;
  std::string_view word_ = {};
  std::size_t word_at_ = 0;
  bool is_binary_ = false;
  bool is_compact_ = false;  // faces are two lists: where each begins, and all vertices
  ByteOrder order_ = ByteOrder::kLittleEndian;
  std::size_t label_size_ = 4;
  std::size_t scalar_size_ = 8;
};

}  // namespace circumspect::formats
