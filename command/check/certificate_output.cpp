#include "command/check/certificate_output.hpp"

#include <fmt/format.h>

#include "oracle/certificate/document.hpp"

namespace circumspect::cli {

bool write_certificate(const std::string& path, const std::string& mesh_name, const ExactMesh& mesh,
                       const Verdict& verdict, Output& output) {
  const auto document = certificate::document_of(mesh, verdict);
  if (!document) {
    output.error(ExitCode::kUsage, "mesh", mesh_name,
                 fmt::format("{}: {}", mesh_name, document.error()));
    return false;
  }
  const std::string fault =
      write_file(path, [&](std::ostream& out) { certificate::write(out, mesh, *document); });
  if (fault.empty()) return true;
  output.error(ExitCode::kUsage, "certificate", path, fault);
  return false;
}

}  // namespace circumspect::cli
