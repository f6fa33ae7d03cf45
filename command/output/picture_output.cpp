#include "command/output/picture_output.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/picture/picture.hpp"

namespace circumspect::cli {

void add_page_option(CLI::App& command, std::string& html, const std::string& what) {
  command
      .add_option(
          "--html", html,
          "Also write a page that shows " + what + "; it opens in any browser, without a network")
      ->option_text("FILE");
}

std::string page_fault(const std::string& html, std::vector<Written> others,
                       const std::vector<std::string>& read) {
  if (html == "-") return "expected a file for --html, found -";
  if (!html.empty()) others.push_back({"the page", html});
  return overwriting_fault(others, read);
}

void write_page(const std::string& html, const picture::Page& page, Output& output) {
  if (html.empty()) return;
  const std::string fault = write_file(html, [&page](std::ostream& out) { page.write(out); });
  if (!fault.empty()) output.error(ExitCode::kUsage, "html", html, fault);
}

void add_picture_options(CLI::App& command, PictureOptions& options) {
  command
      .add_option(
          "--html", options.html,
          "Also write a page that shows each witness as a picture; it opens in any browser, "
          "without a network")
      ->option_text("FILE");
  command
      .add_option(
          "--vtu", options.vtu,
          "Also write the witnesses as cells with the number of their rule, for ParaView (.vtu) or "
          "Gmsh (.msh)")
      ->option_text("FILE");
}

std::string picture_fault(const PictureOptions& options, std::size_t meshes) {
  if (options.html == "-") return "expected a file for --html, found -";
  if (!options.vtu) return "";
  const std::string extension = formats::extension(*options.vtu);
  if (extension != ".vtu" && extension != ".msh") {
    return fmt::format("expected a file .vtu or .msh for --vtu, found {}", *options.vtu);
  }
  if (meshes != 1) return fmt::format("expected one mesh beside --vtu, found {}", meshes);
  return "";
}

std::vector<Written> picture_files(const PictureOptions& options) {
  std::vector<Written> files;
  if (options.html) files.push_back({"the page", *options.html});
  if (options.vtu) files.push_back({"the cells", *options.vtu});
  return files;
}

void Pictures::add(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name,
                   report::Json report, const Domain* domain, const std::vector<std::string>& notes,
                   Output& output) {
  has_verdict_ = true;
  if (options_.html) page_.add(verdict, mesh, mesh_name, std::move(report), domain, notes);
  if (!options_.vtu) return;
  if (mesh.dimension() > 3) {
    output.error(ExitCode::kUsage, "vtu", *options_.vtu,
                 fmt::format("{}: expected points of at most 3 coordinates for --vtu, found {}",
                             mesh_name, mesh.dimension()));
    return;
  }
  const auto format = formats::extension(*options_.vtu) == ".msh" ? picture::CellFormat::kGmsh
                                                                  : picture::CellFormat::kVtu;
  const std::string fault = write_file(*options_.vtu, [&](std::ostream& out) {
    picture::write_cells(out, format, verdict, mesh, domain);
  });
  if (!fault.empty()) output.error(ExitCode::kUsage, "vtu", *options_.vtu, fault);
}

void Pictures::finish(Output& output) const {
  if (has_verdict_) write_page(options_.html.value_or(""), page_, output);
}

}  // namespace circumspect::cli
