#include "command/output/overwriting.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "oracle/formats/mesh_files.hpp"
#include "platform/files.hpp"

namespace circumspect::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> with_extensions(const std::string& path,
                                         const std::vector<std::string_view>& extensions) {
  std::vector<std::string> paths = {path};
  const std::string end = formats::extension(path);
  if (std::find(extensions.begin(), extensions.end(), end) == extensions.end()) return paths;
  const std::string stem = path.substr(0, path.size() - end.size());
  for (const std::string_view extension : extensions) {
    paths.push_back(stem + std::string(extension));
  }
  return paths;
}

struct Identity {
  std::uint64_t device;
  std::uint64_t number;

  bool operator==(const Identity&) const = default;
};

// Of a file that is there, or of the one that stands for "-"; none of a pipe, a device or a folder.
std::optional<Identity> identity(const std::string& path, int stream) {
  const auto status = path == "-" ? platform::status_of(stream) : platform::status_of(path);
  if (!status || status->kind != platform::FileKind::kRegular) return std::nullopt;
  return Identity{status->device, status->number};
}

// Would the two be one file, one of which may not be there yet?
bool are_one_place(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return false;
  const auto is_no_file = [](const std::string& path) {
    return formats::exists(path) && !formats::is_regular(path);
  };
  if (is_no_file(a) || is_no_file(b)) return false;
  const auto identity_of_a = identity(a, platform::kStandardOutput);
  if (identity_of_a) return identity_of_a == identity(b, platform::kStandardOutput);
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(platform::path_of(a)), error);
  return !error && place == fs::weakly_canonical(fs::absolute(platform::path_of(b)), error);
}

// "found x.node, which is read", or by which other name it is.
std::string clash(const Written& file, const std::string& read) {
  const std::string other = read == file.path ? ""
                                              : fmt::format(" ({} is the same file)",
                                                            read == "-" ? "standard input" : read);
  return fmt::format("expected another name for {}, found {}, which is read{}", file.what,
                     file.path == "-" ? "standard output" : file.path, other);
}

}  // namespace

std::vector<std::string> files_of_mesh(const std::string& path) {
  const std::string end = formats::extension(path);
  if (end == ".qhull" || end == ".qhull-i") return with_extensions(path, {".qhull", ".qhull-i"});
  return with_extensions(path, {".node", ".ele", ".neigh", ".face", ".edge", ".poly", ".smesh"});
}

std::vector<std::string> files_of_domain(const std::string& path) {
  return with_extensions(path, {".poly", ".smesh", ".node"});
}

std::string overwriting_fault(const std::vector<Written>& written,
                              const std::vector<std::string>& read) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    const Written& file = written[i];
    const auto written_to = identity(file.path, platform::kStandardOutput);
    for (const std::string& source : read) {
      if (written_to && identity(source, platform::kStandardInput) == written_to)
        return clash(file, source);
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!are_one_place(written[j].path, file.path)) continue;
      return fmt::format("expected another name for {}, found {}, to which {} is written",
                         file.what, file.path, written[j].what);
    }
  }
  return "";
}

bool lies_in(const std::string& path, const std::string& folder) {
  std::error_code error;
  fs::path place = fs::weakly_canonical(fs::absolute(platform::path_of(path)), error);
  const fs::path above = fs::weakly_canonical(fs::absolute(platform::path_of(folder)), error);
  while (!error && place.has_relative_path()) {
    place = place.parent_path();
    if (place == above) return true;
  }
  return false;
}

}  // namespace circumspect::cli
