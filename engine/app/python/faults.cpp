#include "engine/app/python/faults.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

py::tuple tuple_of(const yaml::Fault& fault) {
  py::list used_by;
  for (const yaml::Place& place : fault.used_by)
    used_by.append(py::make_tuple(place.file, place.mark.line, place.mark.column));
  return py::make_tuple(fault.place.file, fault.place.mark.line, fault.place.mark.column, fault.subject,
                        fault.message.wrong, fault.message.cure, py::tuple(used_by));
}

void set_environment_error(const std::string& text) {
  const py::object kind = py::module_::import("stepwire.errors").attr("EnvironmentError");
  PyErr_SetObject(kind.ptr(), py::str(text).ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const yaml::Error& error) {
    set_error(error, nullptr);
  } catch (const io::EnvironmentError& error) {
    set_environment_error(error.what());
  } catch (const table::TableError& error) {
    set_error(yaml::Error(yaml::Fault{{}, "", error.what(), {}}), nullptr);
  } catch (const subprocess::ProcessStopped& stopped) {
    PyErr_SetString(PyExc_KeyboardInterrupt, stopped.what());
  }
}

}  // namespace

_object* fault_tuples(const std::vector<yaml::Fault>& faults) {
  py::list all;
  for (const yaml::Fault& fault : faults) all.append(tuple_of(fault));
  return all.release().ptr();
}

void set_error(const yaml::Error& error, _object* cause) {
  const auto faults = py::reinterpret_steal<py::list>(fault_tuples(error.faults()));
  const py::object exception = py::module_::import("stepwire.errors").attr("error_of")(faults);
  if (cause) PyException_SetCause(exception.ptr(), py::reinterpret_borrow<py::object>(cause).release().ptr());
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

void add_faults(_object*) {
  py::register_exception_translator(translate);
}

}  // namespace stepwire::python
