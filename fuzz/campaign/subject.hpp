// The program under test: how it is called, what it reads and writes, what is claimed of it.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/process/process.hpp"
#include "oracle/model/verdict.hpp"
#include "reference/kernel/piecewise_linear/filling.hpp"

namespace circumspect::campaign {

// The program runs in an empty folder that holds its input and nothing else. In its arguments,
// {points} and {domain} stand for the path of the input, {mesh} for that of the mesh, {folder} for
// the folder.
struct Subject {
  std::vector<std::string> command;   // command[0]: an absolute path
  std::string input_name = "x.node";  // in the folder; its extension says the format
  std::string mesh_name = "x.ele";    // likewise: where the program writes the mesh
  bool reads_stdin = false;           // the input is its standard input (and in the folder)
  bool writes_stdout = false;         // the mesh is its standard output, as if it were that file
  Claim claim = Claim::kDelaunay;
  std::size_t dimension = 3;
  Vertex first_index = 0;       // of the points of the input
  Fill fill = Fill::kEnclosed;  // of a domain: which part of it is to be meshed
  bool merges_coplanar =
      false;  // the mesh is held against the domain with polygons of one plane joined
  bool full_dimension = false;                  // skip points that lie in a hyperplane
  std::set<int> refusal_codes = {};             // exit codes that say: not an input for me
  std::vector<std::string> refusal_texts = {};  // what it prints when it says so
  Limits limits = {};
  std::optional<Containment> containment = {};  // without it, the strongest that there is
  double judging_seconds = 100;                 // how long it may take to judge one mesh

  bool is_about_domains() const { return is_about_a_domain(claim); }
};

// The arguments with everything in place. `paths` of: the folder, the input, the mesh.
struct Paths {
  std::string folder;
  std::string input;
  std::string mesh;
};
std::vector<std::string> filled_in(const Subject& subject, const Paths& paths);

// Does an argument of the command hold this placeholder, braces and all?
bool mentions(const std::vector<std::string>& command, const std::string& placeholder);

}  // namespace circumspect::campaign
