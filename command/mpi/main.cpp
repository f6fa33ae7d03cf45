// circumspect-mpi: the check of meshes of points, on as many ranks as mpirun starts.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include "command/options/one_of.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "kernel/exact/number.hpp"
#include "oracle/distributed/judge.hpp"
#include "oracle/distributed/mpi.hpp"
#include "oracle/distributed/slices.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"

namespace {

namespace cli = circumspect::cli;
using circumspect::Claim;
using circumspect::cli::ExitCode;
using circumspect::distributed::Judged;
using circumspect::distributed::Phase;
using circumspect::distributed::Ranks;

struct MpiOptions {
  circumspect::distributed::Files files;
  Claim claim = Claim::kDelaunay;
  circumspect::check::Options check;
  bool statistics = false;
  std::string format = "text";
};

void add_options(CLI::App& app, MpiOptions& options) {
  app.name("circumspect-mpi");
  app.set_version_flag("--version", "circumspect-mpi " CIRCUMSPECT_VERSION);
  app.footer(
      "Example:\n"
      "  mpirun -n 4 circumspect-mpi mesh.npy --points points.npy\n\n"
      "Exit codes and what is said: as of circumspect check, for any number of ranks.");
  const std::map<std::string, Claim> claims = {{"triangulation", Claim::kTriangulation},
                                               {"delaunay", Claim::kDelaunay},
                                               {"weighted-delaunay", Claim::kWeightedDelaunay}};
  cli::add_options(
      app,
      {{"mesh", "", cli::required(options.files.mesh),
        "The mesh: .ele (points in the .node beside it), or .npy (with --points)"},
       {"--points", "FILE", cli::into(options.files.points),
        "The file with the points: .npy or .node"},
       {"--indices", "FILE", cli::into(options.files.indices),
        "A mesh in parts, one for each rank: the file that says which point of the whole each "
        "point of a part is. In the names of all three files %d stands for the rank"},
       {"--claim", "triangulation|delaunay|weighted-delaunay",
        cli::into(options.claim, cli::one_of(claims)),
        "The claim to judge (default: delaunay). Weights are the first attribute of a .node file"},
       {"--max-errors", "N", cli::into(options.check.max_violations, cli::whole_number()),
        "Report at most N witnesses (default: 20; 0: all)"},
       {"--threads", "N", cli::into(options.check.threads, cli::whole_number(1, 1024)),
        "Threads of each rank (default: 1)"},
       {"--format", "text|json", cli::into(options.format, cli::one_of_words({"text", "json"})),
        "How the verdict is printed (default: text)"},
       {"--statistics", "", cli::flag(options.statistics),
        "Also print, to standard error, what each phase cost each rank"}});
}

void print(std::FILE* to, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), to);
  std::fflush(to);
}
ExitCode say(ExitCode code, const std::string& message) {
  print(stderr, "circumspect-mpi: " + circumspect::on_one_line(message) + "\n");
  return code;
}

std::string document(circumspect::report::Json results) {
  return circumspect::report::document_text(
      {{"circumspect", 1}, {"results", circumspect::report::Json::array({std::move(results)})}});
}

// A row for each phase of each rank.
void print_statistics(Ranks& ranks) {
  const std::vector<int> counts = ranks.of_each(static_cast<int>(ranks.phases().size()));
  const std::vector<Phase> phases = ranks.at_first(ranks.phases());
  if (!ranks.is_first()) return;
  std::string text =
      "| rank | phase | seconds | bytes sent | messages | memory, bytes |\n"
      "| ---: | --- | ---: | ---: | ---: | ---: |\n";
  std::size_t i = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    for (int phase = 0; phase < counts[rank]; ++phase, ++i) {
      const Phase& one = phases[i];
      text += fmt::format("| {} | {} | {:.3f} | {} | {} | {} |\n", rank, one.name.data(),
                          one.seconds, one.bytes_sent, one.messages, one.memory);
    }
  }
  print(stderr, text);
}

// What is printed at the first rank.
std::string said(const Judged& judged, const MpiOptions& options) {
  namespace report = circumspect::report;
  if (options.format == "json") {
    return document(report::verdict(*judged.verdict, judged.named, options.files.mesh,
                                    circumspect::check::By::kLemma));
  }
  const auto note =
      report::note_of_domain_not_given(*judged.verdict, judged.named, options.files.mesh);
  std::string notes;
  for (const auto& one :
       {note, report::note_of_claim_complex(*judged.verdict, options.files.mesh)}) {
    if (one) notes += "note: " + circumspect::on_one_line(*one) + "\n";
  }
  return circumspect::on_lines(
      report::explanation(*judged.verdict, judged.named) + notes +
      report::verdict_line(*judged.verdict, judged.named, options.files.mesh) + "\n");
}

