// Polygons as rings, in GeoJSON and in WKT: what is read, what is refused, and the messages.
#include <doctest/doctest.h>

#include "oracle/formats/format.hpp"
#include "oracle/formats/geojson.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/wkt.hpp"

namespace circumspect::formats {

namespace {

using VertexLists = std::vector<std::vector<Vertex>>;

// Two squares with an edge in common; the first has a hole.
const std::string kWkt =
    "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2)),\n ((4 0, 8 0, 8 4, 4 4)))\n";
const std::string kGeoJson =
    "{\"type\": \"FeatureCollection\", \"features\": [\n{\"type\": \"Feature\", \"properties\": "
    "{\"type\": [1, {}], \"a\": null}, \"geometry\":\n{\"coordinates\": [[[[0, 0], [4, 0], [4, 4], "
    "[0, 4], [0, 0]],\n[[1, 1], [1, 2], [2, 2]]],\n[[[4, 0], [8, 0], [8, 4], [4, 4]]]], \"type\": "
    "\"MultiPolygon\"}}, {\"type\": \"Feature\", \"geometry\": null}]}";

std::string of_wkt(const std::string& text) { return error_of(read_wkt(named(text), kDouble)); }
std::string of_geojson(const std::string& text) {
  return error_of(read_geojson(named(text), kDouble));
}

}  // namespace

TEST_CASE("rings: both formats name each vertex once, and know the line of each segment") {
  for (const bool is_json : {false, true}) {
    const auto file =
        is_json ? read_geojson(named(kGeoJson), kDouble) : read_wkt(named(kWkt), kDouble);
    REQUIRE(file);
    CHECK(file->dimension == 2);
    CHECK(
        file->input.points ==
        std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}, {8, 0}, {8, 4}});
    REQUIRE(file->faces.size() == 2);
    CHECK(file->faces_are_rings);
    CHECK(file->faces[0].lines == VertexLists{{0, 1, 2, 3}, {4, 5, 6}});
    CHECK(file->faces[1].lines == VertexLists{{1, 7, 8, 2}});
    // As they are turned, the common edge twice.
    CHECK(file->input.segments == VertexLists{{0, 1},
                                              {1, 2},
                                              {2, 3},
                                              {3, 0},
                                              {4, 5},
                                              {5, 6},
                                              {6, 4},
                                              {1, 7},
                                              {7, 8},
                                              {8, 2},
                                              {2, 1}});
    const std::vector<std::size_t> of_json{3, 3, 3, 3, 4, 4, 4, 5, 5, 5, 5};
    const std::vector<std::size_t> of_text{1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2};
    CHECK(file->segment_lines == (is_json ? of_json : of_text));
  }
}

TEST_CASE("rings: numbers are doubles or exactly what is written") {
  const std::string json = "[[0.1, 0], [1, 0], [0, 2.50e-1]]";
  CHECK(read_geojson(named(json), kDouble)->input.points[0][0] == exact_value(0.1));
  CHECK(read_geojson(named(json), NumberReading::kDecimal)->input.points[0][0] == Rational(1, 10));
  const std::string wkt = "POLYGON ((0.1 0, 1 1/3, 0 1))";
  const auto exact = read_wkt(named(wkt), NumberReading::kDecimal);
  CHECK(exact->input.points[0][0] == Rational(1, 10));
  CHECK(exact->input.points[1][1] == Rational(1, 3));
}

