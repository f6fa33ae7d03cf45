// OCaml's standard library refers to hypot, which no checker calls, and glibc gave that name a new
// version in 2.35. The same value under an older name lets the program start on older systems.
#include <complex.h>

double __wrap_hypot(double x, double y) { return cabs(CMPLX(x, y)); }
