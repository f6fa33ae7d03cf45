// Runs a fuzz target on files, or on all files of folders, without libFuzzer: for seeds and old
// findings, with any compiler. The file whose input fails is the last one named.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files(int count, char** arguments) {
  std::vector<fs::path> all;
  for (int i = 1; i < count; ++i) {
    if (!fs::is_directory(arguments[i])) {
      all.emplace_back(arguments[i]);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(arguments[i])) {
      if (entry.is_regular_file()) all.push_back(entry.path());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<fs::path> all = files(count, arguments);
  if (all.empty()) {
    std::fprintf(stderr, "expected files or folders with files, found none\n");
    return 2;
  }
  for (const fs::path& path : all) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
      std::fprintf(stderr, "%s: expected a file that can be read\n", path.c_str());
      return 3;
    }
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::printf("%s\n", path.c_str());
    std::fflush(stdout);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("replayed %zu inputs\n", all.size());
  return 0;
}
