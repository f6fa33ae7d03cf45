#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/point_sets.hpp"
#include "bench/tables.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "inputs/dice.hpp"
#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"

namespace circumspect::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCases = 400;
constexpr std::size_t kPoints = 12;
constexpr int kAlternations = 5;
constexpr double kAllowed = 1.2;  // times what the program takes alone
constexpr std::uint64_t kSeed = 20260101;

// A folder in memory where there is one, gone at the end.
class Folder {
 public:
  Folder() {
    if (access("/dev/shm", W_OK) == 0) path_ = "/dev/shm/circumspect-bench-XXXXXX";
    if (mkdtemp(path_.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), path_);
    }
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_ = "/tmp/circumspect-bench-XXXXXX";
};

double wall_seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Runs the command and waits for it, as cheaply as a program can.
class Spawner {
 public:
  explicit Spawner(const std::string& folder) {
    posix_spawn_file_actions_init(&actions_);
    for (int file = 0; file < 3; ++file) {
      posix_spawn_file_actions_addopen(&actions_, file, "/dev/null", O_RDWR, 0);
    }
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }
  ~Spawner() { posix_spawn_file_actions_destroy(&actions_); }
  Spawner(const Spawner&) = delete;
  Spawner& operator=(const Spawner&) = delete;

  void run(std::vector<std::string> command) {
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    pid_t process = 0;
    const int error =
        posix_spawn(&process, arguments[0], &actions_, nullptr, arguments.data(), environ);
    if (error != 0) throw std::system_error(error, std::generic_category(), command.front());
    waitpid(process, nullptr, 0);
  }

 private:
  posix_spawn_file_actions_t actions_;
};

// The program alone, once on each input; the files are written before the clock starts.
double alone(const campaign::Subject& subject, const std::vector<campaign::Input>& inputs) {
  const Folder folder;
  std::vector<std::vector<std::string>> commands;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string own = folder.path() + "/" + std::to_string(i);
    const campaign::Paths paths{folder.path(), own + ".node", own + subject.mesh_name.substr(1)};
    std::ofstream(paths.input) << *campaign::file_text(inputs[i], ".node", 0, subject.dimension);
    commands.push_back(campaign::filled_in(subject, paths));
  }
  Spawner spawner(folder.path());
  return wall_seconds([&] {
    for (const auto& command : commands) spawner.run(command);
  });
}

// The whole campaign: with the start of its processes, its journal, and its judging.
double in_campaign(campaign::Plan plan) {
  const Folder folder;
  plan.output = folder.path();
  const std::atomic<bool> stop = false;
  return wall_seconds([&] {
    const auto result = campaign::run(plan, stop, [](const campaign::Progress&) {});
    if (!result) throw std::runtime_error(result.error());
    if (result->cases != kCases || !result->findings.empty()) {
      throw std::runtime_error("expected a program that is right on every input, found findings");
    }
  });
}

// The first inputs of the family that span space, from this seed on.
campaign::Input drawn_uniform(std::uint64_t seed) {
  const generators::Family& uniform = *generators::find_family("uniform");
  while (true) {
    generators::PointsCase set =
        generators::in_doubles(generators::drawn(uniform, 3, {kPoints}, seed));
    if (PointSet(set.points).dimension() == 3) return set;
    seed = generators::mixed(seed);
  }
}

std::vector<campaign::Input> inputs_of(const campaign::Plan& plan) {
  std::vector<campaign::Input> inputs;
  for (const campaign::Replayed& replayed : plan.replayed) inputs.push_back(replayed.input);
  for (std::size_t i = 0; i < plan.cases.value_or(0); ++i) {
    inputs.push_back(plan.sources.front().drawn(campaign::seed_of_case(plan.seed, i)));
  }
  return inputs;
}

campaign::Plan replaying(campaign::Plan plan) {
  const std::vector<Point> points = random_in_cube(kCases * kPoints, 3);
  for (auto first = points.begin(); first != points.end(); first += kPoints) {
    plan.replayed.push_back({"", campaign::PointsCase{{first, first + kPoints}, {}}});
  }
  return plan;
}

campaign::Plan drawing(campaign::Plan plan) {
  plan.sources = {{"uniform", drawn_uniform}};
  plan.cases = kCases;
  return plan;
}

// Returns whether the campaign is fast enough. Minima, for other work on the machine only ever
// adds.
bool time_one(const std::string& inputs_name, const campaign::Plan& plan) {
  const std::vector<campaign::Input> inputs = inputs_of(plan);
  double least_alone = std::numeric_limits<double>::max();
  double least_campaign = std::numeric_limits<double>::max();
  for (int i = 0; i < kAlternations; ++i) {
    least_alone = std::min(least_alone, alone(plan.subject, inputs));
    least_campaign = std::min(least_campaign, in_campaign(plan));
  }
  const double ratio = least_campaign / least_alone;
  fmt::print("| {} | {} | {:.2f} ms | {:.2f} ms | {:.2f} | {} |\n", inputs_name, kCases,
             1000 * least_alone / kCases, 1000 * least_campaign / kCases, ratio, kAllowed);
  std::fflush(stdout);
  return ratio <= kAllowed;
}

}  // namespace

int time_campaigns(const std::string& wanted, const Program& program) {
  const std::string name = "campaign";
  if (name.find(wanted) == std::string::npos) return 0;
  campaign::Plan plan;
  plan.subject.command = program.command;
  plan.subject.command.front() = campaign::find_program(program.command.front());
  plan.subject.mesh_name = program.mesh;
  plan.seed = kSeed;
  plan.goes_on = true;  // what is timed need not be right
  fmt::print("\n");
  if (plan.subject.command.front().empty()) {
    fmt::print("campaign: there is no program {} here\n", program.command.front());
    return 0;
  }
  fmt::print("| campaign of {}, 1 job | cases | alone | campaign | ratio | allowed |\n",
             fmt::join(program.command, " "));
  fmt::print("| --- | ---: | ---: | ---: | ---: | ---: |\n");
  int too_slow = 0;
  if (!time_one(fmt::format("replayed, {} points", kPoints), replaying(plan))) ++too_slow;
  if (!time_one(fmt::format("drawn, at most {} points", kPoints), drawing(plan))) ++too_slow;
  return too_slow;
}

}  // namespace circumspect::bench
