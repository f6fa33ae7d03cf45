// The exceptions of the package, as which the statuses of the C interface arrive in Python.
#pragma once

#include "python/long_calls.hpp"
#include "python/values.hpp"

namespace circumspect::python {

// Makes them: attributes of the module.
void add_exceptions(PyObject* module);

// Throws what a call is refused with. Requires: the module has its exceptions.
void require_ok(const Outcome& outcome);

}  // namespace circumspect::python