// One line on standard error, and in JSON what circumspect check has there.
ExitCode say_of_mesh(const MpiOptions& options, const std::string& message) {
  if (options.format == "json") {
    print(stdout, document({{"mesh", options.files.mesh}, {"error", message}}));
  }
  return say(ExitCode::kInputFault, message);
}

ExitCode judge(Ranks& ranks, MpiOptions& options) {
  options.files.weighted = options.claim == Claim::kWeightedDelaunay;
  auto read = read_slices(ranks, options.files);
  if (!read) {
    return ranks.is_first() ? say_of_mesh(options, read.error()) : ExitCode::kInputFault;
  }
  const circumspect::Vertex first_index = read->dealt.first_index;
  const Judged judged = judge(ranks, options.claim, std::move(read->dealt), options.check);
  ExitCode code = judged.holds ? ExitCode::kHolds : ExitCode::kFails;
  if (judged.equal.count > 0) {
    code = ExitCode::kInputFault;
    if (ranks.is_first()) {
      say_of_mesh(options, read->points_name + ": " +
                               fault_of_equal_points(judged.equal, first_index,
                                                     "run circumspect check --duplicates merge"));
    }
  } else if (ranks.is_first()) {
    print(stdout, said(judged, options));
    if (std::ferror(stdout) != 0) {
      code = say(ExitCode::kInternalError, "could not write to standard output");
    }
  }
  if (options.statistics) print_statistics(ranks);
  return ranks.of_rank(0, code);
}

// What mpirun gave a rank, and which program took it.
std::string own_words(int argc, char** argv) {
  std::string words = "circumspect-mpi " CIRCUMSPECT_VERSION ":";
  for (int i = 1; i < argc; ++i) words += fmt::format(" '{}'", argv[i]);
  return words;
}

// mpirun can start each rank with other words. A rank that judges another claim, or none at all,
// would meet the others with answers to questions that they did not ask. So nothing begins before
// all are known to be asked the same.
bool are_told_the_same(Ranks& ranks, const std::string& own) {
  const std::string expected = ranks.of_rank(0, own);
  const std::size_t other = ranks.first_with(own != expected);
  if (other == ranks.size()) return true;
  const std::string found = ranks.of_rank(other, own);
  if (ranks.is_first()) {
    say(ExitCode::kUsage, fmt::format("expected the same program and arguments on all ranks; rank "
                                      "0 has {}, but rank {} has {}",
                                      expected, other, found));
  }
  return false;
}

ExitCode run(int argc, char** argv) {
  circumspect::distributed::MpiCommunicator communicator(MPI_COMM_WORLD);
  Ranks ranks(communicator);
  if (!are_told_the_same(ranks, own_words(argc, argv))) return ExitCode::kUsage;
  CLI::App app{
      "Judges a mesh of points, each rank reading and keeping a part of it, as circumspect check "
      "does: exactly, with the same witnesses."};
  MpiOptions options;
  options.check.threads = 1;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool is_fault = error.get_exit_code() != 0;  // no --help, no --version
    if (ranks.is_first()) {
      if (!is_fault) {
        app.exit(error);
      } else {
        say(ExitCode::kUsage, error.what());
        print(stderr, "Run with --help for more information.\n");
      }
    }
    return is_fault ? ExitCode::kUsage : ExitCode::kHolds;
  }
  return judge(ranks, options);
}

[[noreturn]] void end_without_memory() {
  MPI_Abort(MPI_COMM_WORLD, static_cast<int>(say(ExitCode::kInternalError, "out of memory")));
  std::abort();
}

}  // namespace

// What one rank cannot go on with ends all of them, with one line: they would wait for it.
int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  circumspect::end_where_numbers_exhaust_memory(end_without_memory);
  auto code = ExitCode::kInternalError;
  try {
    code = run(argc, argv);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const circumspect::distributed::FileChanged& changed) {
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(say(ExitCode::kInputFault, changed.what())));
  } catch (const std::exception& error) {
    const std::string text = std::string("internal error, please report it: ") + error.what();
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(say(code, text)));
  }
  MPI_Finalize();
  return static_cast<int>(code);
}
