#pragma once

struct _object;

namespace stepwire {
class Registry;
}

namespace stepwire::python {

/// Adds the class `File` with the operations of a session on a loaded file: run, fit, tune, study, linearize.
void add_calls(_object* module);

/// Adds the function `load`, which returns a `File`. Diagrams may use the given blocks.
void add_loading(_object* module, Registry (*blocks)());

}  // namespace stepwire::python
