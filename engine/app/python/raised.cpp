#include "engine/app/python/raised.hpp"

#include <pybind11/pybind11.h>

namespace stepwire::python {

namespace py = pybind11;

void Raised::keep() {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  if (value && trace) PyException_SetTraceback(value, trace);
  const Held kind(type), place(trace);
  latest_ = Held(value);
  if (!any_.exchange(true)) exception_ = Held::one_more(value);
}

Held Raised::take() {
  any_ = false;
  latest_ = Held();
  return std::move(exception_);
}

void Raised::throw_if_any() {
  if (!any_) return;
  const Held exception = take();
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.get())), exception.get());
  throw py::error_already_set();
}

}  // namespace stepwire::python
