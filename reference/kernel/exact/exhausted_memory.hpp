// What happens when a number needs more memory than there is.
#pragma once

namespace circumspect {

// GMP and MPFR end the process with SIGABRT then; from now on they call `end` instead, which must not return: nothing
// is left that could go on, for both are written in C. The memory is malloc's, as before.
void end_where_numbers_exhaust_memory(void (*end)());

}  // namespace circumspect
