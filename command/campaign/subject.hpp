// The program under test, as the options of campaign and minimize describe it.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "command/campaign/campaign_options.hpp"
#include "fuzz/campaign/subject.hpp"

namespace circumspect::cli {

// A note, for people, on an argument of the command that is also the name of a file; empty if there
// is none.
std::string note_on_names(const SubjectOptions& options);

// The program as it is to be run. Errors: what is wrong with the options, for people; `not_found`
// is set if it is that there is no such program.
tl::expected<campaign::Subject, std::string> subject_of(const SubjectOptions& options,
                                                        bool& not_found);

}  // namespace circumspect::cli
