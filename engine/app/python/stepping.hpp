#pragma once

struct _object;

namespace stepwire::python {

void add_stepping(_object* module);

}  // namespace stepwire::python
