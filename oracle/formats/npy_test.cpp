// .npy files: what is read, what is refused, and the messages.
#include "oracle/formats/npy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "oracle/formats/reading_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::formats {
namespace {

std::string points_error(const std::string& bytes) {
  return error_of(read_npy_points(named(bytes)));
}
std::string simplices_error(const std::string& bytes) {
  return error_of(read_npy_simplices(named(bytes)));
}
std::string header_error(const std::string& header) {
  return points_error(npy_with_header(header, std::string(16, '\0')));
}

const std::vector<double> kSix = {0, 0.1, 1e300, -0.0, 0x1p-1074, -5};
const std::string kAdvice = "; numpy.save(file, points.astype('<f8')) writes what is read";

}  // namespace

TEST_CASE("npy: points of doubles, exactly") {
  const auto file = read_npy_points(named(npy("<f8", "(2, 3)", kSix)));
  REQUIRE_MESSAGE(file.has_value(), error_of(file));
  CHECK(file->dimension == 3);
  CHECK(file->first_index == 0);
  CHECK(file->points == std::vector<Point>{{0, exact_value(0.1), exact_value(1e300)},
                                           {0, exact_value(0x1p-1074), -5}});
  const std::string bytes = npy("<f8", "(3, 2)", kSix);
  const auto flat = read_rows_of_npy_points(RandomAccess(std::string_view(bytes)), "f");
  REQUIRE(flat);
  CHECK(flat->rows() == 3);
  CHECK(flat->row(1)[0] == 1e300);
  CHECK(!std::signbit(flat->row(1)[1]));
  const auto none = read_npy_points(named(npy<double>("<f8", "(0, 3)", {})));
  REQUIRE_MESSAGE(none.has_value(), error_of(none));
  CHECK(none->dimension == 3);
  CHECK(none->points.empty());
}

TEST_CASE("npy: parts of the rows are the whole, and a fault is named where it stands") {
  std::vector<double> values(14);
  std::iota(values.begin(), values.end(), 1.0);
  for (const std::string fortran : {"False", "True"}) {
    const std::string bytes = npy<double>("<f8", "(7, 2)", values, fortran);
    const RandomAccess file{std::string_view(bytes)};
    const auto whole = read_rows_of_npy_points(file, "f");
    REQUIRE(whole);
    for (const std::size_t parts : {1u, 2u, 3u, 9u}) {
      std::vector<double> together;
      for (std::size_t part = 0; part < parts; ++part) {
        const auto rows = read_rows_of_npy_points(file, "f", PartOf{part, parts}.slice(7));
        REQUIRE(rows);
        CHECK(rows->columns() == 2);
        together.insert(together.end(), std::as_const(*rows).values().begin(),
                        std::as_const(*rows).values().end());
      }
      const auto all = std::as_const(*whole).values();
      CHECK(together == std::vector<double>(all.begin(), all.end()));
    }
  }
  values[11] = std::numeric_limits<double>::infinity();
  const std::string bytes = npy<double>("<f8", "(7, 2)", values);
  const RandomAccess file{std::string_view(bytes)};
  CHECK(read_rows_of_npy_points(file, "f", {0, 4}));
  CHECK(error_of(read_rows_of_npy_points(file, "f", {4, 7})) ==
        "f: expected finite coordinates, found an infinity in row 5, column 1, counted from 0");
}

TEST_CASE("npy: simplices of 32 and of 64 bits") {
  const std::vector<Simplex> expected = {{0, 1, 2}, {-1, 2147483647, 3}};
  const auto narrow =
      read_npy_simplices(named(npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 2, -1, 2147483647, 3})));
  REQUIRE_MESSAGE(narrow.has_value(), error_of(narrow));
  CHECK(narrow->simplices == expected);
  CHECK(narrow->vertices_per_simplex == 3);
  CHECK(narrow->lines.size() == 2);
  const auto wide =
      read_npy_simplices(named(npy<std::int64_t>("<i8", "(2, 3)", {0, 1, 2, -1, 2147483647, 3})));
  REQUIRE_MESSAGE(wide.has_value(), error_of(wide));
  CHECK(wide->simplices == expected);
  CHECK(read_npy_simplices(named(npy<std::int64_t>("<i8", "(1, 1)", {INT64_MIN})))->simplices ==
        std::vector<Simplex>{{INT64_MIN}});
}

