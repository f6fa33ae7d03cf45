// Programs on which the tests run campaigns.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "command/run_command_test.hpp"

namespace circumspect::cli {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

// A folder with a program that is a shell script.
struct Program {
  ScratchFolder folder;
  std::string path;

  explicit Program(const std::string& script) : path(folder.path("program")) {
    folder.write("program", "#!/bin/sh\n" + script);
    fs::permissions(path, fs::perms::owner_all);
  }
  std::string output(const std::string& name = "out") const { return folder.path(name); }

  Arguments campaign(const Arguments& options, const std::string& out = "out") const {
    // What AddressSanitizer reserves is more than any limit: the programs below run this command.
    Arguments all = {"campaign", "--output", output(out), "--limit-memory", "0"};
    all.insert(all.end(), options.begin(), options.end());
    all.insert(all.end(), {"--", path, "{points}", "{mesh}"});
    return all;
  }
  // The signatures for which there are folders.
  std::set<std::string> signatures(const std::string& out = "out") const {
    std::set<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(output(out) + "/findings", none)) {
      names.insert(entry.path().filename());
    }
    return names;
  }
  std::string finding(const std::string& signature, const std::string& file,
                      const std::string& out = "out") const {
    return contents(output(out) + "/findings/" + signature + "/" + file);
  }
};

inline std::string last_line(const std::string& text) {
  const std::size_t start = text.rfind('\n', text.size() - 2);
  return start == std::string::npos ? text : text.substr(start + 1);
}

constexpr const char* kRight =
    "exec " CIRCUMSPECT_COMMAND " build delaunay --quiet --duplicates merge \"$1\" -o \"$2\"\n";

// It forgets its last simplex if there are five points or more.
constexpr const char* kForgetful = R"(
"$CIRCUMSPECT" build delaunay --quiet --duplicates merge "$1" -o whole.ele || exit 9
read n rest < "$1"
[ $n -lt 5 ] && { mv whole.ele "$2"; exit 0; }
awk 'NR == 1 { n = $1 - 1; $1 = n } NR <= n + 1' whole.ele > "$2"
)";

inline std::string forgetful() {
  return "CIRCUMSPECT=" CIRCUMSPECT_COMMAND "\n" + std::string(kForgetful);
}

}  // namespace circumspect::cli
