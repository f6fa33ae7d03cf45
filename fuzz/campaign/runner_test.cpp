#include "fuzz/campaign/runner.hpp"

#include <chrono>
#include <filesystem>
#include <thread>

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {

namespace {

Subject shell(const std::string& script) {
  Subject subject;
  subject.command = {"/bin/sh", "-c", script, "{points}", "{mesh}"};
  return subject;
}

const PointsCase kTetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};

TEST_CASE("a mesh is judged by the points of the input") {
  const Subject right = shell("echo '1 4 0\n0 0 1 2 3' > $1");
  Runner runner(right);
  CHECK(runner.run(kTetrahedron).kind == OutcomeKind::kHolds);
  const Subject wrong = shell("echo '1 4 0\n0 0 1 2 2' > $1");
  Runner other(wrong);
  const Outcome outcome = other.run(kTetrahedron);
  CHECK(outcome.kind == OutcomeKind::kFails);
  CHECK(outcome.signature == "simplex.repeated-vertex");
}

TEST_CASE("a mesh that lists its points must have those of the input, in any order") {
  const std::string head = "echo 'MeshVersionFormatted 2 Dimension 3 Vertices 4 ";
  const std::string tail = " Tetrahedra 1 1 2 3 4 0 End' > x.mesh";
  Subject subject = shell(head + "0 0 1 0  0 1 0 0  1 0 0 0  0 0 0 0" + tail);
  subject.mesh_name = "x.mesh";
  CHECK(Runner(subject).run(kTetrahedron).kind == OutcomeKind::kHolds);
  subject.command[2] = head + "0 0 1 0  0 1 0 0  1 0 0 0  0 0 0.5 0" + tail;
  CHECK(Runner(subject).run(kTetrahedron).signature == "other-points");
}

TEST_CASE("what is flat is told apart, skipped or refused") {
  Subject subject = shell("echo 'all points are coplanar'; exit 3");
  const PointsCase flat = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {}};
  CHECK(Runner(subject).run(flat).signature == "exit-code-3-flat");
  CHECK(Runner(subject).run(kTetrahedron).signature == "exit-code-3");
  subject.full_dimension = true;
  CHECK(Runner(subject).run(flat).kind == OutcomeKind::kSkipped);
  subject.full_dimension = false;
  subject.refusal_texts = {"are coplanar"};
  CHECK(Runner(subject).run(flat).kind == OutcomeKind::kRefused);
}

TEST_CASE("numbers that no double reaches, as making others small tries them, are skipped") {
  const Subject subject = shell("exit 3");
  const Rational huge("1" + std::string(400, '0'));
  for (const Rational& far : {huge, Rational(-huge), Rational(1 / huge)}) {
    PointsCase set = kTetrahedron;
    set.points[0][0] = far;
    CHECK(Runner(subject).run(set).kind == OutcomeKind::kSkipped);
  }
}

// A worker: `script` is run for each case, when $count and $dimension have been read, and $points
// lines.
Subject worker(const std::string& script) {
  Subject subject = shell(
      "while read count dimension rest; do points=''; i=0; while [ $i -lt $count ]; do read line; "
      "points=\"$points/$line\"; i=$((i+1)); done; " +
      script + "; done");
  subject.talk = {Talk::Form::kSimplices, 100};
  subject.input_name = "x.case";
  subject.mesh_name = "answer.qhull-i";
  subject.reads_stdin = subject.writes_stdout = true;
  subject.limits.seconds = 5;
  return subject;
}

TEST_CASE("the answers of a worker are judged as the files of programs are") {
  const Subject right =
      worker("[ \"$points\" = '/0 0 0/1 0 0/0 1 0/0 0 1' ] && echo 1 && echo 3 0 1 2");
  Runner runner(right);
  for (int i = 0; i < 3; ++i) CHECK(runner.run(kTetrahedron).kind == OutcomeKind::kHolds);
  const Subject wrong = worker("echo 1; echo 0 1 2 2");
  CHECK(Runner(wrong).run(kTetrahedron).signature == "simplex.repeated-vertex");
  const Subject refusing = worker("echo 'error: not \"this\"' | tr -d :");
  const Outcome refused = Runner(refusing).run(kTetrahedron);
  CHECK(refused.kind == OutcomeKind::kRefused);
  CHECK(refused.text == "\"not \"this\"\"");
  const Subject with_points = [] {
    Subject subject =
        worker("echo 4 vertices; echo 1 tets; echo \"${points#/}\" | tr / '\\n'; echo 4 0 1 2 3");
    subject.mesh_name = "answer.tet";
    subject.talk->form = Talk::Form::kTet;
    return subject;
  }();
  Runner other(with_points);
  for (int i = 0; i < 3; ++i) CHECK(other.run(kTetrahedron).text == "");
}