TEST_CASE("npy: other types, byte orders and Fortran order mean the same numbers") {
  const std::vector<Point> expected = {{0, exact_value(0.5)}, {3, exact_value(0.1F)}, {-7, 0}};
  const auto points = [](const std::string& bytes) {
    return read_npy_points(named(bytes))->points;
  };
  CHECK(points(npy<float>("<f4", "(3, 2)", {-0.0F, 0.5F, 3, 0.1F, -7, 0})) == expected);
  CHECK(points(npy<float>("<f4", "(3, 2)", {0, 3, -7, 0.5F, 0.1F, 0}, "True")) == expected);
  CHECK(points(npy<double>("<f8", "(3, 2)", {0, 3, -7, 0.5, 0.1F, 0}, "True")) == expected);
  const auto swapped = [](auto values) {
    for (auto& value : values) {
      char* const bytes = reinterpret_cast<char*>(&value);
      std::reverse(bytes, bytes + sizeof value);
    }
    return values;
  };
  CHECK(points(npy(">f4", "(3, 2)", swapped(std::vector<float>{0, 0.5F, 3, 0.1F, -7, 0}))) ==
        expected);
  CHECK(points(npy(">f8", "(3, 2)", swapped(std::vector<double>{0, 3, -7, 0.5, 0.1F, 0}),
                   "True")) == expected);
  const std::vector<Simplex> two = {{0, 1, 2}, {3, 1, 100}};
  const auto simplices = [](const std::string& bytes) {
    return read_npy_simplices(named(bytes))->simplices;
  };
  CHECK(simplices(npy<std::uint8_t>("|u1", "(2, 3)", {0, 1, 2, 3, 1, 100})) == two);
  CHECK(simplices(npy<std::int8_t>("|i1", "(2, 3)", {0, 1, 2, 3, 1, 100})) == two);
  CHECK(simplices(npy<std::uint16_t>("<u2", "(2, 3)", {0, 1, 2, 3, 1, 100})) == two);
  CHECK(simplices(npy<std::int16_t>("<i2", "(2, 3)", {0, 3, 1, 1, 2, 100}, "True")) == two);
  CHECK(simplices(npy<std::uint32_t>("<u4", "(2, 3)", {0, 1, 2, 3, 1, 100})) == two);
  CHECK(simplices(npy<std::uint64_t>("<u8", "(2, 3)", {0, 1, 2, 3, 1, 100})) == two);
  CHECK(simplices(npy(">i4", "(2, 3)", swapped(std::vector<std::int32_t>{0, 1, 2, 3, 1, 100}))) ==
        two);
  CHECK(simplices(npy<std::int64_t>("<i8", "(2, 3)", {0, 3, 1, 1, 2, 100}, "True")) == two);
  CHECK(simplices(npy<std::uint32_t>("<u4", "(1, 1)", {UINT32_MAX})) ==
        std::vector<Simplex>{{4294967295}});
  // Infinite coordinates are refused, whatever their type.
  CHECK(points_error(npy<float>("<f4", "(1, 1)", {std::numeric_limits<float>::infinity()})) ==
        "f: expected finite coordinates, found an infinity in row 0, column 0, counted from 0");
}

