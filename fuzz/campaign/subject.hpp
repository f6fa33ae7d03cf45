// The program under test: how it is called, what it reads and writes, and the claim about its
// meshes.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/process/process.hpp"
#include "inputs/relations.hpp"
#include "inputs/updates.hpp"
#include "oracle/domain/filling.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::campaign {

// Replaces every `part` of the text by `by`, from left to right; replaced text is not searched
// again. Requires: `part` is not empty.
inline void replace_all(std::string& text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + by.size())) {
    text.replace(at, part.size(), by);
  }
}

// The program runs in a folder that holds only its input. In its arguments, {points} and {domain}
// stand for the path of the input, {mesh} for that of the mesh, {folder} for the folder.
struct Subject {
  std::vector<std::string> command;   // command[0]: an absolute path
  std::string input_name = "x.node";  // in the folder; its extension determines the format
  std::string mesh_name = "x.ele";    // the same for the mesh that the program writes
  bool reads_stdin = false;           // the input is its standard input (and in the folder)
  bool writes_stdout = false;         // the mesh is its standard output, as if it were that file
  std::optional<Talk> talk = {};      // it is a worker; then both of the above hold
  // The updates to a worker's structure before it answers; empty: none.
  std::set<generators::UpdateKind> updates = {};
  Claim claim = Claim::kDelaunay;
  std::size_t dimension = 3;
  Vertex first_index = 0;       // of the points of the input
  Fill fill = Fill::kEnclosed;  // for a domain: which part of it must be meshed
  bool merges_coplanar =
      false;  // the mesh is compared with the domain with coplanar polygons joined
  // Untidy domains; their meshes are compared with their arrangements (arrangement.hpp).
  bool is_untidy = false;
  bool full_dimension = false;                  // skip points that lie in a hyperplane
  std::set<int> refusal_codes = {};             // exit codes that say: not an input for me
  std::vector<std::string> refusal_texts = {};  // text that it prints to say so
  Limits limits = {};
  std::optional<Containment> containment = {};  // by default, the strongest available
  double judging_seconds = 100;                 // how long it may take to judge one mesh

  // Relations under which it must be as right as before, each tried on each input.
  std::set<generators::Relation> relations = {};
  // Another program, called in the same way, that gets each input on which this one is right or
  // which it refuses.
  std::vector<std::string> against = {};

  // The user's texts for issue.md: the program's version and how it was built; what its documents
  // promise.
  std::string about = {};
  std::string promise = {};

  bool is_about_domains() const { return is_about_a_domain(claim); }
};

// The arguments with all placeholders replaced. `paths`: of the folder, the input and the mesh.
struct Paths {
  std::string folder;
  std::string input;
  std::string mesh;
};
std::vector<std::string> filled_in(const Subject& subject, const Paths& paths);

// Does an argument of the command hold this placeholder, braces and all?
bool mentions(const std::vector<std::string>& command, const std::string& placeholder);

}  // namespace circumspect::campaign