TEST_CASE("what is not an answer says what was expected and found") {
  const auto text_of = [](const std::string& script) {
    const Subject subject = worker(script);
    Runner runner(subject);
    // In a process of its own, and in one that keeps running.
    const Outcome first = runner.run(kTetrahedron);
    const Outcome second = runner.run(kTetrahedron);
    CHECK(first.text == second.text);
    CAPTURE(second.text);
    CHECK(second.kind == OutcomeKind::kUnreadable);
    return second.text;
  };
  CHECK(text_of("echo Hello; sleep 0.2").find("found \"Hello\"") != std::string::npos);
  CHECK(text_of("echo 2; echo 0 1 2 3; exit").find("expected facet 2 of 2, found the end") !=
        std::string::npos);
  CHECK(text_of("printf '1\\n0 1 2 3\\n4 5 6 7\\n'; sleep 0.2").find("found \"4\"") !=
        std::string::npos);
  Subject slow = worker("echo 2; echo 0 1 2 3; sleep 100");
  slow.limits.seconds = 0.2;
  Runner runner(slow);
  CHECK(runner.run(kTetrahedron).kind == OutcomeKind::kHang);
  CHECK(runner.run(kTetrahedron).text ==
        "it ran longer than allowed, and was killed: expected 2 lines of its answer, found 1");
}

TEST_CASE("a worker that is wrong only since it had other cases before is flaky") {
  const Subject subject =
      worker("k=$((k+1)); echo 1; [ $k -lt 3 ] && echo 0 1 2 3 || echo 0 1 2 2");
  Runner runner(subject);
  for (int i = 0; i < 3; ++i) CHECK(runner.run(kTetrahedron).kind == OutcomeKind::kHolds);
  const Outcome wrong = runner.run(kTetrahedron);
  CHECK(wrong.kind == OutcomeKind::kFails);
  const Outcome settled = runner.confirmed(kTetrahedron, wrong);
  CHECK(settled.kind == OutcomeKind::kFlaky);
  CHECK(settled.text.rfind("simplex.repeated-vertex once, and not when it was run again: ", 0) ==
        0);
  const Subject always = worker("echo 1; echo 0 1 2 2");
  CHECK(Runner(always).confirmed(kTetrahedron, wrong).kind == OutcomeKind::kFails);
}

TEST_CASE("the points that are there in the end are those whose mesh is judged") {
  using generators::UpdateKind;
  // (1, 1, 1) is deleted, and a deleted corner comes back.
  const UpdatesCase whole = {
      {{{0, 0, 0}, {1, 1, 1}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}}, {}},
      {{UpdateKind::kDelete, 1},
       {UpdateKind::kRestore},
       {UpdateKind::kDelete, 0},
       {UpdateKind::kInsert, 5}}};
  const std::string text =
      "5 3 0 0 0 0 4\n0 0 0\n1 1 1\n0 1 0\n0 0 1\n1 0 0\n"
      "delete 1\nrestore\ndelete 0\ninsert 0 0 0\n";
  CHECK(file_text(whole, ".case", 0, 3) == text);
  CHECK(file_text(whole, ".node", 0, 3) == "4 3 0 0\n0 0 1 0\n1 0 0 1\n2 1 0 0\n3 0 0 0\n");
  const auto read = read_updates(text);
  REQUIRE(read);
  CHECK(file_text(*read, ".case", 0, 3) == text);
  Subject subject =
      worker("i=0; while [ $i -lt 4 ]; do read line; i=$((i+1)); done; echo 1; echo 0 1 2 3");
  subject.updates = {UpdateKind::kInsert, UpdateKind::kDelete, UpdateKind::kRestore};
  Runner runner(subject);
  CHECK(runner.run(whole).text == "");
  CHECK(runner.run(whole).text == "");
  const Subject late =
      worker("i=0; while [ $i -lt 4 ]; do read line; i=$((i+1)); done; echo 1; echo 1 2 3 4");
  CHECK(Runner(late).run(whole).kind == OutcomeKind::kFails);
}

