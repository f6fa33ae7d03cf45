// Measures, empties and removes folders that other programs have filled, whatever their depth,
// permissions and links.
#pragma once

#include <cstdint>
#include <string>

namespace circumspect::campaign {

// How many bytes the files of a folder take on disk; each entry counts as at least kEntryBytes,
// because even an empty one takes room. Stops at `enough`, and returns that for folders that are
// nested more than kDeepest deep. Links are not followed.
constexpr std::uint64_t kEntryBytes = 1024;
constexpr int kDeepest = 64;
std::uint64_t bytes_in(const std::string& folder, std::uint64_t enough);

// Is it a folder, and not a link to one?
bool is_folder(const std::string& path);

// Deletes everything in a folder and gives its owner all permissions; false if it is not a folder,
// or something stays. Links are deleted and not followed.
bool emptied(const std::string& folder);

// The same, and removes the folder too; or removes a file or a link. True if nothing has that name
// in the end.
bool removed(const std::string& path);

}  // namespace circumspect::campaign