TEST_CASE("npy: every version and every way to write the header") {
  const std::string data(16, '\0');
  const std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }";
  for (const char version : {'\1', '\2', '\3'}) {
    CHECK(read_npy_points(named(npy_with_header(header, data, version))));
  }
  for (const std::string other :
       {"{'shape': (1, 2), 'fortran_order': False, 'descr': '<f8'}",
        "{\"descr\":\"<f8\",\"fortran_order\":False,\"shape\":(1,2)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (1L, 2L), }",
        " { 'descr' : '<f8' , 'fortran_order' : False , 'shape' : ( 1 , 2 , ) , } "}) {
    CHECK(header_error(other) == "no error");
  }
}

TEST_CASE("npy: another type, order or shape, with what to do about it") {
  const std::string points = "f: expected points of type float64 or float32 ('<f8', '<f4'), found ";
  for (const std::string type : {"<f2", "<f16", "<i8", "f8", "=f8", "<f8 ", "", "<c8", "|O"}) {
    CHECK(points_error(npy(type, "(2, 3)", kSix)) == points + "\"" + type + "\"" + kAdvice);
  }
  CHECK(
      header_error("{'descr': [('x', '<f8'), ('y', '<f8', [2])], 'fortran_order': False, 'shape': "
                   "(1,), }") == points + "\"[('x', '<f8'), ('y', '<f8', [2])]\"" + kAdvice);
  CHECK(simplices_error(npy("<f8", "(2, 3)", kSix)) ==
        "f: expected simplices of type integers ('<i8', '<i4', '<u4', ...), found \"<f8\"; "
        "numpy.save(file, simplices.astype('<i8')) writes what is read");
  CHECK(simplices_error(npy<std::uint64_t>("<u8", "(1, 1)", {UINT64_MAX})) ==
        "f: expected vertices below 2^63, found a larger one");
  CHECK(points_error(npy("<f8", "(6,)", kSix)) ==
        "f: expected an array of shape (n, d), found shape (6,)");
  CHECK(points_error(npy("<f8", "()", kSix)) ==
        "f: expected an array of shape (n, d), found shape ()");
  CHECK(simplices_error(npy<std::int32_t>("<i4", "(1, 1, 1)", {7})) ==
        "f: expected an array of shape (m, d + 1), found shape (1, 1, 1)");
  CHECK(points_error(npy<double>("<f8", "(6, 0)", {})) ==
        "f: expected points of dimension 1 to 16, found shape (6, 0)");
  CHECK(points_error(npy("<f8", "(1, 17)", std::vector<double>(17))) ==
        "f: expected points of dimension 1 to 16, found shape (1, 17)");
  CHECK(simplices_error(npy<std::int32_t>("<i4", "(6, 0)", {})) ==
        "f: expected simplices of at least 1 vertex, found shape (6, 0)");
}

TEST_CASE("npy: as many numbers as the shape says, all finite") {
  CHECK(points_error(npy("<f8", "(3, 3)", kSix)) ==
        "f: expected 72 bytes of data, for shape (3, 3), found 48");
  CHECK(points_error(npy("<f8", "(1, 3)", kSix)) ==
        "f: expected 24 bytes of data, for shape (1, 3), found 48");
  CHECK(points_error(npy("<f8", "(9223372036854775807, 3)", kSix)) ==
        "f: expected more bytes than fit a file of data, for shape (9223372036854775807, 3), found "
        "48");
  CHECK(points_error(npy("<f8", "(2305843009213693952, 3)", kSix)).find("more bytes than") !=
        std::string::npos);
  std::vector<double> values = kSix;
  values[4] = std::numeric_limits<double>::quiet_NaN();
  CHECK(points_error(npy("<f8", "(2, 3)", values)) ==
        "f: expected finite coordinates, found NaN in row 1, column 1, counted from 0");
  values[2] = -std::numeric_limits<double>::infinity();
  CHECK(points_error(npy("<f8", "(2, 3)", values)) ==
        "f: expected finite coordinates, found an infinity in row 0, column 2, counted from 0");
}

