// A domain as meshes are held against it: in the plane or, if a mesh is not in the plane of a flat
// domain, in space.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/check/within_option.hpp"
#include "command/input/domain_input.hpp"
#include "command/output/output.hpp"

namespace circumspect::cli {

// The domain, and the same with polygons joined that are not flat, if that is asked for.
struct HeldAgainst {
  LoadedDomain loaded;
  std::optional<BentDomain> bent = {};

  const Domain& judged() const { return bent ? bent->domain : loaded.domain; }
  std::vector<Vertex> polygon_markers() const {
    return bent ? std::vector<Vertex>() : loaded.file.polygon_markers;
  }
};

// What a domain is and how it is to be read.
struct AskedDomain {
  std::string path;
  const InputOptions& input;
  const DomainOptions& said;
  const std::optional<Distance>& within;
  std::size_t max_breaches = 0;
};

class DomainReadings {
 public:
  // Requires: the options outlive this object.
  explicit DomainReadings(AskedDomain asked) : asked_(std::move(asked)) {}

  // Reads the domain and prints its notes; false, with an error, if it is at fault.
  bool load(Output& output);
  // Requires: it is loaded.
  DomainFrame frame() const { return frame_of(as_read_->loaded); }
  // The reading that fits a mesh, which was read for `frame()`, or could not be read. Null, with an
  // error, if that is one in space and none is valid there. Requires: it is loaded.
  const HeldAgainst* for_mesh(const LoadedMesh* mesh, Output& output);

 private:
  std::optional<HeldAgainst> held_against(tl::expected<LoadedDomain, DomainFault> domain,
                                          Output& output) const;
  // The domain with polygons taken for flat whose corners are within the distance of one plane;
  // nothing if that is not all that is wrong with it.
  std::optional<HeldAgainst> held_if_rounded(const Output& output) const;

  AskedDomain asked_;
  std::optional<HeldAgainst> as_read_;
  std::optional<HeldAgainst> in_space_;
};

}  // namespace circumspect::cli
