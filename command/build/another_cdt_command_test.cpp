// build cdt of domains that have a CDT, but not the canonical one, as its users run it.
#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {

TEST_CASE("build cdt: where there is no canonical CDT, another one is built, if there is any") {
  const ScratchFolder folder;
  for (const std::string name : {"cube-with-diagonal", "cube-with-diagonal-and-floor"}) {
    const std::string domain = std::string(CIRCUMSPECT_CORPUS_DIR) + "/domains/" + name + ".poly";
    CHECK(has(run({"inspect", domain}).out, "triangulation: another (proved)\n"));
    const std::string mesh = folder.path(name + ".1.ele");
    const Run built = run({"build", "cdt", domain, "-o", mesh});
    CHECK_MESSAGE(built.exit_code == 0, (built.out + built.err));
    CHECK(has(built.out, "note: there is no canonical CDT, for segment 1 6 is no edge; "));
    CHECK(has(built.out, "\nbuilt: cdt " + domain + " "));
    CHECK(has(built.out, " not-canonical\n"));
    for (const std::string by : {"lemma", "definition"}) {
      const Run checked = run({"check", mesh, "--domain", domain, "--claim", "cdt", "--by", by});
      CHECK_MESSAGE(checked.exit_code == 0, checked.out);
    }
    // As JSON it is the mesh alone; so the note is on the standard error.
    const Run json = run({"build", "cdt", domain, "--format", "json"});
    CHECK(document(json)["circumspect"] == 1);
    CHECK(has(json.err, "note: there is no canonical CDT, for "));
    // An algorithm makes the canonical one or none, and does not say that there is no other.
    for (const char* algorithm : {"gift-wrapping", "polygon-flips", "polygon-cavities"}) {
      const Run none =
          run({"build", "cdt", domain, "--algorithm", algorithm, "-o", folder.path("none.1.ele")});
      CHECK(none.exit_code == 4);
      CHECK(has(none.out, "undecided: cdt " + domain + ": there is one, but no canonical"));
    }
    const Run limited =
        run({"build", "cdt", domain, "--search-vertices", "7", "-o", folder.path("none.1.ele")});
    CHECK(limited.exit_code == 4);
    CHECK(has(limited.out, "undecided: cdt " + domain + ": there is no canonical one, and "));
    CHECK(has(limited.out, "more than 7 vertices; --search-vertices"));
    CHECK(!std::filesystem::exists(folder.path("none.1.ele")));
  }
}

}  // namespace circumspect::cli
