// `inspect` of a mesh: how it is connected, how large it is, and what its simplices measure.
#pragma once

#include <string>
#include <vector>

#include "command/input/input.hpp"
#include "command/output/output.hpp"
#include "oracle/picture/page.hpp"

namespace circumspect::cli {

struct MeshInspection {
  bool is_asked_for = false;  // --mesh: whatever the name of the file says
};

// Does the file list simplices of a mesh, and nothing else that `inspect` takes?
bool is_mesh_file(const std::string& path);

// The facts that --only may name.
std::vector<std::string> mesh_facts();

// `only`: some of the facts; none means all. Requires: mesh_facts() has them. What is found is
// added to `page`, if there is one.
void inspect_mesh(const std::string& path, const InputOptions& input,
                  const std::vector<std::string>& only, Output& output, picture::Page* page);

}  // namespace circumspect::cli