TEST_CASE("what a program does may not change with what does not count") {
  using generators::Relation;
  Subject subject = shell("grep -q -e ' -' $0 && exit 9; echo '1 4 0\n0 0 1 2 3' > $1");
  subject.refusal_codes = {9};
  CHECK(Runner(subject).run(kTetrahedron).kind == OutcomeKind::kHolds);
  subject.relations = {Relation::kOrder, Relation::kTranslation, Relation::kReflection,
                       Relation::kScaling};
  const Outcome refused = Runner(subject).run(kTetrahedron);
  CHECK(refused.kind == OutcomeKind::kDiffers);
  CHECK(refused.signature == "refused-after-reflection");
  REQUIRE(refused.image);
  CHECK(std::get<PointsCase>(*refused.image).points[1] == Point{-1, 0, 0});
  // It is refused, but not when it is reflected: that is not a proper refusal, either.
  subject.command[2] = "grep -q -e ' -' $0 || exit 9; echo '1 4 0\n0 0 1 2 3' > $1";
  CHECK(Runner(subject).run(kTetrahedron).signature == "refused-after-reflection");
  subject.command[2] = "exit 9";
  CHECK(Runner(subject).run(kTetrahedron).kind == OutcomeKind::kRefused);
  // Wrong unless the points come in this order.
  subject.command[2] =
      "l=2; [ \"$(sed -n 2,4p $0 | tr -d '\\n')\" = '0 0 0 01 1 0 02 0 1 0' ] && l=3; "
      "echo \"1 4 0\n0 0 1 2 $l\" > $1";
  const Outcome wrong = Runner(subject).run(kTetrahedron);
  CHECK(wrong.kind == OutcomeKind::kFails);
  CHECK(wrong.signature == "simplex.repeated-vertex-after-order");
}

TEST_CASE("a program is held against another one that gets it right") {
  const PointsCase kite = {{{0, 0}, {4, -1}, {4, 1}, {8, 0}}, {}};
  const PointsCase square = {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {}};
  const std::string along = "echo '2 3 0\n0 0 1 3\n1 0 2 3' > $1";
  const std::string across = "echo '2 3 0\n0 0 1 2\n1 1 2 3' > $1";
  Subject subject = shell(along);
  subject.dimension = 2;
  subject.claim = Claim::kTriangulation;
  CHECK(Runner(subject).run(kite).kind == OutcomeKind::kHolds);
  subject.against = shell(across).command;
  const Outcome differs = Runner(subject).run(kite);
  CHECK(differs.kind == OutcomeKind::kDiffers);
  CHECK(differs.signature == "other-mesh");
  // Four points on a circle have two Delaunay triangulations.
  subject.command = shell("echo '2 3 0\n0 0 1 3\n1 0 2 3' > $1").command;
  const Outcome either = Runner(subject).run(square);
  CHECK(either.kind == OutcomeKind::kHolds);
  CHECK(either.text == "another mesh than that of sh; both are right");
  subject.command = subject.against;
  CHECK(Runner(subject).run(kite).text == "");
  subject.refusal_codes = {9};
  subject.command[2] = "exit 9";
  CHECK(Runner(subject).run(kite).signature == "refused-alone");
  subject.against[2] = "exit 9";
  CHECK(Runner(subject).run(kite).kind == OutcomeKind::kRefused);
  subject.command[2] = across;
  subject.against[2] = "exit 3";
  Runner runner(subject);
  CHECK(runner.run(kite).text == "sh is wrong: exit-code-3");
  CHECK(runner.said_of_other(kite) == "sh: exit-code-3");
}

TEST_CASE("the mesh of an untidy domain is held against the arrangement") {
  // A square whose diagonals cross in (1, 1).
  ComplexCase whole;
  whole.input.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  whole.input.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}};
  const std::string four =
      "printf 'nOFF 2\\n5 4 0\\n0 0\\n2 0\\n2 2\\n0 2\\n1 1\\n"
      "3 0 1 4\\n3 1 2 4\\n3 2 3 4\\n3 3 0 4\\n' > x.off";
  const std::string two =
      "printf 'nOFF 2\\n4 2 0\\n0 0\\n2 0\\n2 2\\n0 2\\n3 0 1 2\\n3 0 2 3\\n' > x.off";
  Subject subject = shell(four);
  subject.input_name = "x.poly";
  subject.mesh_name = "x.off";
  subject.dimension = 2;
  subject.claim = Claim::kCdt;
  CHECK(Runner(subject).run(whole).kind == OutcomeKind::kSkipped);
  subject.is_untidy = true;
  CHECK(Runner(subject).run(whole).text == "");
  subject.command[2] = two;
  const Outcome lacks = Runner(subject).run(whole);
  CHECK(lacks.kind == OutcomeKind::kFails);
  CHECK(lacks.signature == "domain.vertex-missing");
  // Segments that cross in (2/3, 2/3), which no program can write.
  whole.input.points = {{0, 0}, {2, 0}, {2, 2}, {0, 1}};
  CHECK(Runner(subject).run(whole).text == "segments cross in no double");
}

