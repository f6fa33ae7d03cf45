// Writes witnesses as pictures: --html FILE and --vtu FILE.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/output/output.hpp"
#include "command/output/overwriting.hpp"
#include "oracle/picture/page.hpp"

namespace circumspect::cli {

struct PictureOptions {
  std::optional<std::string> html;  // a page
  std::optional<std::string> vtu;   // cells: .vtu or .msh
};

// --html FILE, of a command whose page shows something else than verdicts: `what`, "each breach of
// a domain as a picture".
void add_page_option(CLI::App& command, std::string& html, const std::string& what);

// Why the page cannot be written beside what is read; empty if it can, and if there is none.
std::string page_fault(const std::string& html, std::vector<Written> others,
                       const std::vector<std::string>& read);

// Writes it, if there is to be one. A file that cannot be written is said on stderr and in the exit
// code.
void write_page(const std::string& html, const picture::Page& page, Output& output);

void add_picture_options(CLI::App& command, PictureOptions& options);

// What is wrong with these options beside so many meshes; empty if they are all right.
std::string picture_fault(const PictureOptions& options, std::size_t meshes);

// The files that they name, for overwriting_fault.
std::vector<Written> picture_files(const PictureOptions& options);

// Collects verdicts, and writes the files at the end. A file that cannot be written is said on
// stderr and in the exit code.
class Pictures {
 public:
  explicit Pictures(const PictureOptions& options) : options_(options) {}

  bool are_wanted() const { return options_.html || options_.vtu; }
  // `report`: as Page::add takes it. The cells are written at once.
  void add(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name,
           report::Json report, const Domain* domain, const std::vector<std::string>& notes,
           Output& output);
  // Writes the page, unless nothing was judged.
  void finish(Output& output) const;

 private:
  PictureOptions options_;
  picture::Page page_;
  bool has_verdict_ = false;
};

}  // namespace circumspect::cli
