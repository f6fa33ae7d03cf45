// The words of a text, whatever stands around them: blanks, a byte order mark, letters of any case.
#pragma once

#include <string>
#include <string_view>

namespace circumspect {

// What some programs write before a text in UTF-8. It is no part of the text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// The text behind its byte order mark, if it has one.
std::string_view behind_mark(std::string_view text);

// The text from the first byte on that is neither a blank, an end of a line nor of a byte order
// mark.
std::string_view from_first_word(std::string_view text);

// The same text without blanks, tabs and ends of lines at either end.
std::string_view without_blanks(std::string_view text);

// Is the token this word, in letters of any case?
bool is_word(std::string_view token, std::string_view word);

// In capitals.
std::string upper(std::string_view word);

}  // namespace circumspect
