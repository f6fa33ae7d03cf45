// What the systems of POSIX do each in its own way.
#pragma once

#include <cstddef>
#include <string>

namespace circumspect::platform {

// A file without a name, in a folder, to be written to; negative if there are none here.
int open_unnamed(const std::string& folder);
// Gives it a name that is free. False, and errno, if that fails.
bool name_unnamed(int descriptor, const std::string& name);

// A pipe that no program inherits, its end to be read first. False, and errno, if that fails.
bool open_pipe(int (&ends)[2]);

// The system may put these whole pages into large ones.
void advise_large_pages(void* begin, std::size_t bytes);

}  // namespace circumspect::platform
