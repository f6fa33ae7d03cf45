// What is demanded beside a claim, in words.
#pragma once

#include "oracle/model/claim.hpp"
#include "oracle/model/options.hpp"

namespace circumspect::c {

// Sets what the words of `demands` ask for: names of options of the command without their dashes,
// separated by blanks, as "manifold oriented=positive". Refuses a word that is none, or that asks
// nothing of the claim. NULL asks for nothing.
void set_demands(const char* demands, Claim claim, check::Options& options);

}  // namespace circumspect::c
