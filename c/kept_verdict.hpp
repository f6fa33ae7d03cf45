// A verdict as the C interface hands it out.
#pragma once

#include <string>
#include <vector>

#include <circumspect/circumspect.h>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::c {

circumspect_options asked_of(const circumspect_options* options);
check::Options options_of(const circumspect_options& asked);
// The distance that `within` names. Refuses what is not a number of at least 0.
Rational distance_of(const char* within);

// Everything that may be asked of the verdict later. The caller owns it.
circumspect_verdict* kept_verdict(const Verdict& found, const Mesh& mesh, const Domain* domain,
                                  const circumspect_options& asked, check::By by,
                                  std::vector<std::string> notes);

}  // namespace circumspect::c
