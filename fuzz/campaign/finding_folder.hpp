// Writes the folder of a finding, which has everything that is needed to reproduce it.
#pragma once

#include <optional>
#include <string>

#include "fuzz/campaign/runner.hpp"

namespace circumspect::campaign {

// The origin of a finding.
struct Origin {
  std::string family;
  std::size_t case_number = 0;
  std::uint64_t seed = 0;  // of the campaign
};

// OUTPUT/findings, or OUTPUT itself if findings is its name.
std::string findings_folder(const std::string& output);

// The folder of a signature, in that one.
std::string finding_folder(const std::string& output, const std::string& signature);

// Makes the folder and writes the input as it was found: input.node (or input.poly), and in the
// program's own format if that is another. All of it is on the disk when this returns. Throws
// std::system_error, also if the folder holds files that no campaign has written. Links are not
// followed.
void write_input(const std::string& folder, const Subject& subject, const Input& input);

// Adds the smallest input (and its image, if the program fails on that), the program's output for
// it, the verdict, README.txt, issue.md, versions.txt and reproduce.sh, by-hand.py if numbers show
// what is wrong, and picture.svg if there is something to see. `runner` has just run the program on
// it, with this outcome.
void write_minimal(const std::string& folder, const Subject& subject, const Origin& origin,
                   const Input& found, const Input& minimal, const Outcome& outcome,
                   const Runner& runner);

// Do the folder and its subfolders contain only plain files? Someone may have put a pipe there, for
// which a reader would wait for ever, or a link that leads elsewhere.
bool holds_files_alone(const std::string& folder);

// The input that write_minimal wrote there, to continue from; nothing if it cannot be read, or if
// the folder holds anything but files.
std::optional<Input> read_minimal(const std::string& folder, const Subject& subject);

// A shell script that runs the program on minimal.* beside it, or on image.*, the changed input,
// and judges what it writes.
std::string reproduction(const Subject& subject, const Input& minimal, const Outcome& outcome);

// The text as one word of a shell.
std::string quoted_for_shell(const std::string& text);

// The name of the program and its arguments, as a person would type them.
std::string command_line(const Subject& subject);

// The picture in issue.md.

// The first witness of a verdict as an SVG: its simplices, its face, the cell of the domain and,
// ringed, the vertices that it names, with the user's indices. Positions are computed exactly,
// relative to these, and rounded only then. Empty: no rule is broken, the points have neither two
// nor three coordinates, or fewer than three of them, or more than a hundred, would be drawn.
std::string witness_picture(const report::Json& verdict);

}  // namespace circumspect::campaign
