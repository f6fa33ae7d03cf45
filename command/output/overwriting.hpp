// Prevents a command from writing over a file that it reads, whatever names the two have. Every
// command that writes files calls this before it reads any.
#pragma once

#include <string>
#include <vector>

namespace circumspect::cli {

// A file that is to be written; "-" is standard output.
struct Written {
  std::string what;  // "the mesh", for messages
  std::string path;
};

// A mesh or points, and the files beside it that belong to it, whether this command reads them or
// not: of x.ele or x.node also x.neigh, x.face, x.edge, x.poly and x.smesh.
std::vector<std::string> files_of_mesh(const std::string& path);

// A domain, and the file that may hold its points.
std::vector<std::string> files_of_domain(const std::string& path);

// Why these files cannot be written while those are read; empty if they can. Two paths are one file
// if the system says so: through links of either kind, too. Pipes and devices are not files. "-"
// among `read` is standard input. Nor may two be written to one place.
std::string overwriting_fault(const std::vector<Written>& written,
                              const std::vector<std::string>& read);

// Is the file in this folder, or in one that is in it? Links are followed.
bool lies_in(const std::string& path, const std::string& folder);

}  // namespace circumspect::cli
