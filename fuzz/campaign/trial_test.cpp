#include "fuzz/campaign/trial.hpp"

#include <doctest/doctest.h>

#include "fuzz/campaign/judge_mesh.hpp"
#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {
namespace {

using Standing = Trial::Standing;

const TriedCase kDead = {OutcomeKind::kExitCode, "exit-code-127",
                         "it ended with exit code 127: \"none\"", "mesher: libmesh.so: none"};
const TriedCase kRight = {OutcomeKind::kHolds};

Trial of(const TriedCase& one, std::size_t times) {
  Trial trial;
  for (std::size_t i = 0; i < times; ++i) trial.look(one);
  return trial;
}

TEST_CASE("a program that fails on ten inputs, whatever came between them, fails the trial") {
  CHECK(of(kDead, 9).standing() == Standing::kOpen);
  Trial trial = of(kDead, 9);
  trial.look({OutcomeKind::kSkipped});
  trial.look({OutcomeKind::kRefused});
  trial.look({OutcomeKind::kFlaky});
  TriedCase flat = kRight;
  flat.is_trivial = true;
  trial.look(flat);
  CHECK(trial.standing() == Standing::kOpen);
  trial.look(kDead);
  CHECK(trial.standing() == Standing::kFailed);
  CHECK(trial.doubt() ==
        "the program fails on every input of more than one simplex (10 until now): is the command "
        "right? "
        "it ended with exit code 127: \"none\", and said \"mesher: libmesh.so: none\"");
  CHECK(of(kDead, 1).doubt().find("fails on every input (1 until now)") != std::string::npos);
}

TEST_CASE("one input that the program makes a mesh of is enough") {
  Trial trial = of(kDead, 9);
  trial.look(kRight);
  for (int i = 0; i < 20; ++i) trial.look(kDead);
  CHECK(trial.standing() == Standing::kPassed);
  CHECK(trial.doubt().empty());
  // A mesh of the input that breaks a rule is a mesh, too: the program is wrong, and not the
  // command.
  CHECK(of({OutcomeKind::kFails, "delaunay.facet-not-local"}, 1).standing() == Standing::kPassed);
  CHECK(of({OutcomeKind::kKnown, "exit-code-3"}, 1).standing() == Standing::kPassed);
  // A mesh whose indices name no points, or that has another dimension, is not one.
  CHECK(of({OutcomeKind::kFails, "triangulation.unknown-vertex"}, 10).standing() ==
        Standing::kFailed);
  CHECK(of({OutcomeKind::kFails, "simplex.wrong-dimension-extreme"}, 10).standing() ==
        Standing::kFailed);
}

TEST_CASE("files on which the program has failed before say nothing, and nor do silent inputs") {
  TriedCase replayed = kDead;
  replayed.is_replayed = true;
  CHECK(of(replayed, 200).standing() == Standing::kOpen);
  CHECK(of(replayed, 200).doubt().empty());
  CHECK(of({OutcomeKind::kRefused}, 99).standing() == Standing::kOpen);
  CHECK(of({OutcomeKind::kRefused}, 100).standing() == Standing::kPassed);
}

TEST_CASE("a doubt names what is misunderstood, and quotes no first line of a traceback") {
  TriedCase shifted{OutcomeKind::kFails, "triangulation.unknown-vertex"};
  shifted.misunderstanding = "its indices seem to begin at 1";
  Trial trial = of(shifted, 7);
  for (int i = 0; i < 3; ++i) trial.look(kDead);
  CHECK(trial.doubt() ==
        "its indices seem to begin at 1 (7 of the 10 inputs on which the program fails)");
  TriedCase python = kDead;
  python.first_line = "Traceback (most recent call last):";
  CHECK(of(python, 10).doubt().find("Traceback") == std::string::npos);
  TriedCase flat = kDead;
  flat.signature += "-extreme-flat";
  Trial both = of(kDead, 5);
  for (int i = 0; i < 5; ++i) both.look(flat);
  CHECK(both.doubt() == of(kDead, 10).doubt());
  Trial mixed = of(kDead, 4);
  for (int i = 0; i < 6; ++i) mixed.look({OutcomeKind::kNoMesh, "no-mesh", "no mesh"});
  CHECK(mixed.doubt().find("6 of 10 times no-mesh; the first time it ended with exit code 127") !=
        std::string::npos);
}

const PointsCase kSquare = {{{0, 0}, {2, 0}, {0, 2}, {2, 3}}, {}};
const PointsCase kTwoTetrahedra = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 2, 2}}, {}};

