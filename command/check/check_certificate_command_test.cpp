// circumspect check --certificate, as its users run it.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "command/check/certified_meshes_test.hpp"

namespace circumspect::cli {
namespace {

TEST_CASE("check --certificate writes the same beside the verdict") {
  const CertifiedMeshes meshes;
  for (const std::string& mesh : {meshes.good, meshes.bad}) {
    const Run plain = run({"check", mesh});
    const Run certified = run({"check", mesh, "--certificate", meshes.cert});
    CHECK(certified.out == plain.out);
    CHECK(certified.exit_code == plain.exit_code);
    CHECK(contents(meshes.cert) == run({"certify", mesh, "-o", "-"}).out);
  }
  const auto json =
      document(run({"check", meshes.good, "--certificate", meshes.cert, "--format", "json"}));
  CHECK(json["results"][0]["certificate"] == meshes.cert);
}

// One claim for each kind of document: what holds, what does not, and equal points.
TEST_CASE("check --certificate: meshes alone and hulls, as certify judges them") {
  CertifiedMeshes meshes;
  const std::string twice =
      meshes.write("twice", "4 2\n0 0 0\n1 2 0\n2 2 2\n3 2 0\n", "2 3\n0 0 1 2\n1 0 3 2\n");
  const std::string edges =
      meshes.write("edges", kSquareFrom5, "4 2\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n");
  const std::string open = meshes.write("open", kSquareFrom5, "3 2\n5 5 6\n6 6 7\n7 7 8\n");
  const std::string wide =
      meshes.write("wide", "4 2\n0 0 0\n1 4 -1\n2 8 0\n3 4 1\n", "2 3\n0 0 1 2\n1 0 2 3\n");
  using Case = std::pair<const char*, std::string>;
  for (const auto& [claim, mesh] :
       {Case{"complex", meshes.good}, Case{"complex", twice}, Case{"convex-hull", edges},
        Case{"convex-hull", open}, Case{"surface-delaunay", meshes.good},
        Case{"surface-delaunay", wide}}) {
    const Run plain = run({"check", mesh, "--claim", claim});
    const Run checked = run({"check", mesh, "--claim", claim, "--certificate", meshes.cert});
    CHECK(checked.out == plain.out);
    const Run certified = run({"certify", mesh, "--claim", claim, "-o", "-"});
    CHECK(checked.exit_code == certified.exit_code);
    CHECK(has(checked.err, certified.err));
    CHECK(meshes.has_cert() == (certified.exit_code != 2));
    if (meshes.has_cert()) CHECK(contents(meshes.cert) == certified.out);
    std::filesystem::remove(meshes.cert);
  }
  // One witness has room, and it is of another rule than the one that is shown.
  const Run oriented = run({"check", twice, "--claim", "complex", "--oriented", "--max-errors", "1",
                            "--certificate", meshes.cert});
  CHECK(oriented.exit_code == 1);
  for (const char* demand : {"--only-extreme", "--all-boundary-points"}) {
    const Run unproved =
        run({"check", edges, "--claim", "convex-hull", demand, "--certificate", meshes.cert});
    CHECK(unproved.exit_code == 2);
    CHECK(has(unproved.err, "nothing is proved of it"));
  }
  for (const char* command : {"check", "certify"}) {
    const Run unproved =
        run({command, edges, "--claim", "voronoi",
             command == std::string("check") ? "--certificate" : "-o", meshes.cert});
    CHECK(unproved.exit_code == 2);
    CHECK(has(unproved.err,
              "expected a claim about which something is proved for a certificate, "
              "found voronoi"));
  }
  const Run turned =
      run({"check", meshes.good, "--claim", "complex", "--oriented", "--certificate", meshes.cert});
  CHECK(turned.exit_code == 2);
  CHECK(has(turned.err, "found only simplex.orientation, which complex does not include"));
}

TEST_CASE("check --certificate: what it does not go with") {
  const CertifiedMeshes meshes;
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"check", meshes.good, meshes.bad, "--certificate", meshes.cert},
           {"check", meshes.good, "--certificate", "-"}}) {
    const Run result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(is_error_line(result.err));
    CHECK(!meshes.has_cert());
  }
  // The simplices have opposite orientations, which is not part of the claim.
  const Run oriented = run({"check", meshes.good, "--oriented", "--certificate", meshes.cert});
  CHECK(oriented.exit_code == 2);
  CHECK(has(oriented.out, "fails: "));
  CHECK(has(oriented.err, "simplex.orientation"));
  CHECK(!meshes.has_cert());
}

}  // namespace
}  // namespace circumspect::cli
