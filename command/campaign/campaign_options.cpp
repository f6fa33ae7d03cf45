#include "command/campaign/campaign_options.hpp"

#include <CLI/CLI.hpp>

#include "command/options/one_of.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/quantity.hpp"
#include "command/options/whole_number.hpp"
#include "oracle/formats/format.hpp"

namespace circumspect::cli {
namespace {

using generators::Relation;
using generators::Untidiness;
using generators::UpdateKind;

CLI::Validator update_words() {
  return one_of<UpdateKind>({{"insert", UpdateKind::kInsert},
                             {"delete", UpdateKind::kDelete},
                             {"restore", UpdateKind::kRestore}});
}

CLI::Validator relation_words() {
  return one_of<Relation>({{"order", Relation::kOrder},
                           {"translation", Relation::kTranslation},
                           {"reflection", Relation::kReflection},
                           {"scaling", Relation::kScaling},
                           {"repetition", Relation::kRepetition}});
}

CLI::Validator untidiness_words() {
  return one_of<Untidiness>({{"touching", Untidiness::kTouching},
                             {"crossing", Untidiness::kCrossing},
                             {"overlapping", Untidiness::kOverlapping},
                             {"repetition", Untidiness::kRepetition}});
}

CLI::Validator containment_words() {
  return one_of<campaign::Containment>({{"namespaces", campaign::Containment::kNamespaces},
                                        {"supervisor", campaign::Containment::kSupervisor}});
}

// How the program is called.
std::vector<OptionRow> rows_of_calls(SubjectOptions& options) {
  return {
      {"command", "", required(options.command),
       "The program and its arguments, after --. In them, {points} or {domain} stands for the "
       "input file, {mesh} for the file of the mesh, and {folder} for the folder of both. The "
       "program runs in that folder. A path to a file of yours still works if it has a slash, such "
       "as ./script.py"},
      {"--points", "NAME", into(options.points_name),
       "The name of the file from which the program reads the points (default: x.node). Its "
       "extension selects the format: .node, .qhull, .off, .json, or .xyz with one line of "
       "coordinates for each point"},
      {"--domain", "NAME", into(options.domain_name),
       "The name of the file from which the program reads a domain (default: x.poly): .poly, .geo "
       "for Gmsh, or for domains that are surfaces .off, .obj, .ply, .stl or .msh"},
      {"--mesh", "NAME", into(options.mesh_name),
       "The name of the file to which the program writes the mesh (default: x.ele). {mesh} stands "
       "for this name; if the program chooses the name itself, give that one, such as x.1.ele for "
       "tetgen. Its extension selects the format: " +
           formats::endings_of(&formats::Format::has_mesh)},
      {"--stdin", "", flag(options.reads_stdin), "The program reads the input from stdin"},
      {"--stdout", "", flag(options.writes_stdout), "The program writes the mesh to stdout"},
      {"--worker", "", flag(options.is_worker),
       "The program is a worker: it reads one case after another from stdin, and answers each on "
       "stdout. circumspect adapter LANGUAGE prints one to begin with. For domains, and with "
       "--mesh x.off or x.tet, its answers are such files"},
      {"--worker-cases", "N", into(options.worker_cases, whole_number(1, 1'000'000'000)),
       "Start a new worker after N cases (default: 1000)"},
      {"--updates", "insert,delete,restore", listed(options.updates, update_words()),
       "The worker keeps a structure that changes: before it answers, it inserts and deletes "
       "points, and with restore it writes the structure and reads it again. A case then has a "
       "seventh count, the number of updates"},
      {"--first-index", "0|1", into(options.first_index, whole_number(0, 1)),
       "The index of the first point (default: 0)"}};
}

// Which inputs it gets, and which of them it may refuse.
std::vector<OptionRow> rows_of_inputs(SubjectOptions& options) {
  return {{"--dimension", "D", into(options.dimension, whole_number(1, 8)),
           "The dimension of the points (default: 3)"},
          {"--full-dimension", "", flag(options.full_dimension),
           "Skip points that all lie in one hyperplane, and domains with such points"},
          {"--refusal-exit-code", "N", into(options.refusal_codes, whole_number(0, 255)),
           "The program refuses an input by this exit code, which is not a failure. May be given "
           "several times"},
          {"--refusal-text", "TEXT", into(options.refusal_texts),
           "The program refuses an input by this text in its output, which is not a failure. May "
           "be given several times"},
          {"--metamorphic", "order,translation,reflection,scaling,repetition",
           listed(options.relations, relation_words()),
           "Also try each input in a changed form: in another order, moved, reflected or scaled "
           "(all exactly), or with points that come twice. If the program was right, it must be "
           "right again; if it refused the input, it must refuse it again"},
          {"--untidy", "touching,crossing,overlapping,repetition",
           listed(options.untidiness, untidiness_words()),
           "Draw domains whose segments touch, cross, overlap or go through polygons, and whose "
           "vertices come twice. The meshes are judged against the exact arrangement. No polygons "
           "cross"},
          {"--against", "COMMAND", into(options.against),
           "Another program with its arguments, as one word, which is called in the same way with "
           "the same inputs. Your program fails if it refuses an input that the other gets right, "
           "or makes another mesh where only one is Delaunay"}};
}

std::vector<OptionRow> rows_of_limits(SubjectOptions& options) {
  return {
      {"--limit-time", "TIME", duration(options.seconds),
       "Limit the time of one run (default: 10s)"},
      {"--limit-memory", "SIZE", size_in_bytes(options.memory),
       "Limit the address space of each process of the program (default: 4G). 0 sets no limit, "
       "which programs built with AddressSanitizer need"},
      {"--limit-output", "SIZE", size_in_bytes(options.output),
       "Limit the output of the program, in each file and in all together (default: 64M)"},
      {"--limit-processes", "N", into(options.processes, whole_number(1, 1'000'000)),
       "Limit the number of its processes at a time (default: 256)"},
      {"--limit-judging", "TIME", duration(options.judging_seconds),
       "Limit the time for judging one of its meshes (default: ten times --limit-time)"},
      {"--containment", "namespaces|supervisor", into(options.containment, containment_words()),
       "Keep the processes of the program together in a process namespace, from which they see no "
       "other process, or by a supervisor that searches for them (default: namespaces where the "
       "system allows them)"},
      {"--minimize-time", "TIME", duration(options.minimise_seconds),
       "Stop making an input smaller after this time (default: 120s)"},
      {"--minimize-runs", "N", into(options.minimise_tries, whole_number()),
       "Stop making an input smaller after N runs (default: 50000)"}};
}

}  // namespace

void add_subject_options(CLI::App& command, SubjectOptions& options) {
  add_options(command, rows_of_calls(options));
  add_claim_option(
      command, options.claim,
      "The claim that every mesh must fulfil (default: delaunay; for domains steiner-cdt)");
  add_domain_options(command, options.said);
  add_options(command, rows_of_inputs(options));
  add_options(command, rows_of_limits(options));
}

}  // namespace circumspect::cli
