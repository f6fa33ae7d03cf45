// Draws inputs from families, and makes them small.
#pragma once

#include "python/values.hpp"

namespace circumspect::python {

// The functions of the module that do, ended by one without a name.
PyMethodDef* methods_of_inputs();

}  // namespace circumspect::python
