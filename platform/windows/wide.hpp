// Windows' own names are UTF-16, and its errors are numbers of its own.
#pragma once

#include <string>
#include <string_view>

namespace circumspect::platform {

// Bytes that are no UTF-8 become U+FFFD, and halves of a pair likewise.
std::wstring to_wide(std::string_view text);
std::string to_utf8(std::wstring_view text);

// errno for what GetLastError() says.
int last_error();

}  // namespace circumspect::platform