TEST_CASE("npy: what is not a header of NumPy") {
  const std::string npy_file = "f: expected an .npy file, which begins with \\x93NUMPY, found ";
  CHECK(points_error("") == npy_file + "an empty file");
  CHECK(points_error("4 3 0 0\n") == npy_file + "\"4 3 0 \"");
  CHECK(points_error("\x93NUMPX12345") == npy_file + "\"\\x93NUMPX\"");
  const std::string whole = npy("<f8", "(2, 3)", kSix);
  CHECK(points_error(whole.substr(0, 9)) == "f: expected a header, found the end of the file");
  CHECK(points_error(whole.substr(0, 50)) == "f: expected a header of 118 bytes, found 40");
  std::string version = whole;
  version[6] = 4;
  CHECK(points_error(version) == "f: expected version 1, 2 or 3 of the format, found version 4.0");
  CHECK(points_error(npy_with_header(std::string(70000, ' '), "", 2))
            .starts_with("f: expected a header of at most 10000 bytes, found one of 7"));
  const std::string header =
      "f: expected a header of NumPy such as {'descr': '<f8', 'fortran_order': False, 'shape': "
      "(4, 3)}, found ";
  CHECK(header_error("") == header + "the end of the header");
  CHECK(header_error("{'descr': '<f8', 'shape': (1, 2)}").starts_with(header));
  CHECK(header_error("{'descr': '<f8', 'descr': '<f8', 'fortran_order': False, 'shape': (1, 2)}")
            .starts_with(header + "\"'descr': '<f8', 'fortran_order': False"));
  CHECK(header_error("{'descr': '<f8', 'fortran_order': 0, 'shape': (1, 2)}")
            .starts_with(header + "\"0, 'shape': (1, 2)}"));
  for (const std::string wrong :
       {"{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2)} x",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (1 2)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (1, -2)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 99999999999999999999)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2)",
        "{'descr': '<f8, 'fortran_order': False, 'shape': (1, 2)}",
        "{'descr': '<f8' 'fortran_order': False, 'shape': (1, 2)}",
        "{'descr': [[, 'fortran_order': False, 'shape': (1, 2)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), 'more': 1}"}) {
    CAPTURE(wrong);
    CHECK(header_error(wrong).starts_with(header));
  }
}

TEST_CASE("npy: any bytes in header and data") {
  CHECK(properties::holds("mutations", [] {
    std::string bytes = *rc::gen::arbitrary<bool>()
                            ? npy("<f8", "(2, 3)", kSix)
                            : npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 2, 1, 2, 3});
    const int edits = *rc::gen::inRange(1, 4);
    for (int i = 0; i < edits && !bytes.empty(); ++i) {
      // Most of the changes are where the header has content.
      const auto at = *rc::gen::inRange<std::size_t>(0, std::min<std::size_t>(bytes.size(), 90));
      switch (*rc::gen::inRange(0, 4)) {
        case 0:
          bytes[at] = *rc::gen::arbitrary<char>();
          break;
        case 1:
          bytes[at] = *rc::gen::elementOf(std::string("{}[]()',:0123456789<>fiL "));
          break;
        case 2:
          bytes.resize(at);
          break;
        default:
          bytes.insert(at, 1, *rc::gen::arbitrary<char>());
      }
    }
    for (const std::string& message : {points_error(bytes), simplices_error(bytes)}) {
      RC_ASSERT(message == "no error" || message.starts_with("f: expected "));
      RC_ASSERT(message.find('\n') == std::string::npos && message.size() < 500U);
    }
  }));
}

