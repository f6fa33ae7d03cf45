// What may be printed of names and of other programs' output.
#include "oracle/model/printable.hpp"

#include <doctest/doctest.h>

namespace circumspect {
namespace {

TEST_CASE("what is printable stays, in any language") {
  for (const char* const text :
       {"", "part.1.ele", "a b\\x0a'\"$", "\xc3\xa9t\xc3\xa9", "\xe4\xb8\xad\xe6\x96\x87",
        "\xf0\x9f\x98\x80", "\xc2\xa0", "\xed\x9f\xbf", "\xee\x80\x80", "\xf4\x8f\xbf\xbd"}) {
    CHECK(on_one_line(text) == text);
    CHECK(on_lines(text) == text);
  }
}

TEST_CASE("what is not a character, or moves the cursor, is written byte by byte") {
  CHECK(on_one_line(std::string("a\0b", 3)) == "a\\x00b");
  CHECK(on_one_line("a\nb\tc\r\x1b[31m\x7f") == "a\\x0ab\\x09c\\x0d\\x1b[31m\\x7f");
  CHECK(on_lines("a\nb\tc\r\x1b[31m\x7f") == "a\nb\tc\\x0d\\x1b[31m\\x7f");
  CHECK(on_one_line("\xc2\x85\xc2\x9b") == "\\xc2\\x85\\xc2\\x9b");
  CHECK(on_one_line("\xe2\x80\xa8\xe2\x80\xa9") == "\\xe2\\x80\\xa8\\xe2\\x80\\xa9");
  CHECK(on_one_line("\xe2\x80\xae\xe2\x81\xa6") == "\\xe2\\x80\\xae\\xe2\\x81\\xa6");
  CHECK(on_one_line("\xef\xbf\xbe\xef\xbf\xbf") == "\\xef\\xbf\\xbe\\xef\\xbf\\xbf");
}

TEST_CASE("bytes that are no UTF-8: cut off, too long, surrogates, beyond the last, alone") {
  CHECK(on_one_line("\x9b") == "\\x9b");
  CHECK(on_one_line("\xff\xfe") == "\\xff\\xfe");
  CHECK(on_one_line("\xc3") == "\\xc3");
  CHECK(on_one_line("\xc3(") == "\\xc3(");
  CHECK(on_one_line("\xe2\x80") == "\\xe2\\x80");
  CHECK(on_one_line("\xe2\x80\n") == "\\xe2\\x80\\x0a");
  CHECK(on_one_line("\xc0\x8a\xc1\xbf") == "\\xc0\\x8a\\xc1\\xbf");
  CHECK(on_one_line("\xe0\x80\x8a") == "\\xe0\\x80\\x8a");
  CHECK(on_one_line("\xf0\x80\x80\x8a") == "\\xf0\\x80\\x80\\x8a");
  CHECK(on_one_line("\xed\xa0\x80") == "\\xed\\xa0\\x80");
  CHECK(on_one_line("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  CHECK(on_one_line("\xf5\x80\x80\x80") == "\\xf5\\x80\\x80\\x80");
  CHECK(on_one_line("a\xc3\xa9\xa9z") == "a\xc3\xa9\\xa9z");
}

TEST_CASE("words of another program are told apart from ours") {
  CHECK(indented("") == "");
  CHECK(indented("holds: x\n\nfails\x1b[1m") == "  holds: x\n  \n  fails\\x1b[1m\n");
  CHECK(indented("one\n") == "  one\n");
}

}  // namespace
}  // namespace circumspect