TEST_CASE("rings: lines and points, in collections, with heights and measures") {
  const auto wkt =
      read_wkt(named("SRID=4326;GeometryCollection (linestring Z (0 0 5, 1 0 5, 1 1 5), "
                     "POINT ZM (3 3 5 9), MULTIPOINTZ (4 4 5, (6 6 5)), GEOMETRYCOLLECTION "
                     "EMPTY) ; TRIANGLE Z ((0 0 5, 1 0 5, 1 1 5, 0 0 5))"),
               kDouble);
  REQUIRE(wkt);
  CHECK(wkt->input.points == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {3, 3}, {4, 4}, {6, 6}});
  CHECK(wkt->input.segments == VertexLists{{0, 1}, {1, 2}, {2, 0}, {0, 1}, {1, 2}});
  CHECK(wkt->notes ==
        std::vector<std::string>{"f: the third coordinate, 5 for all points, was left out"});
  const auto json = read_geojson(
      named("{\"type\": \"GeometryCollection\", \"geometries\": [{\"type\": \"MultiLineString\", "
            "\"coordinates\": [[[0, 0], [1, 0]], []]}, {\"type\": \"Point\", \"coordinates\": [2, "
            "3]}, {\"type\": \"Polygon\", \"coordinates\": []}]}"),
      kDouble);
  REQUIRE(json);
  CHECK(json->input.points == std::vector<Point>{{0, 0}, {1, 0}, {2, 3}});
  CHECK(json->faces.empty());
}

TEST_CASE("rings: a collection has all of its features") {
  const std::string feature =
      "{\"type\": \"Feature\", \"geometry\": {\"type\": \"Point\", \"coordinates\": ";
  const auto json = read_geojson(named("{\"type\": \"FeatureCollection\", \"features\": [" +
                                       feature + "[0, 1]}}, " + feature + "[2, 3]}}]}"),
                                 kDouble);
  REQUIRE_MESSAGE(json, error_of(json));
  CHECK(json->input.points == std::vector<Point>{{0, 1}, {2, 3}});
}

TEST_CASE("rings: polygons in space have one ring") {
  const auto tin = read_wkt(
      named("TIN Z (((0 0 0, 1 0 0, 0 1 1, 0 0 0)), ((1 0 0, 1 1 2, 0 1 1, 1 0 0)))"), kDouble);
  REQUIRE(tin);
  CHECK(tin->dimension == 3);
  CHECK(tin->input.points.size() == 4);
  REQUIRE(tin->input.polygons.size() == 2);
  CHECK(tin->input.polygons[1].lines == VertexLists{{1, 3, 2}});
  CHECK(of_wkt("POLYGON Z ((0 0 0, 9 0 0, 0 9 1),\n(1 1 0, 2 1 0, 1 2 0))") ==
        "f:2: expected polygons of one ring where the third coordinate differs (a .poly file names "
        "holes of polygons in space), found 2 rings");
}

TEST_CASE("rings: faults of GeoJSON and their lines") {
  CHECK(of_geojson("{}") == "f:1: expected the key \"type\", found an object without it");
  CHECK(of_geojson("{\"type\": \"Polygon\"}") ==
        "f:1: expected the key \"coordinates\", found an object without it");
  CHECK(of_geojson("{\"type\":\n\"Topology\"}") ==
        "f:2: expected one of the types Point, MultiPoint, LineString, MultiLineString, Polygon, "
        "MultiPolygon, Feature, FeatureCollection, GeometryCollection, found \"Topology\"");
  CHECK(of_geojson("[]") == "f: expected polygons, lines or points, found none");
  CHECK(of_geojson("null") == "f: expected polygons, lines or points, found none");
  CHECK(of_geojson("7") == "f:1: expected an object of GeoJSON, found \"7\"");
  CHECK(of_geojson("{\"features\": [7]}") == "f:1: expected an object of GeoJSON, found \"7\"");
  CHECK(of_geojson("{\"type\": \"Point\", \"type\": \"Point\"}") ==
        "f:1: expected every key once, found \"type\" again");
  CHECK(of_geojson("{\"type\": \"Point\", \"coordinates\": 1}") ==
        "f:1: expected a list of coordinates, found \"1\"");
  CHECK(of_geojson("{\"type\": {}}") == "f:1: expected the name of a type, found an object");
  CHECK(of_geojson("[[[0, 0],\n[1, \"0\"]]]") ==
        "f:2: expected a coordinate, found the string \"0\"");
  CHECK(of_geojson("[[[0, 0], [1e400, 0], [0, 1]]]") ==
        "f:1: expected a number within the range of double, found \"1e400\"");
  CHECK(of_geojson("[[[0, 0], 1]]") == "f:1: expected a list, found \"1\"");
  CHECK(of_geojson("[[0, [0]]]") == "f:1: expected a coordinate, found a list");
  CHECK(of_geojson("[[[[[0, 0]]]]]") ==
        "f:1: expected at most 4 lists in one another, found one more");
  CHECK(of_geojson("[[[0, 0], [1, 0], [0, 1, 2]]]") ==
        "f:1: expected 2 coordinates, as the first position has, found 3");
  CHECK(of_geojson("[[[0, 0], [1, 0],\n[0, 0]]]") ==
        "f:1: expected a ring of at least 3 positions, found 2 positions");
  CHECK(of_geojson("{\"type\": \"Polygon\", \"coordinates\": [[0, 0], [1, 0], [0, 1]]}") ==
        "f:1: expected a list of positions, found a position");
  CHECK(of_geojson("{\"type\": \"MultiPolygon\",\n\"coordinates\": [[0, 0]]}") ==
        "f:2: expected a list of lines or rings, each a list of positions, found a position");
  CHECK(of_geojson("[[[0, 0], [1, 0], [0") ==
        "f:1: expected the rest of the JSON text, found the end of the file");
}