TEST_CASE("npz: an array of an archive is the bytes of its .npy file") {
  const std::string points = npy("<f8", "(2, 3)", kSix);
  const std::string simplices = npy<std::int32_t>("<i4", "(1, 2)", {0, 1});
  for (const int method : {0, 8}) {
    CAPTURE(method);
    const Source archive =
        named(npz({{"simplices.npy", simplices}, {"points.npy", points}}, method));
    CHECK(is_npz(archive.text));
    CHECK(array_of_npz(archive, "points")->text == points);
    CHECK(array_of_npz(archive, "points")->name == "f/points.npy");
    CHECK(array_of_npz(archive, "simplices")->text == simplices);
    CHECK(error_of(array_of_npz(archive, "weights")) ==
          "f: expected an array named weights, as numpy.savez(file, points=..., simplices=...) "
          "writes it, found \"simplices.npy points.npy\"");
    // A comment may follow.
    CHECK(array_of_npz(named(archive.text + "a comment"), "points"));
  }
  CHECK(!is_npz(points));
  CHECK(error_of(array_of_npz(named(points), "points")) ==
        "f: expected an archive of arrays, as numpy.savez writes it, found no ZIP file");
  CHECK(error_of(array_of_npz(named(npz({}, 0)), "points")) ==
        "f: expected an array named points, as numpy.savez(file, points=..., simplices=...) writes "
        "it, found none");
}

TEST_CASE("npz: damage is found, wherever it is") {
  const std::string points = npy("<f8", "(2, 3)", kSix);
  for (const int method : {0, 8}) {
    const std::string archive = npz({{"points.npy", points}}, method);
    const auto is_points = [&](const std::string& bytes) {
      const auto array = array_of_npz(named(bytes), "points");
      return array && array->text == points;
    };
    for (std::size_t i = 0; i < archive.size(); ++i) {
      CHECK(!is_points(archive.substr(0, i)));
      for (const int change : {1, 0x80, 0xff}) {
        std::string other = archive;
        other[i] = static_cast<char>(other[i] ^ change);
        const auto array = array_of_npz(named(other), "points");
        if (array) CHECK(array->text == points);  // the byte does not matter for this array
      }
    }
  }
  // An entry may have an empty name; bytes that do not begin like an entry are not one.
  CHECK(array_of_npz(named(npz({{"points.npy", points}, {"", ""}}, 0)), "points"));
  std::string no_entry = npz({{"points.npy", points}}, 0);
  no_entry[no_entry.rfind("PK\1\2")] = 'Q';
  CHECK(!array_of_npz(named(no_entry), "points"));
  std::string encrypted = npz({{"points.npy", points}}, 0);
  encrypted[encrypted.rfind("PK\1\2") + 8] = 1;
  CHECK(error_of(array_of_npz(named(encrypted), "points")) ==
        "f/points.npy: expected an array as numpy.savez or numpy.savez_compressed packs it, found "
        "one that is encrypted");
  CHECK(error_of(array_of_npz(named(npz({{"points.npy", points}}, 14)), "points")) ==
        "f/points.npy: expected an array as numpy.savez or numpy.savez_compressed packs it, found "
        "method 14");
  // No memory is allocated for more than zlib can have packed of the numbers of a mesh, such as for
  // very many zeros.
  const std::string zeros =
      npz({{"points.npy", npy<double>("<f8", "(100000, 2)", std::vector<double>(200'000))}}, 8);
  CHECK(error_of(array_of_npz(named(zeros), "points")).ends_with(", found 1600128"));
  CHECK(zeros.size() < 6000);
  std::string huge = npz({{"points.npy", points}}, 8);
  huge.replace(huge.rfind("PK\1\2") + 24, 4, "\xfe\xff\xff\xff");
  CHECK(error_of(array_of_npz(named(huge), "points")) ==
        "f/points.npy: expected at most " + std::to_string(1'000'000 + 100 * huge.size()) +
            " bytes in an archive of " + std::to_string(huge.size()) + ", found 4294967294");
  huge.replace(huge.rfind("PK\1\2") + 24, 4, "\xff\xff\xff\xff");
  CHECK(error_of(array_of_npz(named(huge), "points")) ==
        "f/points.npy: expected less than 4 GiB (numpy.save writes larger arrays), found more");
}

}  // namespace circumspect::formats
