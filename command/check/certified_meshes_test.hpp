// A mesh that holds and one that does not, and where their certificates go.
#pragma once

#include <filesystem>
#include <string>

#include "command/run_command_test.hpp"

namespace circumspect::cli {

inline constexpr const char* kSquareFrom5 = "4 2\n5 0 0\n6 2 0\n7 2 2\n8 0 2\n";
inline constexpr const char* kTwoTriangles = "2 3\n5 5 6 7\n6 5 8 7\n";
inline constexpr const char* kOneTriangle = "1 3\n5 5 6 7\n";

struct CertifiedMeshes {
  ScratchFolder folder;
  std::string good = write("good", kSquareFrom5, kTwoTriangles);
  std::string bad = write("bad", kSquareFrom5, kOneTriangle);
  std::string cert = folder.path("out.cert");

  std::string write(const std::string& name, const std::string& points,
                    const std::string& simplices) {
    folder.write(name + ".node", points);
    return folder.write(name + ".ele", simplices);
  }
  bool has_cert() const { return std::filesystem::exists(cert); }
};

}  // namespace circumspect::cli
