#include "oracle/formats/json.hpp"

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/json_events.hpp"
#include "oracle/formats/json_text.hpp"

namespace circumspect::formats {
namespace {

std::string number_or_string(const Rational& value) {
  const std::string text = to_text_of_double_or_fraction(value);
  return text.find('/') == std::string::npos ? text : "\"" + text + "\"";
}

std::string comma_separated(const std::vector<Rational>& values) {
  std::string text;
  for (const Rational& x : values) text += (text.empty() ? "" : ", ") + number_or_string(x);
  return text;
}

std::string comma_separated(const std::vector<Vertex>& values) {
  std::string text;
  for (const Vertex v : values) text += (text.empty() ? "" : ", ") + std::to_string(v);
  return text;
}

// A key and its array of arrays, one a line.
template <class Rows>
void write_rows(std::ostream& out, const std::string& key, const Rows& rows) {
  out << ",\n\"" + key + "\": [";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out << (i == 0 ? "\n[" : ",\n[") + comma_separated(rows[i]) + "]";
  }
  out << "]";
}

}  // namespace

Result<JsonFile> read_json(const Source& source, NumberReading reading) {
  JsonText text(source);
  JsonEvents events(text, reading);
  text.parse(events);
  return events.finish();
}

void write_json(std::ostream& out, const JsonFile& file) {
  out << "{\"circumspect\": " + std::to_string(kJsonSchemaVersion) +
             ", \"dimension\": " + std::to_string(file.points.dimension);
  if (file.points.first_index != 0) {
    out << ", \"first_index\": " + std::to_string(file.points.first_index);
  }
  write_rows(out, "points", file.points.points);
  if (!file.weights.empty()) out << ",\n\"weights\": [" + comma_separated(file.weights) + "]";
  if (file.has_simplices) write_rows(out, "simplices", file.simplices.simplices);
  if (!file.faces.simplices.empty()) write_rows(out, "faces", file.faces.simplices);
  out << "}\n";
}

}  // namespace circumspect::formats
