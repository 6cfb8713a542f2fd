#pragma once

#include "engine/base/yaml/error.hpp"
#include "engine/simulate/run/run_fault.hpp"

struct _object;

namespace stepwire::python {

/// Lets Error and EnvironmentError be the exceptions of these names in the module's Python part.
void add_faults(_object* module);

/// Sets stepwire.Error with these faults in the interpreter, caused by another exception or by none.
void set_error(const yaml::Error& error, _object* cause);

/// A new reference to a tuple (file, line, column, subject, text, cure, used_by) of each.
_object* fault_tuples(const std::vector<yaml::Fault>& faults);

}  // namespace stepwire::python
