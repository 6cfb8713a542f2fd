#pragma once

struct _object;

namespace stepwire::python {

/// Adds the classes `Simulation` and `Snapshot`.
void add_stepping(_object* module);

}  // namespace stepwire::python
