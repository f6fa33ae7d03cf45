// Makes names of files and the output of other programs safe to print. Both hold any bytes: a line
// end would forge a line, an escape sequence would move the cursor, and a byte that is not UTF-8
// would break a document.
#pragma once

#include <string>
#include <string_view>

namespace circumspect {

// The text with everything that is not printable written as \xNN, byte by byte: control characters
// (those of eight bits too), separators of lines and paragraphs, controls of the direction of text,
// bytes that are not UTF-8 and the two noncharacters that XML excludes. Printable text of any
// language is kept, including backslashes.
std::string on_one_line(std::string_view text);

// The same, but line ends and tabs are kept.
std::string on_lines(std::string_view text);

// The same as on_lines, with two blanks before every line, to quote another program.
std::string indented(std::string_view text);

// Appends \xNN.
void append_escaped(std::string& text, char byte);

// How many bytes at the beginning form one character of UTF-8, and which one; 0 bytes if they do
// not.
struct Character {
  std::size_t size = 0;
  char32_t code = 0;
};
Character first_character(std::string_view text);

// Is it one of those that on_one_line escapes?
bool is_printable(char32_t code);

}  // namespace circumspect
