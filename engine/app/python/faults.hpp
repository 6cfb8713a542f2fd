#pragma once

#include "engine/base/yaml/error.hpp"
#include "engine/simulate/run/run_fault.hpp"

struct _object;

namespace stepwire::python {

/// Translates Error and EnvironmentError into the Python exceptions of these names.
void add_faults(_object* module);

/// Raises stepwire.Error with these faults in the interpreter; `cause` is its __cause__ or nullptr.
void set_error(const yaml::Error& error, _object* cause);

/// Returns a new reference to a list of tuples (file, line, column, subject, text, cure, used_by).
_object* fault_tuples(const std::vector<yaml::Fault>& faults);

}  // namespace stepwire::python