TEST_CASE(
    "in space: each triangle has its own vertices, and the mesh is held against their "
    "arrangement") {
  ComplexCase soup;
  const std::vector<Point> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const std::vector<std::size_t>& triangle :
       {std::vector<std::size_t>{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
    const auto first = static_cast<Vertex>(soup.input.points.size());
    for (const std::size_t v : triangle) soup.input.points.push_back(corners[v]);
    soup.input.polygons.push_back({{{first, first + 1, first + 2}}, {}});
  }
  Subject subject =
      shell("printf '4 vertices\\n1 tets\\n0 0 0\\n1 0 0\\n0 1 0\\n0 0 1\\n4 0 1 2 3\\n' > x.tet");
  subject.input_name = "x.poly";
  subject.mesh_name = "x.tet";
  subject.claim = Claim::kCdt;
  CHECK(Runner(subject).run(soup).text == "the domain is not valid");
  subject.is_untidy = true;
  CHECK(Runner(subject).run(soup).kind == OutcomeKind::kHolds);
  // A segment from the inside through the floor, with only half of it in the domain: both halves
  // are required.
  soup.input.points.insert(soup.input.points.end(), {{0.25, 0.25, 0.25}, {0.25, 0.25, -0.25}});
  soup.input.segments = {{12, 13}};
  CHECK(Runner(subject).run(soup).signature == "domain.vertex-missing");
  // Polygons that cross are named.
  soup.input.points.push_back({0.5, 0.25, 0.25});
  soup.input.polygons.push_back({{{12, 13, 14}}, {}});
  CHECK(Runner(subject).run(soup).text ==
        "its arrangement is not valid: two polygons cross where they share no segment");
}

TEST_CASE("looking at a domain has the limits of judging, and flat domains can be skipped") {
  ComplexCase whole;
  whole.input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  whole.input.polygons = {{{{0, 1, 3, 2}}, {}}};
  Subject subject = shell("exit 3");
  subject.input_name = "x.poly";
  subject.mesh_name = "x.off";
  subject.claim = Claim::kSteinerCdt;
  subject.fill = Fill::kHull;
  CHECK(Runner(subject).run(whole).signature == "exit-code-3-flat");
  subject.full_dimension = true;
  CHECK(Runner(subject).run(whole).text == "the points lie in a hyperplane");
  whole.input.points[3] = {0, 0, 1};
  whole.input.polygons = {{{{0, 1, 2}}, {}}};
  CHECK(Runner(subject).run(whole).signature == "exit-code-3");
  subject.judging_seconds = 1e-9;
  const Outcome late = Runner(subject).run(whole);
  CHECK(late.kind == OutcomeKind::kSkipped);
  CHECK(late.text == "examining the domain takes longer than 1e-09 s (--limit-judging)");
}

TEST_CASE("no case finds what the one before it left") {
  const Subject subject =
      shell("ls -A . | grep -v x.node && exit 9; mkdir -p a/b; touch a/b/c d; chmod 0 a; exit 0");
  Runner runner(subject);
  for (int i = 0; i < 3; ++i) CHECK(runner.run(kTetrahedron).signature == "no-mesh");
}

TEST_CASE("a program may delete the folder around its own, or put a link or a pipe there") {
  const Subject deleting = shell("cd /; rm -rf \"$(dirname \"$(dirname \"$0\")\")\"");
  Runner runner(deleting);
  for (int i = 0; i < 3; ++i) CHECK(runner.run(kTetrahedron).signature == "no-mesh");
  const Subject linking = shell("cd ..; rm -rf work; ln -s /nowhere work");
  Runner other(linking);
  for (int i = 0; i < 3; ++i) CHECK(other.run(kTetrahedron).signature == "no-mesh");
  const Subject piping = shell("cd ..; rm -f stdout; mkfifo stdout; echo '1 4 0\n0 0 1 2 3' > $1");
  Runner third(piping);
  for (int i = 0; i < 2; ++i) CHECK(third.run(kTetrahedron).kind == OutcomeKind::kHolds);
}

TEST_CASE("a link in the place of the scratch folder leads nobody to what it shows") {
  const formats::ScratchFolder mine;
  std::filesystem::create_directories(mine.path("work"));
  mine.write("work/precious", "precious");
  const Subject linking = shell(
      "scratch=$(dirname \"$(dirname \"$0\")\"); cd /; rm -rf $scratch; "
      "ln -s " +
      mine.path("") + " $scratch");
  {
    Runner runner(linking);
    for (int i = 0; i < 3; ++i) CHECK(runner.run(kTetrahedron).signature == "no-mesh");
  }
  CHECK(std::filesystem::exists(mine.path("work/precious")));
}

TEST_CASE("judging has a limit, an outcome of its own, and can be interrupted") {
  // A million equal simplices: too many to judge in the time.
  Subject subject = shell("echo '1000000 4 0' > $1; seq 0 999999 | sed 's/$/ 0 1 2 3/' >> $1");
  subject.judging_seconds = 0.05;
  const Outcome outcome = Runner(subject).run(kTetrahedron);
  CHECK(outcome.kind == OutcomeKind::kJudgingLimit);
  CHECK(outcome.signature == "judging-limit");
  CHECK(outcome.text == "x.ele: judging it takes longer than 0.05 s (--limit-judging)");
  subject.judging_seconds = 100;
  Runner runner(subject);
  std::thread other([&] {
    while (runner.mesh_file().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    runner.interrupt();
  });
  const auto start = std::chrono::steady_clock::now();
  CHECK(runner.run(kTetrahedron).kind == OutcomeKind::kInterrupted);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
  other.join();
}

TEST_CASE("what is judged apart is judged alike") {
  const auto outcome_of = [](const std::string& before) {
    const Subject subject = shell(before + "echo '1 4 0\n0 0 1 2 2' >> $1");
    return Runner(subject).run(kTetrahedron);
  };
  // Its comment makes it longer than files that are judged in this process.
  const Outcome apart = outcome_of("printf '#%5000s\\n' x > $1; ");
  const Outcome at_once = outcome_of("");
  CHECK(apart.kind == OutcomeKind::kFails);
  CHECK(apart.signature == at_once.signature);
  CHECK(apart.text == at_once.text);
  CHECK(apart.explanation == at_once.explanation);
  CHECK(!apart.verdict["violations"].empty());
  CHECK(apart.verdict == at_once.verdict);
}

TEST_CASE(
    "a program that kills the process that started it is told apart, and no other is blamed") {
  Subject killing = shell("[ -e ../killed ] && exit 3; touch ../killed; kill -9 $PPID");
  killing.containment = Containment::kSupervisor;
  Runner runner(killing);
  CHECK(runner.run(kTetrahedron).signature == "exit-code-3");
  Subject always = shell("kill -9 $PPID; sleep 100");
  always.containment = Containment::kSupervisor;
  CHECK(Runner(always).run(kTetrahedron).signature == "kills-parent");
}

TEST_CASE("what is kept of a run does not hold the path of the scratch folder") {
  const Subject subject = shell("echo \"error: cannot open $0\"; exit 3");
  Runner runner(subject);
  const Outcome outcome = runner.run(kTetrahedron);
  CHECK(outcome.text == "it ended with exit code 3: \"error: cannot open x.node\"");
  CHECK(outcome.explanation == "  error: cannot open x.node\n");
  const Subject colourful = shell("printf 'a\\033[2Jb\\n'; exit 3");
  CHECK(Runner(colourful).run(kTetrahedron).explanation == "  a\\x1b[2Jb\n");
  const Subject unreadable = shell("echo nonsense > $1");
  CHECK(Runner(unreadable).run(kTetrahedron).text.rfind("x.ele:1: expected", 0) == 0);
}

TEST_CASE("a scratch folder is gone with its runner") {
  std::string folder;
  {
    const Subject subject = shell("touch y");
    Runner runner(subject);
    runner.run(kTetrahedron);
    folder = std::filesystem::path(runner.work_folder()).parent_path();
    CHECK(std::filesystem::exists(folder));
  }
  CHECK(!std::filesystem::exists(folder));
}

}  // namespace

}  // namespace circumspect::campaign
