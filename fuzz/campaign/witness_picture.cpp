#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "fuzz/campaign/finding_folder.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/exact/number_text.hpp"

namespace circumspect::campaign {
namespace {

using report::Json;

constexpr double kSide = 300;  // of the square that contains everything
constexpr double kMargin = 30;
constexpr std::size_t kMostPlaces = 100;

// Where a point is drawn, before scaling. Space is drawn in an oblique projection: its third axis
// goes up and to the right. Nothing if it does not have two or three coordinates, or has one that
// is not a number.
std::optional<Point> projected(const Json& numbers) {
  Point place;
  for (const Json& number : numbers) {
    if (!number.is_string()) return std::nullopt;
    const auto read = read_number(number.get<std::string>(), NumberReading::kDecimal);
    if (!read) return std::nullopt;
    place.push_back(*read);
  }
  if (place.size() == 3) {
    place[0] += place[2] * Rational(2, 5);
    place[1] += place[2] * Rational(1, 4);
    place.pop_back();
  }
  if (place.size() != 2) return std::nullopt;
  return place;
}

std::string as_xml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '&'   ? std::string("&amp;")
               : c == '<' ? std::string("&lt;")
               : c == '>' ? std::string("&gt;")
                          : std::string(1, c);
  }
  return escaped;
}

// A picture under construction: first the places, by their labels, then what is drawn between them.
class Canvas {
 public:
  void add(const std::string& label, const Json& numbers) {
    const std::optional<Point> place = projected(numbers);
    if (place) exact_[label] = *place;
  }

  // False: there is nothing to see, or too much.
  bool scale() {
    if (exact_.size() < 3 || exact_.size() > kMostPlaces) return false;
    Point low = exact_.begin()->second;
    Point high = low;
    for (const auto& [label, place] : exact_) {
      for (const std::size_t axis : {0U, 1U}) {
        low[axis] = std::min(low[axis], place[axis]);
        high[axis] = std::max(high[axis], place[axis]);
      }
    }
    const Point size = high - low;
    const Rational extent = std::max(size[0], size[1]);
    if (sign(extent) == 0) return false;
    for (const auto& [label, place] : exact_) {
      // Relative to the middle, in units of the extent: at most a half, and rounded only now.
      const auto from_middle = [&, &at = place](std::size_t axis) {
        const Rational offset = (at[axis] - low[axis] - size[axis] / 2) / extent;
        return kSide * generators::nearest_double(offset);
      };
      places_[label] = {kMargin + kSide / 2 + from_middle(0), kMargin + kSide / 2 - from_middle(1)};
    }
    return true;
  }

  // Draws nothing if one of the labels has no place.
  void outline(const std::vector<std::string>& corners, const std::string& style) {
    std::string path;
    for (const std::string& label : corners) {
      if (places_.count(label) == 0) return;
      path += fmt::format("{}{} ", path.empty() ? "M" : "L", at(places_[label]));
    }
    if (!path.empty()) drawn_ += "<path d=\"" + path + "Z\" " + style + "/>\n";
  }

  void ring(const std::string& label) {
    if (places_.count(label) == 0) return;
    drawn_ += fmt::format(
        "<g transform=\"translate({})\"><circle r=\"8\" fill=\"none\" stroke=\"#c1440e\"/></g>\n",
        at(places_[label]));
  }

  // Adds a dot for each place. Labels that would hide each other are written one after the other.
  std::string svg() const {
    std::vector<std::pair<Place, std::string>> texts;
    std::string dots;
    for (const auto& [label, place] : places_) {
      dots += fmt::format("<g transform=\"translate({})\"><circle r=\"3\"/></g>\n", at(place));
      const auto hidden = std::find_if(texts.begin(), texts.end(), [&, &mine = place](auto& text) {
        return std::abs(text.first[0] - mine[0]) < 20 && std::abs(text.first[1] - mine[1]) < 12;
      });
      if (hidden == texts.end()) {
        texts.emplace_back(place, label);
      } else {
        hidden->second += ", " + label;
      }
    }
    std::string written;
    for (const auto& [place, text] : texts) {
      written +=
          fmt::format("<g transform=\"translate({})\"><text x=\"5\" y=\"-5\">{}</text></g>\n",
                      at(place), as_xml(text));
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n{2}{3}{4}</svg>\n",
        kSide + 4 * kMargin, kSide + 2 * kMargin, drawn_, dots, written);
  }

 private:
  using Place = std::array<double, 2>;
  static std::string at(const Place& place) {
    return fmt::format("{:.2f} {:.2f}", place[0], place[1]);
  }

  std::map<std::string, Point> exact_;
  std::map<std::string, Place> places_;
  std::string drawn_;
};

std::vector<std::string> labels(const Json& vertices) {
  std::vector<std::string> found;
  for (const Json& v : vertices) found.push_back(v.dump());
  return found;
}

// A tetrahedron is drawn as its four triangles.
void draw_simplices(Canvas& canvas, const Json& simplices) {
  constexpr std::array<const char*, 4> kColours = {"#1b6ca8", "#c1440e", "#2e7d32", "#7b1fa2"};
  std::size_t drawn = 0;
  for (const Json& simplex : simplices) {
    const std::string style = fmt::format("fill=\"{0}\" fill-opacity=\"0.15\" stroke=\"{0}\"",
                                          kColours[drawn++ % kColours.size()]);
    const std::vector<std::string> corners = labels(simplex);
    if (corners.size() < 4) canvas.outline(corners, style);
    for (std::size_t left_out = 0; left_out < corners.size() && corners.size() > 3; ++left_out) {
      std::vector<std::string> triangle = corners;
      triangle.erase(triangle.begin() + static_cast<std::ptrdiff_t>(left_out));
      canvas.outline(triangle, style);
    }
  }
}

// The cells of the domain whose coordinates a witness has: an object for each kind, from indices to
// points.
std::map<std::string, Json> domain_points(const Json& witness) {
  std::map<std::string, Json> found;
  const Json domain = witness.value("domain", Json::object());
  for (const auto& [kind, vertices] : domain.items()) {
    if (!vertices.is_object()) continue;
    for (const auto& [index, numbers] : vertices.items()) found["domain " + index] = numbers;
  }
  return found;
}

}  // namespace

std::string witness_picture(const Json& verdict) {
  if (!verdict.is_object() || verdict.value("violations", Json::array()).empty()) return "";
  const Json& witness = verdict["violations"][0];
  Canvas canvas;
  const Json coordinates = witness.value("coordinates", Json::object());
  for (const auto& [index, numbers] : coordinates.items()) canvas.add(index, numbers);
  if (witness.contains("point")) canvas.add("point", witness["point"]);
  const std::map<std::string, Json> of_domain = domain_points(witness);
  std::vector<std::string> cell;
  for (const auto& [label, numbers] : of_domain) {
    canvas.add(label, numbers);
    cell.push_back(label);
  }
  if (!canvas.scale()) return "";
  draw_simplices(canvas, witness.value("simplices", Json::array()));
  if (witness.contains("face")) {
    canvas.outline(labels(witness["face"]), "fill=\"none\" stroke=\"black\" stroke-width=\"3\"");
  }
  canvas.outline(cell,
                 "fill=\"none\" stroke=\"black\" stroke-width=\"2\" stroke-dasharray=\"6 4\"");
  for (const std::string& label : labels(witness.value("vertices", Json::array()))) {
    canvas.ring(label);
  }
  return canvas.svg();
}

}  // namespace circumspect::campaign
