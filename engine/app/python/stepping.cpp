#include "engine/app/python/stepping.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>

#include "engine/app/python/faults.hpp"
#include "engine/app/python/loaded_file.hpp"
#include "engine/app/python/numbers.hpp"
#include "engine/base/math/floating_point.hpp"
#include "engine/stepwire/simulation.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

/// Simulation that allows one call at a time. A concurrent call, or a call from a method of one of its own
/// blocks, is refused.
class Stepping {
 public:
  Stepping(const std::shared_ptr<LoadedFile>& of, const std::string& engine,
           const std::vector<std::string>& tuned)
      : raised_(of->kinds()->raised), simulation_(begun(of, engine, tuned)) {}

  void step(std::int64_t ticks) {
    if (ticks < 0) throw py::value_error("a simulation steps forward: ticks >= 0");
    const Use use(*this);
    try {
      const Unlocked unlocked;
      for (std::int64_t tick = 0; tick < ticks; ++tick) simulation_.step();
    } catch (const yaml::Error& error) {
      const Held cause = raised_->take();
      set_error(error, cause.get());
      throw py::error_already_set();
    }
  }
  py::object signal(const std::string& name) {
    const Use use(*this);
    const Model& model = simulation_.model();
    const NamedSignal signal = find_signal(model, name);
    return py::reinterpret_steal<py::object>(numbers_of(model, signal, simulation_[signal.id]));
  }
  void set(const std::string& name, const py::object& value) {
    const Use use(*this);
    if (py::isinstance<py::str>(value))
      simulation_.set(name, value.cast<std::string>());
    else
      simulation_.set(name, value.cast<double>());
  }
  void write(const std::string& name, const py::object& value) {
    const Use use(*this);
    const InputId input = simulation_.model().input(name);
    const std::vector<double> numbers = numbers_in(value.ptr(), simulation_.model().inputs()[input.index]);
    simulation_.set(input, std::span<const double>(numbers));
  }
  Snapshot snapshot() {
    const Use use(*this);
    return simulation_.snapshot();
  }
  void restore(const Snapshot& snapshot) {
    const Use use(*this);
    try {
      simulation_.restore(snapshot);
    } catch (const std::logic_error& error) {
      throw py::value_error(error.what());
    }
  }
  void reset() {
    const Use use(*this);
    simulation_.reset();
  }
  /// Gives access for reading; no other thread interferes while the caller holds the interpreter lock.
  const Simulation& simulation() {
    const Use use(*this);
    return simulation_;
  }

 private:
  static Simulation begun(const std::shared_ptr<LoadedFile>& of, const std::string& engine,
                          const std::vector<std::string>& tuned) {
    const UsualFloatingPoint usual;
    return Simulation(
        LoadedFile::library_model(of),
        {engine == "interpreted" ? ExecutionMode::interpreted : ExecutionMode::compiled, tuned});
  }

  /// Guard of one call, which also sets the usual floating-point state.
  class Use {
   public:
    explicit Use(Stepping& of) : of_(of) {
      if (of_.used_.exchange(true))
        throw std::runtime_error("the simulation is in another call; one at a time may use it");
    }
    ~Use() { of_.used_ = false; }

   private:
    UsualFloatingPoint usual_{};
    Stepping& of_;
  };

  std::shared_ptr<Raised> raised_;
  std::atomic<bool> used_ = false;
  Simulation simulation_;
};

void add_looks(py::class_<Stepping>& stepping) {
  stepping
      .def_property_readonly(
          "time", [](Stepping& of) { return of.simulation().time(); },
          "Of the tick that is shown [s]; 0 before the first one.")
      .def_property_readonly(
          "finished", [](Stepping& of) { return of.simulation().finished(); },
          "Has the last tick been computed, or has something ended the run?")
      .def_property_readonly(
          "compiled", [](Stepping& of) { return of.simulation().compiled(); },
          "Is the next tick computed by compiled code?")
      .def_property_readonly(
          "compile_problem", [](Stepping& of) { return of.simulation().compile_problem(); },
          "Why there is no compiled code although it was chosen.");
}

}  // namespace

void add_stepping(_object* module) {
  py::class_<Snapshot>(module, "Snapshot", "A moment of a simulation, to return to as often as needed.");
  py::class_<Stepping> stepping(module, "Simulation", "A run of a model, tick by tick; the numbers are SI.");
  add_looks(stepping);
  stepping
      .def(
          py::init<const std::shared_ptr<LoadedFile>&, const std::string&, const std::vector<std::string>&>())
      .def("step", &Stepping::step, py::arg("ticks") = 1,
           "Computes the next tick, at first that of time 0, or so many. Raises Error where a block or the "
           "solver\n"
           "ends the run, and where it has ended.")
      .def("__getitem__", &Stepping::signal, py::arg("signal"),
           "The numbers of a signal at the tick that is shown, SI: a float, or a new array (n,) or (m, n); "
           "of an "
           "element, 'x.2' or 'R.1.2', a float.")
      .def("set", &Stepping::set, py::arg("name"), py::arg("value"),
           "Sets a parameter ('rig.mass') or a value of a block ('spring.gain') from the next tick on: a "
           "number in\n"
           "SI, or a text with its unit. Raises Error where it is refused; nothing is changed then.")
      .def("_write", &Stepping::write, py::arg("input"), py::arg("numbers"))
      .def("snapshot", &Stepping::snapshot, "This moment, without the parameters.")
      .def("restore", &Stepping::restore, py::arg("snapshot"),
           "Returns to a moment of a simulation of this model; parameters stay as they are set.")
      .def("reset", &Stepping::reset, "Stands before time 0 again; inputs have their defaults.");
}

}  // namespace stepwire::python
