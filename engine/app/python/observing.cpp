#include "engine/app/python/observing.hpp"

#include <pybind11/pybind11.h>

#include <functional>
#include <map>
#include <mutex>
#include <vector>

#include "engine/app/python/faults.hpp"
#include "engine/app/python/numbers.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

/// Run as its Python observer sees it, valid during the observer's calls only, and the values to set before
/// the next tick.
class Seen {
 public:
  explicit Seen(Model model) : model_(std::move(model)) {}

  void open(const Running& run) { run_ = &run; }
  void close() { run_ = nullptr; }
  const Running& run() const {
    if (run_) return *run_;
    throw std::runtime_error("a run can be looked at during a call of its observer alone");
  }
  py::object signal(const std::string& name) const {
    const NamedSignal signal = find_signal(model_, name);
    return py::reinterpret_steal<py::object>(numbers_of(model_, signal, run()[signal.id]));
  }
  void set(const std::string& name, const py::object& value) {
    static_cast<void>(run());
    if (py::isinstance<py::str>(value))
      waiting.push_back([name, text = value.cast<std::string>()](Running& run) { run.set(name, text); });
    else
      waiting.push_back([name, number = value.cast<double>()](Running& run) { run.set(name, number); });
  }
  void write(const std::string& name, const py::object& value) {
    static_cast<void>(run());
    const InputId input = model_.input(name);
    waiting.push_back([input, numbers = numbers_in(value.ptr(), model_.inputs()[input.index])](Running& run) {
      run.set(input, std::span<const double>(numbers));
    });
  }
  void stop() {
    static_cast<void>(run());
    stops = true;
  }

  std::vector<std::function<void(Running&)>> waiting;
  bool stops = false;

 private:
  Model model_;
  const Running* run_ = nullptr;
};

Held method_of(const py::object& object, const char* name) {
  return py::hasattr(object, name) ? Held(py::object(object.attr(name)).release().ptr()) : Held();
}

}  // namespace

struct PythonObserver::Shown {
  std::shared_ptr<Seen> seen;
  Held object;
};

struct PythonObserver::State {
  Held begin, before_tick, evaluated, row, end;
  std::mutex mutex;
  std::map<std::size_t, Shown> shown;  ///< by run index
};

PythonObserver::PythonObserver(_object* object, Model model, Raised& raised)
    : model_(std::move(model)), raised_(raised), state_(std::make_unique<State>()) {
  const auto of = py::reinterpret_borrow<py::object>(object);
  state_->begin = method_of(of, "begin");
  state_->before_tick = method_of(of, "before_tick");
  state_->evaluated = method_of(of, "evaluated");
  state_->row = method_of(of, "row");
  state_->end = method_of(of, "end");
  for (const Held* method :
       {&state_->begin, &state_->before_tick, &state_->evaluated, &state_->row, &state_->end})
    if (*method) return;
  if (!PyCallable_Check(object))
    throw py::type_error(
        "an observer is called, or has one of the methods begin, before_tick, evaluated, row and end");
  state_->evaluated = Held::one_more(object);
}

PythonObserver::~PythonObserver() = default;

/// Returns the entry of a run. References to elements of a std::map stay valid.
PythonObserver::Shown& PythonObserver::shown_of(const Running& run) {
  const std::lock_guard lock(state_->mutex);
  Shown& shown = state_->shown[run.index()];
  if (!shown.seen) shown.seen = std::make_shared<Seen>(model_);
  return shown;
}

void PythonObserver::call(const Held& method, const Running& run) {
  if (!method || raised_.any()) return;
  Shown& shown = shown_of(run);
  const Lock lock;
  shown.seen->open(run);
  if (!shown.object) shown.object = Held(py::cast(shown.seen).release().ptr());
  const Held said(PyObject_CallOneArg(method.get(), shown.object.get()));
  shown.seen->close();
  if (!said) raised_.keep();
}

bool PythonObserver::set_waiting(Shown& shown, Running& run) {
  try {
    for (const auto& set : std::exchange(shown.seen->waiting, {})) set(run);
    return true;
  } catch (const yaml::Error& error) {
    const Lock lock;
    set_error(error, nullptr);
    raised_.keep();
    return false;
  }
}

void PythonObserver::begin(const Running& run) {
  call(state_->begin, run);
}

Flow PythonObserver::before_tick(Running& run) {
  call(state_->before_tick, run);
  if (raised_.any()) return Flow::stop;
  Shown& shown = shown_of(run);
  if (shown.seen->stops) return Flow::stop;
  return shown.seen->waiting.empty() || set_waiting(shown, run) ? Flow::go_on : Flow::stop;
}

void PythonObserver::evaluated(const Running& run) {
  call(state_->evaluated, run);
}

void PythonObserver::row(const Running& run, std::size_t recording, std::span<const double> numbers) {
  if (!state_->row || raised_.any()) return;
  Shown& shown = shown_of(run);
  const Lock lock;
  try {
    shown.seen->open(run);
    const auto row = py::reinterpret_borrow<py::object>(state_->row.get());
    row(shown.seen, recording, py::reinterpret_steal<py::object>(numbers_of(numbers)));
  } catch (py::error_already_set& error) {
    error.restore();
    raised_.keep();
  }
  shown.seen->close();
}

void PythonObserver::end(const Running& run) {
  call(state_->end, run);
}

void add_observing(_object* module) {
  py::class_<Seen, std::shared_ptr<Seen>>(module, "Running", "A run during a call of its observer.")
      .def_property_readonly(
          "index", [](const Seen& seen) { return seen.run().index(); }, "Among the runs of a sweep, from 0.")
      .def_property_readonly(
          "tick", [](const Seen& seen) { return seen.run().tick(); }, "From 0.")
      .def_property_readonly(
          "time", [](const Seen& seen) { return seen.run().time(); }, "[s]")
      .def("__getitem__", &Seen::signal,
           "The numbers of a signal at this tick, SI: a float, or an array (n,) or (m, n); of an element, "
           "'x.2' "
           "or 'R.1.2', a float.")
      .def("set", &Seen::set, py::arg("name"), py::arg("value"),
           "Sets a parameter or a value of a block from the next tick on: a number in SI, or a text with its "
           "unit.")
      .def("write", &Seen::write, py::arg("input"), py::arg("numbers"),
           "Writes an input of the diagram from the next tick on, SI.")
      .def("stop", &Seen::stop, "Ends the run before its next tick; what is recorded is kept.");
}

}  // namespace stepwire::python
