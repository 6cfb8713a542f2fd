#include <pybind11/pybind11.h>

#include "blocks/register.hpp"
#include "engine/app/python/calls.hpp"
#include "engine/app/python/faults.hpp"
#include "engine/app/python/found.hpp"
#include "engine/app/python/observing.hpp"
#include "engine/app/python/results.hpp"
#include "engine/app/python/stepping.hpp"
#include "engine/app/report/results.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/stepwire/generate.hpp"

PYBIND11_MODULE(_core, module) {
  namespace python = stepwire::python;
  module.doc() = "What the Python part of stepwire stands on: sessions and the library.";
  python::add_faults(module.ptr());
  python::add_results(module.ptr());
  python::add_found(module.ptr());
  python::add_calls(module.ptr());
  python::add_loading(module.ptr(), stepwire::blocks);
  python::add_observing(module.ptr());
  python::add_stepping(module.ptr());
  module.def("note_package", stepwire::io::note_package);
  module.def("version", stepwire::version);
  module.def("results", [] { return stepwire::report::results_description().text(-1); });
}
