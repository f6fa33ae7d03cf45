// XDMF, with its numbers as text and in HDF5: what is read, what is refused, and the messages.
#include "oracle/formats/xdmf.hpp"

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/hdf5.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

const std::string kXdmfCorpus = CIRCUMSPECT_CORPUS_DIR "/xdmf/";

Result<ElementFile> xdmf(const std::string& text) { return read_xdmf(named(text), kDouble); }
std::string xdmf_error(const std::string& text) { return error_of(xdmf(text)); }

std::string item(const std::string& dimensions, const std::string& numbers,
                 const std::string& format = "XML") {
  return "<DataItem Dimensions=\"" + dimensions + "\" NumberType=\"Int\" Format=\"" + format +
         "\">" + numbers + "</DataItem>";
}

std::string grid(const std::string& points, const std::string& type, const std::string& cells) {
  return "<Grid>\n<Geometry GeometryType=\"XYZ\">" + points +
         "</Geometry>\n<Topology TopologyType=\"" + type + "\">" + cells + "</Topology></Grid>";
}

std::string document_of(const std::string& grids) {
  return "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain>" + grids + "</Domain></Xdmf>";
}

const std::string kTextPoints =
    "<DataItem Dimensions=\"4 3\" Precision=\"8\">0 0 0\n1 0 0 0 1 0\n0 0 0.1</DataItem>";
const std::vector<Point> kSamplePoints = {
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, exact_value(1.0 / 3)}, {1, 1, 1}};

Result<Hdf5Array> sample(const std::string& name, const std::string& path) {
  const auto source = load(kXdmfCorpus + name);
  REQUIRE(source);
  return read_hdf5(*source, path);
}

}  // namespace

