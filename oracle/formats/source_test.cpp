// Loading files, messages on one line, and the lines of a text.
#include "oracle/formats/source.hpp"

#include <filesystem>
#include <fstream>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/lines.hpp"

namespace circumspect::formats {
namespace {

std::string complaint(const std::string& path) {
  const Result<Source> source = load(path);
  return source ? "no error" : source.error().to_string();
}

}  // namespace

TEST_CASE("a file is read with every byte of it") {
  const ScratchFolder folder;
  const std::string bytes("a\0\xff\r\n", 5);
  const std::string path = folder.write("x.node", bytes);
  const Result<Source> source = load(path);
  REQUIRE(source);
  CHECK(source->name == path);
  CHECK(source->text == bytes);
  const std::string large(300000, 'x');
  CHECK(load(folder.write("large", large))->text == large);
  CHECK(load(folder.write("empty", ""))->text.empty());
}

TEST_CASE("what cannot be read says why") {
  const ScratchFolder folder;
  CHECK(complaint(folder.path("none")) ==
        folder.path("none") + ": expected a file, found no file of that name");
  CHECK(complaint(folder.path("none/x.node")) ==
        folder.path("none/x.node") + ": expected a file, found no file of that name");
  CHECK(complaint(folder.path("")) == folder.path("") + ": expected a file, found a directory");
  CHECK(complaint("/dev/zero") == "/dev/zero: expected a file, found a device");
  const std::string secret = folder.write("secret", "1 2\n");
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  // The superuser may read everything.
  if (!std::ifstream(secret)) {
    CHECK(complaint(secret) ==
          secret + ": expected a file to read, found no permission to read it");
  }
}

TEST_CASE("a message is one line, whatever the bytes are") {
  CHECK(FormatError{"a\nb", 3, "x\ty", "z"}.to_string() == "a\\x0ab:3: expected x\\x09y, found z");
  CHECK(FormatError{"f", 0, "x", "y"}.to_string() == "f: expected x, found y");
  CHECK(quote(std::string("\0\x1b[1m\xc3\xa9\n", 8)) == "\"\\x00\\x1b[1m\\xc3\\xa9\\x0a\"");
  CHECK(quote(std::string(41, 'a')) == "\"" + std::string(40, 'a') + "...\"");
}

TEST_CASE("integers") {
  Vertex value = 0;
  CHECK(parse_integer("+7", value) == std::errc());
  CHECK(value == 7);
  CHECK(parse_integer("-9223372036854775808", value) == std::errc());
  for (const char* token : {"", "+", "-", "+-1", "1x", "0x1", "1.0", "99999999999999999999x"}) {
    CHECK_MESSAGE(parse_integer(token, value) == std::errc::invalid_argument, token);
  }
  CHECK(parse_integer("9223372036854775808", value) == std::errc::result_out_of_range);
}

TEST_CASE("lines with tokens, counted from 1") {
  const Source source{"f", "\n a\tb#c d\n#x\n\r\n c"};
  Lines lines(source);
  REQUIRE(lines.next());
  CHECK(lines.line() == 2);
  CHECK(lines.tokens() == std::vector<std::string_view>{"a", "b"});
  REQUIRE(lines.next());
  CHECK(lines.line() == 5);
  CHECK(lines.tokens() == std::vector<std::string_view>{"c"});
  CHECK(!lines.next());
  CHECK(lines.size() == 0);
  CHECK(lines.line() == 5);
}

}  // namespace circumspect::formats