std::string of_mesh(const Subject& subject, const Input& input, const std::string& name,
                    const std::string& text) {
  const formats::ScratchFolder folder;
  folder.write(name, text);
  return misunderstanding(subject, input, folder.path(name));
}

TEST_CASE("indices that begin at another number are told where the mesh is right with that") {
  Subject subject;
  const std::string from_1 = "2 4 0\n0 1 2 3 4\n1 2 3 4 5\n";
  CHECK(of_mesh(subject, kTwoTetrahedra, "x.ele", from_1) ==
        "its indices seem to begin at 1, and not at 0, for so its meshes are right; should it be "
        "--first-index 1?");
  CHECK(of_mesh(subject, kTwoTetrahedra, "x.qhull-i", "2\n1 2 3 4\n2 3 4 5\n") ==
        "its indices seem to begin at 1, and not at 0, for so its meshes are right");
  // A correct mesh; one with an index out of range that no shift fixes; and one that is wrong even
  // when shifted.
  CHECK(of_mesh(subject, kTwoTetrahedra, "x.ele", "2 4 0\n0 0 1 2 3\n1 1 2 3 4\n").empty());
  CHECK(of_mesh(subject, kTwoTetrahedra, "x.ele", "2 4 0\n0 0 1 2 3\n1 1 2 3 5\n").empty());
  CHECK(of_mesh(subject, kTwoTetrahedra, "x.ele", "2 4 0\n0 1 2 3 4\n1 1 2 3 5\n").empty());
  subject.first_index = 1;
  CHECK(of_mesh(subject, kTwoTetrahedra, "x.ele", from_1).empty());
  CHECK(of_mesh(subject, kTwoTetrahedra, "x.ele", "2 4 0\n1 0 1 2 3\n2 1 2 3 4\n") ==
        "its indices seem to begin at 0, and not at 1, for so its meshes are right; should it be "
        "--first-index 0?");
}

TEST_CASE("answers in another dimension are told") {
  Subject subject;
  CHECK(of_mesh(subject, kTwoTetrahedra, "x.ele", "2 3 0\n0 0 1 2\n1 1 2 3\n") ==
        "the inputs are in space, the program answers in the plane, with simplices of 3 vertices; "
        "should it be --dimension 2?");
  subject.dimension = 2;
  const std::string in_space =
      "the inputs are in the plane, the program answers in space, with simplices of 4 vertices; "
      "should it be --dimension 3?";
  CHECK(of_mesh(subject, kSquare, "x.ele", "1 4 0\n0 0 1 2 3\n") == in_space);
  CHECK(of_mesh(subject, kSquare, "x.qhull-i", "1\n0 1 2 3\n") == in_space);
  CHECK(of_mesh(subject, kSquare, "x.ele", "2 3 0\n0 0 1 2\n1 1 2 3\n").empty());
  CHECK(of_mesh(subject, kSquare, "x.ele", "nonsense\n").empty());
}

TEST_CASE("a mesh of a domain whose indices begin at another number is told, too") {
  Subject subject;
  subject.claim = Claim::kSteinerCdt;
  subject.dimension = 2;
  ComplexCase whole;
  whole.input.points = {{0, 0}, {2, 0}, {0, 2}};
  whole.input.segments = {{0, 1}, {1, 2}, {0, 2}};
  const std::string head = "nOFF\n2\n3 1 0\n0 0\n2 0\n0 2\n";
  CHECK(of_mesh(subject, whole, "x.off", head + "3 1 2 3\n") ==
        "its indices seem to begin at 1, and not at 0, for so its meshes are right");
  CHECK(of_mesh(subject, whole, "x.off", head + "3 0 1 2\n").empty());
}

}  // namespace
}  // namespace circumspect::campaign
