// Files that gzip packed are read as what they hold; blocks of LZ4 give the bytes that lz4 packed.
#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/lz4.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

const std::string kPlainNode = "4 2\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
const std::string kPlainEle = "2 3\n1 1 2 3\n2 1 3 4\n";
const std::string kPlainOff = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const std::vector<Simplex> kUnpackedTriangles = {{0, 1, 2}, {0, 2, 3}};

// What load_unpacked says of these bytes, without the name of the file.
std::string said_of(const std::string& bytes) {
  const ScratchFolder folder;
  const std::string path = folder.write("x", bytes);
  const std::string said = error_of(load_unpacked(path));
  return said.starts_with(path) ? said.substr(path.size()) : said;
}

}  // namespace

TEST_CASE("packed: a mesh in two files, each packed or not") {
  CHECK(name_inside("a/x.ele.gz") == "a/x.ele");
  CHECK(name_inside(".gz") == ".gz");
  CHECK(extension_inside("x.NODE.gz") == ".node");
  for (const bool are_points_packed : {false, true}) {
    const ScratchFolder folder;
    const std::string ele = folder.write("x.1.ele.gz", gzipped(kPlainEle));
    const std::string node = are_points_packed ? folder.write("x.1.node.gz", gzipped(kPlainNode))
                                               : folder.write("x.1.node", kPlainNode);
    for (const auto& read : {read_mesh({.mesh = ele}), read_mesh_line_by_line({.mesh = ele}),
                             read_mesh({.mesh = node})}) {
      REQUIRE_MESSAGE(read, error_of(read));
      CHECK(read->mesh.simplices.lists() == kUnpackedTriangles);
      CHECK(read->points_name == node);
      CHECK(read->mesh_name == ele);
    }
  }
  const ScratchFolder folder;
  const std::string ele = folder.write("y.ele", kPlainEle);
  folder.write("y.node.gz", gzipped(kPlainNode));
  CHECK(read_mesh({.mesh = ele}));
}

TEST_CASE("packed: the content says that a file is packed, and the name inside its format") {
  const ScratchFolder folder;
  CHECK(read_mesh({.mesh = folder.write("x.off.gz", gzipped(kPlainOff))}));
  CHECK(read_mesh({.mesh = folder.write("y.off.gz", kPlainOff)}));
  CHECK(read_mesh({.mesh = folder.write("x.off", gzipped(kPlainOff))}));
  CHECK(read_mesh({.mesh = folder.write("x", gzipped(kPlainOff))}));
  CHECK(read_points(folder.write("p.node.gz", gzipped(kPlainNode)), kDouble));
  folder.write("d.node.gz", gzipped(kPlainNode));
  const auto domain =
      read_domain(folder.write("d.poly.gz", gzipped("0 2\n1 0\n1 1 3\n0\n")), kDouble);
  REQUIRE_MESSAGE(domain, error_of(domain));
  CHECK(domain->input.points.size() == 4);
  // Lines are those of what is packed.
  const std::string faulty = folder.write("f.node.gz", gzipped("1 2\n1 0 x\n"));
  CHECK(error_of(read_points(faulty, kDouble)) ==
        faulty + ":2: expected a finite number, found \"x\"");
}

TEST_CASE("packed: several packed files are one, zeros may pad it, and nothing else follows") {
  const ScratchFolder folder;
  const std::string both = gzipped("4 2\n1 0 0\n2 1 0\n") + gzipped("3 1 1\n4 0 1\n");
  for (const std::string& bytes : {both, both + std::string(512, '\0')}) {
    const auto source = load_unpacked(folder.write("x", bytes));
    REQUIRE_MESSAGE(source, error_of(source));
    CHECK(source->text == kPlainNode);
  }
  CHECK(said_of(both + "x") == ": expected the end of the packed data, found more bytes");
}

