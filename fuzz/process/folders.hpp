// Measures, empties and removes folders that somebody else has filled, whatever their depth, permissions and links.
#pragma once

#include <cstdint>
#include <string>

namespace circumspect::campaign {

// How many bytes the files of a folder take on disk; each entry counts as kEntryBytes at least, for it
// takes room even if it is empty. Stops at `enough`, and says that much of folders that are nested
// more than kDeepest deep. Links are not followed.
constexpr std::uint64_t kEntryBytes = 1024;
constexpr int kDeepest = 64;
std::uint64_t bytes_in(const std::string& folder, std::uint64_t enough);

// Is it a folder, and not a link to one?
bool is_folder(const std::string& path);

// Deletes all that is in a folder and lets its owner do everything there; false if it is not a
// folder, or something stays. Links are deleted and not followed.
bool emptied(const std::string& folder);

// The same, and the folder too; or a file, or a link. True if there is nothing of that name in the end.
bool removed(const std::string& path);

}  // namespace circumspect::campaign
