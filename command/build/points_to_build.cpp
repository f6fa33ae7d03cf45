#include "command/build/points_to_build.hpp"

#include <utility>

namespace circumspect::cli {

std::optional<LoadedPoints> points_to_build(const std::string& path, const InputOptions& input,
                                            Output& output) {
  auto loaded = load_points(path, input);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "points", path, loaded.error());
    return std::nullopt;
  }
  if (loaded->merging) loaded->notes.push_back(*loaded->merging);
  return std::move(*loaded);
}

}  // namespace circumspect::cli
