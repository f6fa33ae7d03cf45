// Reads the JSON schema from the events of a parser: object begins, key, number … Every event is
// compared with what the schema expects at this place, so that nothing else is ever stored.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/json_text.hpp"

namespace circumspect::formats {

// The interface is the one that nlohmann::json::sax_parse calls: true continues, false stops.
class JsonEvents {
 public:
  // Requires: the text, whose events these are, outlives this object.
  JsonEvents(JsonText& text, NumberReading reading) : text_(text), reading_(reading) {}

  bool null() { return mismatch("null"); }
  bool boolean(bool value) { return mismatch(value ? "true" : "false"); }
  bool number_integer(std::int64_t value) { return number(std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) { return number(std::to_string(value)); }
  bool number_float(double value, const std::string& text);
  bool string(const std::string& value);
  bool binary(const nlohmann::json::binary_t&) { return mismatch("binary data"); }
  bool start_object(std::size_t);
  bool key(const std::string& name);
  bool end_object();
  bool start_array(std::size_t);
  bool end_array();
  bool parse_error(std::size_t, const std::string& last_token,
                   const nlohmann::json::exception& error);

  // After the last event: what was read, or what is wrong with it.
  Result<JsonFile> finish();

 private:
  enum Key {
    kVersion,
    kDimension,
    kPoints,
    kWeights,
    kSimplices,
    kFaces,
    kFirstIndex,
    kComment,
    kKeys
  };
  static constexpr std::array<std::string_view, kKeys> kNames = {
      "circumspect", "dimension", "points",      "weights",
      "simplices",   "faces",     "first_index", "comment"};

  bool number(std::string_view text);
  bool integer(std::string_view text, Vertex& value);
  bool exact(std::string_view text, std::vector<Rational>& values);
  bool version(std::string_view text);
  bool dimension(std::string_view text);
  bool end_of_point();
  bool end_of_simplex();
  Status check_whole() const;
  Status check_faces() const;

  bool is_list_of_vertices() const { return key_ == kSimplices || key_ == kFaces; }
  bool is_list_of_lists() const { return key_ == kPoints || is_list_of_vertices(); }
  // The lists read so far. Requires: the key is kSimplices or kFaces.
  SimplexFile& cells() { return key_ == kFaces ? file_.faces : file_.simplices; }
  // What the schema expects at this place.
  std::string wanted() const;
  bool mismatch(const std::string& found) { return fail(wanted(), found); }
  bool fail(const std::string& expected, const std::string& found);

  JsonText& text_;
  NumberReading reading_;
  JsonFile file_;
  Point point_;  // being read, as the next one
  Simplex simplex_;
  std::optional<std::size_t> size_of_first_ = {};  // point
  FormatError error_;
  int depth_ = 0;                                // the open objects and arrays
  Key key_ = kKeys;                              // whose value is being read
  std::array<std::size_t, kKeys> line_of_ = {};  // 0: the key was not seen
};

}  // namespace circumspect::formats