TEST_CASE("packed: what is cut off, changed or swells too much is refused") {
  const std::string packed = gzipped(kPlainNode);
  CHECK(said_of(packed) == "no error");
  for (std::size_t size = 2; size < packed.size(); ++size) {
    CHECK(said_of(packed.substr(0, size)) ==
          ": expected the end of the packed data, found the end of the file");
  }
  std::string changed = packed;
  changed[packed.size() - 6] ^= 1;  // of the checksum
  CHECK(said_of(changed).starts_with(": expected data that gzip packed, found a fault at byte "));
  CHECK(said_of(gzipped(std::string(1'000'000, ' '))) == "no error");
  const std::string bomb = gzipped(std::string(1'000'001, ' '));
  CHECK(said_of(bomb) == ": expected at most 1000000 bytes in a packed file of " +
                             std::to_string(bomb.size()) + ", found more (unpack it first)");
  const std::string large = gzipped(std::string(20'000'000, ' '));
  CHECK(said_of(large).starts_with(": expected at most " + std::to_string(200 * large.size())));
}

TEST_CASE("lz4: literals, copies that reach into themselves, long lengths") {
  const auto unpacked = [](const std::string& block, std::size_t size) {
    std::string text(size, '\0');
    return unpack_lz4(block, text) ? text : "a fault";
  };
  using namespace std::string_literals;
  CHECK(unpacked("\x30"
                 "abc",
                 3) == "abc");
  CHECK(unpacked("\x22"
                 "ab\2\0\x10"
                 "c"s,
                 9) ==
        "abababab"
        "c");
  CHECK(unpacked("\xf0\xff\0"s + std::string(270, 'x'), 270) == std::string(270, 'x'));
  CHECK(unpacked("\x1f"
                 "a\1\0\3\x10"
                 "b"s,
                 24) == std::string(23, 'a') + "b");
  // What lz4 -9 makes of 40 points and a run.
  const std::string packed =
      "\223\060\040\060\040\060\056\065\012\061\010\000\023\062\010\000\023\063\010\000"
      "\023\064\010\000\023\065\010\000\023\066\010\000\023\067\010\000\023\070\010\000"
      "\024\071\110\000\005\121\000\004\122\000\024\061\123\000\024\061\124\000\024\061"
      "\125\000\024\061\126\000\024\061\127\000\024\061\130\000\024\061\131\000\024\061"
      "\132\000\024\062\132\000\025\062\254\000\004\132\000\024\062\132\000\024\062\132"
      "\000\024\062\132\000\024\062\132\000\024\062\132\000\024\062\132\000\024\062\132"
      "\000\024\063\132\000\024\063\132\000\025\063\007\001\004\132\000\024\063\132\000"
      "\024\063\132\000\024\063\132\000\024\063\132\000\024\063\132\000\024\063\132\000"
      "\037\170\001\000\377\024\120\170\170\170\170\170"s;
  std::string text;
  for (int i = 0; i < 40; ++i) text += std::to_string(i) + " 0 0.5\n";
  text += std::string(300, 'x');
  CHECK(unpacked(packed, text.size()) == text);
}

TEST_CASE("lz4: blocks that do not give what is wanted") {
  const auto is_refused = [](const std::string& block, std::size_t size) {
    std::string text(size, '\0');
    return !unpack_lz4(block, text);
  };
  using namespace std::string_literals;
  const std::string whole = "\x22"s + "ab\2\0\xf0\1"s + "cdefghijklmnopqr";
  CHECK(!is_refused(whole, 24));
  for (std::size_t end = 0; end < whole.size(); ++end) CHECK(is_refused(whole.substr(0, end), 24));
  CHECK(is_refused("", 0));
  CHECK(
      is_refused("\x30"
                 "ab",
                 3));
  CHECK(
      is_refused("\x30"
                 "abc",
                 2));
  CHECK(
      is_refused("\x30"
                 "abc",
                 4));
  CHECK(is_refused("\xf0\xff", 300));
  CHECK(
      is_refused("\x10"
                 "a\1"s,
                 5));
  CHECK(
      is_refused("\x10"
                 "a\0\0\x10"
                 "b"s,
                 6));  // from here
  CHECK(
      is_refused("\x10"
                 "a\2\0\x10"
                 "b"s,
                 6));  // from before the beginning
  CHECK(
      is_refused("\x10"
                 "a\1\0\x10"
                 "b"s,
                 4));  // more than there is room for
  CHECK(
      is_refused("\x10"
                 "a\1\0"s,
                 5));  // nothing behind a copy
  CHECK(
      !is_refused("\x10"
                  "a\1\0\x10"
                  "b"s,
                  6));
}

}  // namespace circumspect::formats