TEST_CASE("rings: faults of WKT and their lines") {
  CHECK(of_wkt("") == "f: expected polygons, lines or points, found none");
  CHECK(of_wkt("POLYGON EMPTY") == "f: expected polygons, lines or points, found none");
  CHECK(of_wkt("POLYGON ((0 0, 1 0, 0 1)") ==
        "f:1: expected \",\" or \")\", found the end of the file");
  CHECK(of_wkt("POLYGON\n(0 0, 1 0, 0 1)") == "f:2: expected \"(\" or EMPTY, found \"0\"");
  CHECK(of_wkt("\nCURVEPOLYGON ((0 0))") ==
        "f:2: expected a geometry of straight lines, such as POLYGON or MULTIPOLYGON, found "
        "\"CURVEPOLYGON\"");
  CHECK(of_wkt("POLYGON ((0 0, 1\nx, 0 1))").starts_with("f:2: expected a finite number"));
  CHECK(of_wkt("POLYGON ((0 0, 1, 0 1))") ==
        "f:1: expected a position, which is a list of 2 or 3 numbers, found 1 numbers");
  CHECK(of_wkt("POLYGON Z ((0 0, 1 0 0, 0 1 0))") ==
        "f:1: expected 3 coordinates of a position, found \",\"");
  CHECK(of_wkt("POINT (0 0 0 0 0)") ==
        "f:1: expected the end of a position of 4 numbers, found \"0\"");
  CHECK(of_wkt("GEOMETRYCOLLECTION (POINT (0 0)") ==
        "f:1: expected \")\" after a collection, found the end of the file");
  CHECK(of_wkt("POINT (0 0))").ends_with("found \")\""));
}

TEST_CASE("rings: the content tells them from other formats") {
  const auto ending = [](const std::string& name, const std::string& text) {
    const Format* const format = format_of(name, {"f", text});
    return format == nullptr ? "none" : std::string(format->endings.front());
  };
  CHECK(ending(".json", kGeoJson) == ".geojson");
  CHECK(ending(".json", "{\"circumspect\": 1, \"comment\": \"type\"}") == ".json");
  CHECK(ending(".json", "[[0, 0]]") == ".json");
  const auto told = [](const std::string& text) {
    const Format* const format = told_format({"f", text}, &Format::has_domain);
    return format == nullptr ? "none" : std::string(format->endings.front());
  };
  CHECK(told(kWkt) == ".wkt");
  CHECK(told("srid=1; polygon z ((0 0 0))") == ".wkt");
  CHECK(told("pointz (0 0 0)") == ".wkt");
  CHECK(told("POINTZ (0 0 0)") == ".wkt");
  CHECK(told("POINTM (0 0 0)") == ".wkt");
  CHECK(told("POINTX (0 0 0)") == "none");
  CHECK(told(kGeoJson) == ".geojson");
  CHECK(told("[[[0, 0]]]") == ".geojson");
  CHECK(told("POINTS 3") == "none");
  CHECK(told("Polygon") == "none");
}

}  // namespace circumspect::formats
