// check --certificate, of claims about a list of simplices.
#include <filesystem>
#include <string>

#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

// One claim for each kind of document: what holds, what does not, and equal points.
TEST_CASE("check --certificate: meshes alone and hulls, as certify judges them") {
  const ScratchFolder folder;
  const std::string cert = folder.path("cert");
  const auto write = [&](const std::string& name, const std::string& points,
                         const std::string& simplices) {
    folder.write(name + ".node", points);
    return folder.write(name + ".ele", simplices);
  };
  const std::string square = "4 2\n5 0 0\n6 3 0\n7 3 3\n8 0 3\n";
  const std::string good = write("good", square, "2 3\n5 5 6 7\n6 5 8 7\n");
  const std::string twice =
      write("twice", "4 2\n0 0 0\n1 2 0\n2 2 2\n3 2 0\n", "2 3\n0 0 1 2\n1 0 3 2\n");
  const std::string edges = write("edges", square, "4 2\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n");
  const std::string open = write("open", square, "3 2\n5 5 6\n6 6 7\n7 7 8\n");
  const std::string wide =
      write("wide", "4 2\n0 0 0\n1 4 -1\n2 8 0\n3 4 1\n", "2 3\n0 0 1 2\n1 0 2 3\n");
  using Case = std::pair<const char*, std::string>;
  for (const auto& [claim, mesh] :
       {Case{"complex", good}, Case{"complex", twice}, Case{"convex-hull", edges},
        Case{"convex-hull", open}, Case{"surface-delaunay", good},
        Case{"surface-delaunay", wide}}) {
    const Run plain = run({"check", mesh, "--claim", claim});
    const Run checked = run({"check", mesh, "--claim", claim, "--certificate", cert});
    CHECK(checked.out == plain.out);
    const Run certified = run({"certify", mesh, "--claim", claim, "-o", "-"});
    CHECK(checked.exit_code == certified.exit_code);
    CHECK(has(checked.err, certified.err));
    CHECK(std::filesystem::exists(cert) == (certified.exit_code != 2));
    if (std::filesystem::exists(cert)) CHECK(contents(cert) == certified.out);
    std::filesystem::remove(cert);
  }
  // One witness has room, and it is of another rule than the one that is shown.
  const Run oriented = run({"check", twice, "--claim", "complex", "--oriented", "--max-errors", "1",
                            "--certificate", cert});
  CHECK(oriented.exit_code == 1);
  for (const char* demand : {"--only-extreme", "--all-boundary-points"}) {
    const Run unproved =
        run({"check", edges, "--claim", "convex-hull", demand, "--certificate", cert});
    CHECK(unproved.exit_code == 2);
    CHECK(has(unproved.err, "nothing is proved of it"));
  }
  for (const char* command : {"check", "certify"}) {
    const Run unproved = run({command, edges, "--claim", "voronoi",
                              command == std::string("check") ? "--certificate" : "-o", cert});
    CHECK(unproved.exit_code == 2);
    CHECK(has(unproved.err,
              "expected a claim of which something is proved for a certificate, "
              "found voronoi"));
  }
  const Run turned =
      run({"check", good, "--claim", "complex", "--oriented", "--certificate", cert});
  CHECK(turned.exit_code == 2);
  CHECK(has(turned.err, "found only simplex.orientation, which complex does not include"));
}

}  // namespace
}  // namespace circumspect::cli