TEST_CASE("xdmf: a collection may say that it has no elements of its own") {
  const std::string none = "<Geometry Type=\"None\"/><Topology Type=\"NoTopology\"/>";
  const auto inner =
      xdmf(document_of("<Grid GridType=\"Collection\">" + none +
                       grid(kTextPoints, "Tetrahedron", item("1 4", "0 1 2 3")) + "</Grid>"));
  REQUIRE_MESSAGE(inner, error_of(inner));
  CHECK(inner->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(inner->notes.empty());
}

TEST_CASE("xdmf: text, elements of one type and mixed ones, several grids") {
  const auto one = xdmf(document_of(grid(kTextPoints, "Tetrahedron", item("1 4", "0 1 2 3"))));
  REQUIRE_MESSAGE(one, error_of(one));
  CHECK(one->points.points[3] == Point{0, 0, exact_value(0.1)});
  CHECK(one->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(one->notes.empty());
  const auto mixed = xdmf(
      document_of(grid(kTextPoints, "MIXED", item("17", "6 0 1 2 3\n4 0 1 2\n1 1 3\n2 3 0 1 2")) +
                  grid(kTextPoints, "Triangle", item("1 3", "0 1 2"))));
  REQUIRE_MESSAGE(mixed, error_of(mixed));
  CHECK(mixed->tetrahedra.simplices.size() == 1);
  CHECK(mixed->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(mixed->edges.simplices == std::vector<Simplex>{{0, 1}, {1, 2}});
  CHECK(mixed->notes == std::vector<std::string>{
                            "f: the first grid with points and elements is read, 1 more are not"});
  const auto plane = xdmf(
      "<Xdmf><Domain><Grid GridType=\"Collection\"><Grid><Topology TopologyType=\"polyline\" "
      "NodesPerElement=\"2\">" +
      item("1 2", "0 1") + "</Topology><Geometry GeometryType=\"XY\">" + item("2 2", "0 0 1 2") +
      "</Geometry></Grid></Grid></Domain></Xdmf>");
  REQUIRE_MESSAGE(plane, error_of(plane));
  CHECK(plane->points.points == std::vector<Point>{{0, 0}, {1, 2}});
  CHECK(plane->edges.simplices == std::vector<Simplex>{{0, 1}});
}

TEST_CASE("xdmf: a line has two nodes, and a point one, unless the file says how many") {
  const auto edges_of = [](const std::string& type, const std::string& cells) {
    const auto read = xdmf(document_of(grid(kTextPoints, type, cells)));
    REQUIRE_MESSAGE(read, error_of(read));
    return read->edges.simplices;
  };
  CHECK(edges_of("Polyline", item("4", "0 1 2 3")) == std::vector<Simplex>{{0, 1}, {2, 3}});
  CHECK(edges_of("Polyline\" NodesPerElement=\"4", item("4", "0 1 2 3")) ==
        std::vector<Simplex>{{0, 1}, {1, 2}, {2, 3}});
  CHECK(edges_of("Polyvertex", item("3", "0 1 2")).empty());
}

TEST_CASE("xdmf: what is refused") {
  const auto said = [](const std::string& points, const std::string& type,
                       const std::string& cells) {
    return xdmf_error(document_of(grid(points, type, cells)));
  };
  const auto cells = [&](const std::string& dimensions, const std::string& numbers) {
    return said(kTextPoints, "Tetrahedron", item(dimensions, numbers));
  };
  CHECK(xdmf_error("<Xdmf>").starts_with("f:1: expected XML, found a fault"));
  CHECK(xdmf_error("<VTKFile/>") == "f:1: expected the element Xdmf, found \"VTKFile\"");
  CHECK(xdmf_error(document_of("<Grid/>")).find("a Grid with a Geometry and a Topology") !=
        std::string::npos);
  CHECK(cells("1 4", "0 1 2").find("found the end of the file") != std::string::npos);
  CHECK(cells("1 4", "0 1 2 3 4") == "f:6: expected the end of the elements, found \"4\"");
  CHECK(cells("5", "0 1 2 3 4").find("4 nodes of each element, found 5") != std::string::npos);
  CHECK(cells("99999999999 4", "0 1 2 3").find("numbers, by its Dimensions") != std::string::npos);
  CHECK(cells("9999999999 9999999999", "0").find("fits 64 bits") != std::string::npos);
  CHECK(cells("-1", "0").find("fits 64 bits") != std::string::npos);
  CHECK(said(kTextPoints, "Mixed", item("4", "6 0 1 2")).find("the 4 nodes of a tetrahedron") !=
        std::string::npos);
  CHECK(said(kTextPoints, "Mixed", item("2", "99 0")).find("found 99") != std::string::npos);
  CHECK(said(kTextPoints, "Mixed", item("3", "3 -1 0")).find("the -1 nodes") != std::string::npos);
  CHECK(said(kTextPoints, "2DRectMesh", item("1", "0")).find("found \"2DRectMesh\"") !=
        std::string::npos);
  CHECK(said(item("4", "0 0 0 1"), "Triangle", "").find("3 coordinates of each point, found 4") !=
        std::string::npos);
  CHECK(said("", "Triangle", "").find("a DataItem in Geometry, found none") != std::string::npos);
  const std::string of_dimensions =
      ": expected Dimensions=\"N M\", whole numbers whose product fits 64 bits, found ";
  CHECK(cells("", "0") == "f:6" + of_dimensions + "none");
  CHECK(cells("1 1 1 1 1 1 1 1 1", "0") == "f:6" + of_dimensions + "\"1 1 1 1 1 1 1 1 1\"");
  CHECK(said(kTextPoints, "Mixed", item("4", "3 2 0 1")) ==
        "f:6: expected a polygon of 3 vertices or more, found 2");
  const std::string typed = "<DataItem Dimensions=\"1 3\" NumberType=";
  CHECK(said(kTextPoints, "Triangle", typed + "\"Word\">0 1 2</DataItem>").find("found \"Word\"") !=
        std::string::npos);
  CHECK(said(kTextPoints, "Triangle",
             typed + "\"Int\" Format=\"Binary\" Endian=\"Middle\">x.bin</DataItem>") ==
        "f:6: expected Endian=\"Native\", \"Little\" or \"Big\", found \"Middle\"");
  for (const char* const path : {"/etc/passwd:/a", "../x.h5:/a", "none.h5:/a"}) {
    CHECK(said(item("4 3", path, "HDF"), "Triangle", "").find("the same folder or below it") !=
          std::string::npos);
  }
}

TEST_CASE("hdf5: chunks, packed or not, and both forms of groups, of either byte order") {
  const auto geometry = sample("chunked.h5", "/Mesh/mesh/geometry");
  REQUIRE_MESSAGE(geometry, error_of(geometry));
  CHECK(geometry->dimensions == std::vector<std::size_t>{5, 3});
  CHECK(geometry->type.kind == NumberType::Kind::kFloating);
  const auto latest = sample("latest.h5", "a/points");
  REQUIRE_MESSAGE(latest, error_of(latest));
  CHECK(geometry->bytes == latest->bytes);
  const auto big = sample("plain.h5", "/points");
  REQUIRE_MESSAGE(big, error_of(big));
  CHECK(big->order == ByteOrder::kBigEndian);
  CHECK(error_of(sample("plain.h5", "/text")).find("numbers of class 3") != std::string::npos);
  CHECK(error_of(sample("plain.h5", "/no")).find("found no \"no\" in it") != std::string::npos);
  CHECK(error_of(sample("chunked.h5", "/Mesh")).find("a group, or another object") !=
        std::string::npos);
}

TEST_CASE("hdf5: a byte of a chunk that is changed breaks its checksum") {
  auto source = load(kXdmfCorpus + "chunked.h5");
  REQUIRE(source);
  std::size_t refused = 0;
  const std::string text = source->text;
  const std::string begin_of_chunk = "x^";  // of deflate, level 4
  for (std::size_t at = text.find(begin_of_chunk); at != std::string::npos;
       at = text.find(begin_of_chunk, at + 1)) {
    source->text = text;
    source->text[at + 4] = static_cast<char>(source->text[at + 4] ^ 1);
    const auto geometry = read_hdf5(*source, "/Mesh/mesh/geometry");
    const auto topology = read_hdf5(*source, "/Mesh/mesh/topology");
    const bool are_both_read = geometry && topology;
    CHECK_FALSE(are_both_read);
    refused += error_of(geometry).find("with their checksum") != std::string::npos ? 1 : 0;
  }
  CHECK(refused == 6);  // chunks of the geometry
}

TEST_CASE(
    "hdf5: cut off or changed anywhere, a file is refused or read, and nothing else happens") {
  for (const auto& [name, path] : {std::pair{"chunked.h5", "/Mesh/mesh/topology"},
                                   {"plain.h5", "/cells"},
                                   {"latest.h5", "/a/cells"}}) {
    auto source = load(kXdmfCorpus + name);
    REQUIRE(source);
    const auto whole = read_hdf5(*source, path);
    REQUIRE_MESSAGE(whole, error_of(whole));
    const std::string text = source->text;
    for (std::size_t at = 0; at < text.size(); ++at) {
      // Most of a file are zeros that no object has.
      if (text[at] == '\0' && at % 16 != 0) continue;
      source->text = text.substr(0, at);
      if (const auto cut = read_hdf5(*source, path)) CHECK(cut->bytes == whole->bytes);
      source->text = text;
      source->text[at] = static_cast<char>(source->text[at] ^ 0xff);
      const auto changed = read_hdf5(*source, path);
      if (!changed) CHECK(changed.error().to_string().find("expected ") != std::string::npos);
    }
  }
}

TEST_CASE("xdmf: a mesh whose numbers are in HDF5 or in bytes beside it") {
  const ScratchFolder folder;
  for (const char* const name : {"chunked.h5", "latest.h5", "plain.h5"}) {
    folder.write(name, load(kXdmfCorpus + name)->text);
  }
  folder.write("cells.bin", std::string("\0\0\0\0\1\0\0\0\2\0\0\0\3\0\0\0", 16));
  const auto mesh_of = [&](const std::string& points, const std::string& type,
                           const std::string& cells) {
    return read_mesh({.mesh = folder.write("x.xdmf", document_of(grid(points, type, cells)))});
  };
  for (const std::string group : {"chunked.h5:/Mesh/mesh/geometry", "latest.h5:a/points"}) {
    const auto mesh = mesh_of(item("5 3", " " + group + "\n", "HDF"), "Tetrahedron",
                              item("2 4", "chunked.h5:/Mesh/mesh/topology", "HDF"));
    REQUIRE_MESSAGE(mesh, error_of(mesh));
    CHECK(mesh->mesh.exact_points() == kSamplePoints);
    CHECK(mesh->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}, {1, 2, 3, 4}});
  }
  const auto mixed =
      mesh_of(item("5 3", "plain.h5:points", "HDF"), "Mixed", item("16", "plain.h5:/cells", "HDF"));
  REQUIRE_MESSAGE(mixed, error_of(mixed));
  CHECK(mixed->mesh.simplices.size() == 1);
  CHECK(mixed->mesh.exact_points()[3][2] == Rational(11184811, 33554432));
  const auto bytes = mesh_of(kTextPoints, "Tetrahedron", item("1 4", "cells.bin", "Binary"));
  REQUIRE_MESSAGE(bytes, error_of(bytes));
  CHECK(bytes->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  for (const std::size_t size : {12, 15, 17, 20}) {
    folder.write("other.bin", std::string(size, '\0'));
    CHECK(error_of(mesh_of(kTextPoints, "Tetrahedron", item("1 4", "other.bin", "Binary")))
              .find("expected 4 numbers of 4 bytes in \"other.bin\", found " +
                    std::to_string(size) + " bytes") != std::string::npos);
  }
  for (const char* const dimensions : {"1 3", "1 5"}) {
    CHECK(error_of(mesh_of(kTextPoints, "Tetrahedron", item(dimensions, "cells.bin", "Binary")))
              .find(":6: expected") != std::string::npos);
    CHECK(error_of(mesh_of(kTextPoints, "Mixed", item(dimensions, "plain.h5:/cells", "HDF")))
              .find("16 in \"plain.h5:/cells\"") != std::string::npos);
  }
  CHECK(error_of(mesh_of(kTextPoints, "Triangle", item("15", "plain.h5:/points", "HDF")))
            .find("expected integers, found floating-point numbers") != std::string::npos);
  CHECK(error_of(mesh_of(kTextPoints, "Triangle", item("16", "cells.bin:/x", "HDF")))
            .find("a file of HDF5, found ") != std::string::npos);
}

}  // namespace circumspect::formats
