#include "command/check/judge_file.hpp"

#include <optional>
#include <utility>

#include "oracle/judge/judge_flat.hpp"

namespace circumspect::cli {
namespace {

using LoadedOrFault = tl::expected<LoadedMesh, std::string>;

LoadedOrFault load(const formats::MeshRequest& request, const InputOptions& options) {
  auto raw = formats::read_mesh(request);
  if (!raw) return tl::unexpected(raw.error().to_string());
  return mesh_of(request.mesh, std::move(*raw), options);
}

FileVerdict judge_loaded(LoadedMesh loaded, Claim claim, const JudgeFileOptions& options) {
  auto verdict = check::judge_as_doubles(claim, loaded.mesh, options.check, options.threads);
  if (!verdict) verdict = check::judge(claim, loaded.mesh, options.check);
  return {std::move(*verdict), std::move(loaded.mesh), std::move(loaded.notes)};
}

}  // namespace

tl::expected<FileVerdict, std::string> judge_file(const std::string& path, Claim claim,
                                                  const JudgeFileOptions& options) {
  const InputOptions& input = options.input;
  formats::MeshRequest request{path, input.points, input.coordinates, input.neighbors};
  formats::load_streams(request);
  std::optional<formats::FlatMesh> flat = formats::read_flat_mesh(request, {options.threads});
  if (!flat) {
    LoadedOrFault loaded = load(request, input);
    if (!loaded) return tl::unexpected(std::move(loaded.error()));
    request.loaded.clear();
    return judge_loaded(std::move(*loaded), claim, options);
  }
  request.loaded.clear();
  const bool is_empty =
      flat->points.coordinates.rows() == 0;  // whether that will do is asked below
  if (!options.whole_mesh && !is_empty) {
    auto judged = check::judge_flat(claim, *flat, options.check, options.threads);
    if (judged) return FileVerdict{std::move(judged->verdict), std::move(judged->named)};
  }
  LoadedOrFault loaded = mesh_of(path, formats::raw_mesh(*flat), input);
  flat.reset();
  if (!loaded) return tl::unexpected(std::move(loaded.error()));
  if (options.whole_mesh) return judge_loaded(std::move(*loaded), claim, options);
  Verdict verdict = check::judge(claim, loaded->mesh, options.check);
  return FileVerdict{std::move(verdict), std::move(loaded->mesh), std::move(loaded->notes)};
}

}  // namespace circumspect::cli
