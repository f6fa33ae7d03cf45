// Makes names of files and the output of other programs safe to print. Both hold any bytes: a line end would forge
// a line, an escape sequence would move the cursor, and a byte that is not UTF-8 would break a document.
#pragma once

#include <string>
#include <string_view>

namespace circumspect {

// The text with all that is not printable written as \xNN, byte by byte: control characters (those of eight
// bits too), separators of lines and paragraphs, controls of the direction of text, bytes that are
// not UTF-8 and the two noncharacters that XML excludes. What is printable stays, in any language,
// a backslash too.
std::string on_one_line(std::string_view text);

// The same, but for line ends and tabs, which stay.
std::string on_lines(std::string_view text);

// The same as on_lines, with two blanks before every line: the words of another program among our own.
std::string indented(std::string_view text);

// Appends \xNN.
void append_escaped(std::string& text, char byte);

// How many bytes at the beginning are one character of UTF-8, and which; 0 bytes if none is.
struct Character {
  std::size_t size = 0;
  char32_t code = 0;
};
Character first_character(std::string_view text);

// Is it one of those that on_one_line writes otherwise?
bool is_printable(char32_t code);

}  // namespace circumspect
