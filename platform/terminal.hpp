// The terminal, if there is one, and what the process has from who started it.
#pragma once

#include <cstddef>

namespace circumspect::platform {

// Is this open file a terminal? Lines can be taken back on it.
bool is_terminal(int descriptor);
// Does it show colours?
bool shows_colours(int descriptor);
// How many characters fit a line; 0 if it is none.
std::size_t terminal_width(int descriptor);

// The words of the command line, in UTF-8, and how many they are. Requires: those of main.
char** arguments(int& argc, char** argv);

// Standard input, output and error transfer bytes as they are. One that is closed is opened, so
// that no other file gets its number, and still fails to be read or written.
void prepare_standard_files();

}  // namespace circumspect::platform
