#pragma once

struct _object;

namespace stepwire {
class Registry;
}

namespace stepwire::python {

/// Adds the class `File` with what a session does with a loaded file: run, fit, tune, study, linearize.
void add_calls(_object* module);

/// Adds `load`, which makes a `File`; its diagrams may use these blocks.
void add_loading(_object* module, Registry (*blocks)());

}  // namespace stepwire::python
