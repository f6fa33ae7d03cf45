// Folders as programs under test leave them.
#include "fuzz/process/folders.hpp"

#include <filesystem>
#include <fstream>

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kAny = std::uint64_t{1} << 40;

// Folders in each other, made from within: their path is longer than any that may be said.
void make_nested(const std::string& folder, int depth) {
  const fs::path back = fs::current_path();
  fs::current_path(folder);
  for (int i = 0; i < depth; ++i) {
    REQUIRE(mkdir("nested-folder", 0700) == 0);
    std::ofstream("moved-0") << "a file";
    REQUIRE(chdir("nested-folder") == 0);
  }
  fs::current_path(back);
}

TEST_CASE("bytes of a folder: on disk, of each entry some, of deep ones enough") {
  const formats::ScratchFolder folder;
  CHECK(bytes_in(folder.path(""), kAny) == 0);
  folder.write("empty", "");
  CHECK(bytes_in(folder.path(""), kAny) == kEntryBytes);
  fs::create_directory(folder.path("a"));
  folder.write("a/large", std::string(100'000, 'x'));
  CHECK(bytes_in(folder.path(""), kAny) >= 100'000 + 2 * kEntryBytes);
  CHECK(bytes_in(folder.path(""), kAny) < 150'000);
  fs::create_directory_symlink("/usr", folder.path("link"));
  CHECK(bytes_in(folder.path(""), kAny) < 150'000);
  fs::resize_file(folder.path("empty"), 1 << 30);  // a sparse file
  CHECK(bytes_in(folder.path(""), kAny) < 150'000);
  make_nested(folder.path("a"), kDeepest + 2);
  CHECK(bytes_in(folder.path(""), kAny) == kAny);
  CHECK(bytes_in("/nowhere", kAny) == 0);
}

TEST_CASE("whatever is in a folder is deleted, and nothing outside of it") {
  const formats::ScratchFolder folder;
  fs::create_directories(folder.path("precious"));
  folder.write("precious/file", "precious");
  chmod(folder.path("precious").c_str(), 0750);
  const std::string work = folder.path("work");
  fs::create_directories(work + "/a/b");
  folder.write("work/file", "x");
  fs::create_directory_symlink(folder.path("precious"), work + "/a/link");
  REQUIRE(mkfifo((work + "/pipe").c_str(), 0600) == 0);
  make_nested(work, 1500);
  chmod((work + "/a").c_str(), 0);
  chmod(work.c_str(), 0);
  CHECK(emptied(work));
  CHECK(fs::is_empty(work));
  CHECK(fs::status(work).permissions() == fs::perms::owner_all);
  CHECK(removed(work));
  CHECK(!fs::exists(work));
  CHECK(removed(work));
  fs::create_directory_symlink(folder.path("precious"), work);
  CHECK(!emptied(work));
  CHECK(removed(work));
  CHECK(fs::exists(folder.path("precious/file")));
  struct stat status {};
  CHECK(stat(folder.path("precious").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777U) == 0750U);
}

}  // namespace
}  // namespace circumspect::campaign
