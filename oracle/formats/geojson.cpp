#include "oracle/formats/geojson.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/json_text.hpp"
#include "oracle/formats/rings.hpp"

namespace circumspect::formats {
namespace {

// The keys of objects that hold others.
constexpr std::string_view kMemberKeys[] = {"features", "geometries", "geometry"};
constexpr std::string_view kHolders[] = {"FeatureCollection", "GeometryCollection", "Feature"};

template <std::size_t n>
bool is_among(const std::string_view (&words)[n], std::string_view word) {
  return std::find(words, words + n, word) != words + n;
}

// The interface is the one that nlohmann::json::sax_parse calls: true continues, false stops.
class GeoJsonEvents {
 public:
  GeoJsonEvents(JsonText& text, NumberReading reading)
      : text_(text), reading_(reading), rings_(text.file()) {}

  bool null() { return scalar("null", next_ == Value::kMembers); }
  bool boolean(bool value) { return scalar(value ? "true" : "false"); }
  bool number_integer(std::int64_t value) { return number(std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) { return number(std::to_string(value)); }
  bool number_float(double, const std::string& text) { return number(as_written(text)); }
  bool string(const std::string& value);
  bool binary(const nlohmann::json::binary_t&) { return scalar("binary data"); }
  bool start_object(std::size_t);
  bool key(const std::string& name);
  bool end_object();
  bool start_array(std::size_t);
  bool end_array();
  bool parse_error(std::size_t, const std::string& last_token,
                   const nlohmann::json::exception& error) {
    error_ = text_.fault(last_token, error);
    return false;
  }

  Result<DomainFile> finish() {
    if (error_) return tl::unexpected(*error_);
    return rings_.finish();
  }

 private:
  // What the value is that comes next.
  enum class Value { kMembers, kType, kCoordinates, kOther };
  struct Object {
    std::string type = {};
    std::optional<Coordinates> coordinates = {};
    bool has_members = false;
  };

  bool fail(std::string expected, std::string found) {
    error_ = FormatError{text_.file(), text_.line(), std::move(expected), std::move(found)};
    return false;
  }
  bool taken(const Status& status) {
    if (!status) error_ = status.error();
    return status.has_value();
  }
  std::string wanted() const;
  bool is_in_coordinates() const { return !open_.empty(); }
  // A value that may stand only where it is skipped, or where `is_fine`.
  bool scalar(const std::string& found, bool is_fine = false) {
    return skipped_ > 0 || (next_ == Value::kOther && !is_in_coordinates()) || is_fine ||
           fail(wanted(), found);
  }
  bool number(std::string_view text);
  bool take_alone(const Coordinates& list);

  JsonText& text_;
  NumberReading reading_;
  Rings rings_;
  std::optional<FormatError> error_ = {};
  Value next_ = Value::kMembers;
  std::size_t skipped_ = 0;        // the open objects and arrays of a value that is skipped
  std::vector<Object> objects_;    // that are open
  std::vector<Coordinates> open_;  // lists of coordinates, each in the one before
};

std::string GeoJsonEvents::wanted() const {
  if (is_in_coordinates()) {
    const Coordinates& list = open_.back();
    if (!list.position.empty()) return "a coordinate";
    return list.parts.empty() ? "a coordinate or a list" : "a list";
  }
  if (next_ == Value::kType) return "the name of a type";
  if (next_ == Value::kCoordinates) return "a list of coordinates";
  return "an object of GeoJSON";
}

bool GeoJsonEvents::number(std::string_view text) {
  if (!is_in_coordinates()) return scalar(quote(text));
  Coordinates& list = open_.back();
  if (!list.parts.empty()) return fail(wanted(), quote(text));
  tl::expected<Rational, NumberError> value = parse_number(text, reading_);
  if (!value) return fail(value.error().expected, quote(text));
  if (list.position.size() == 4) return fail("a position of 2 or 3 numbers", "more than 4");
  list.position.push_back(std::move(*value));
  return true;
}

bool GeoJsonEvents::string(const std::string& value) {
  if (skipped_ == 0 && next_ == Value::kType && !is_in_coordinates()) {
    objects_.back().type = value;
    return true;
  }
  return scalar("the string " + quote(value));
}

bool GeoJsonEvents::start_object(std::size_t) {
  if (skipped_ > 0 || (next_ == Value::kOther && !is_in_coordinates())) {
    ++skipped_;
    return true;
  }
  if (is_in_coordinates() || next_ != Value::kMembers) return fail(wanted(), "an object");
  objects_.emplace_back();
  return true;
}

bool GeoJsonEvents::key(const std::string& name) {
  if (skipped_ > 0) return true;
  Object& object = objects_.back();
  if (name == "type") {
    if (!object.type.empty()) return fail("every key once", quote(name) + " again");
    next_ = Value::kType;
  } else if (name == "coordinates") {
    if (object.coordinates) return fail("every key once", quote(name) + " again");
    next_ = Value::kCoordinates;
  } else if (is_among(kMemberKeys, name)) {
    object.has_members = true;
    next_ = Value::kMembers;
  } else {
    next_ = Value::kOther;
  }
  return true;
}

bool GeoJsonEvents::end_object() {
  if (skipped_ > 0) {
    --skipped_;
    return true;
  }
  const Object object = std::move(objects_.back());
  objects_.pop_back();
  next_ = Value::kMembers;  // in a list of members; after a single one a key comes
  const auto* const known =
      std::find_if(std::begin(kGeometries), std::end(kGeometries),
                   [&](const Geometry& geometry) { return geometry.name == object.type; });
  if (known != std::end(kGeometries)) {
    if (!object.coordinates) return fail("the key \"coordinates\"", "an object without it");
    return taken(rings_.add(*known, *object.coordinates));
  }
  if (is_among(kHolders, object.type)) return true;
  if (object.type.empty()) return fail("the key \"type\"", "an object without it");
  std::string types;
  for (const Geometry& geometry : kGeometries) types += std::string(geometry.name) + ", ";
  return fail("one of the types " + types + "Feature, FeatureCollection, GeometryCollection",
              quote(object.type));
}

bool GeoJsonEvents::start_array(std::size_t) {
  if (skipped_ > 0 || (next_ == Value::kOther && !is_in_coordinates())) {
    ++skipped_;
    return true;
  }
  const bool is_alone = objects_.empty();
  if (next_ == Value::kMembers && !is_alone && !is_in_coordinates()) return true;
  if (next_ != Value::kCoordinates && !is_alone) return fail(wanted(), "an array");
  if (is_in_coordinates() && !open_.back().position.empty()) return fail(wanted(), "a list");
  if (open_.size() == kDeepestCoordinates) {
    return fail("at most " + std::to_string(kDeepestCoordinates) + " lists in one another",
                "one more");
  }
  open_.push_back({text_.line()});
  return true;
}

bool GeoJsonEvents::end_array() {
  if (skipped_ > 0) {
    --skipped_;
    return true;
  }
  if (!is_in_coordinates()) return true;
  Coordinates list = std::move(open_.back());
  open_.pop_back();
  if (is_in_coordinates()) {
    open_.back().parts.push_back(std::move(list));
    return true;
  }
  if (objects_.empty()) return take_alone(list);
  objects_.back().coordinates = std::move(list);
  return true;
}

// Coordinates without a type: their depth tells it.
bool GeoJsonEvents::take_alone(const Coordinates& list) {
  int depth = 1;
  for (const Coordinates* at = &list; !at->parts.empty(); at = &at->parts.front()) ++depth;
  if (!list.parts.empty() && depth == 2) return taken(rings_.add(kRingAlone, list));
  return taken(rings_.add(depth == 4 ? kManyPolygons : kOnePolygon, list));
}

}  // namespace

Result<DomainFile> read_geojson(const Source& source, NumberReading reading) {
  JsonText text(source);
  GeoJsonEvents events(text, reading);
  text.parse(events);
  return events.finish();
}

bool is_geojson(std::string_view text) {
  text = from_first_word(text);
  if (text.starts_with('[')) return true;
  return text.starts_with('{') && text.find("\"circumspect\"") == std::string_view::npos &&
         text.find("\"type\"") != std::string_view::npos;
}

}  // namespace circumspect::formats
