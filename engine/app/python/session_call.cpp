#include "engine/app/python/session_call.hpp"

#include <pybind11/pybind11.h>

#include "engine/app/python/watched_call.hpp"

namespace stepwire::python {

namespace py = pybind11;

run::ExecutionMode mode_of(const std::string& engine) {
  if (engine == "interpreted") return run::ExecutionMode::interpreted;
  return engine == "compiled" ? run::ExecutionMode::compiled : run::ExecutionMode::automatic;
}

SessionCall::SessionCall(File of, _object* observers, _object* progress)
    : file_(std::move(of)),
      model_(LoadedFile::library_model(file_)),
      progress_(progress == Py_None ? nullptr : progress) {
  if (!observers) return;
  for (const py::handle observer : py::reinterpret_borrow<py::list>(observers)) {
    observers_.push_back(std::make_unique<PythonObserver>(observer.ptr(), model_, raised_));
    shown_.push_back(std::make_unique<Shown>(model_.content(), *observers_.back()));
  }
}

void SessionCall::show(double fraction, const std::string& what, std::atomic<bool>& interrupt) {
  if (raised_.any()) return;
  const Lock lock;
  const Held said(PyObject_CallFunction(progress_, "ds", fraction, what.c_str()));
  if (said) return;
  raised_.keep();
  interrupt = true;
}

void SessionCall::watch(session::Monitor& monitor, std::atomic<bool>& interrupt) {
  monitor.interrupt = &interrupt;
  monitor.diagnostic = [this](const std::string& text) {
    const std::lock_guard lock(mutex_);
    notes_.push_back(text);
  };
  if (progress_)
    monitor.progress = [&](double fraction, const std::string& what) { show(fraction, what, interrupt); };
  for (const auto& shown : shown_) monitor.observers.push_back(shown.get());
}

void SessionCall::make(const std::function<void(session::Session&)>& act) {
  call_watched(
      [&](std::atomic<bool>& interrupt) {
        auto session = file_->take_session();
        watch(session->monitor(), interrupt);
        act(*session);
        file_->give_back(std::move(session));
      },
      raised_);
}

}  // namespace stepwire::python
