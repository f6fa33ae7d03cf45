// A number of MPFR. Only sources of this folder include it.
#pragma once

#include <mpfr.h>

namespace circumspect {

// An MPFR number that frees itself.
class Float {
 public:
  explicit Float(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Float() { mpfr_clear(value_); }
  Float(const Float&) = delete;
  Float& operator=(const Float&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

}  // namespace circumspect
