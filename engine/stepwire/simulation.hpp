#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <stepwire/model.hpp>
#include <stepwire/snapshot.hpp>

#include "engine/simulate/run/execution_mode.hpp"

namespace stepwire {

using run::ExecutionMode;

struct SimulationOptions {
  ExecutionMode engine = ExecutionMode::interpreted;  ///< automatic is as compiled here
  /// Names that set() will set; compiled code goes on to be used after these alone.
  std::vector<std::string> tuned{};
};

/// A run of a model, tick by tick, with the file's own values in place of a sweep. Keeps the model alive.
/// Between two steps it shows the numbers of the tick that was computed last. step() neither allocates nor
/// locks; one thread at a time may use a simulation.
class Simulation {
 public:
  /// Stands before time 0, all signals 0. Throws Error for a name in `tuned` that nothing has.
  explicit Simulation(Model model, const SimulationOptions& options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Sets a parameter ("rig.mass"), a value of a block ("spring.gain") or an initial value from the next tick
  /// on; a number is SI, a text has its unit. Throws Error where the value is refused, and where it changes
  /// sizes, rates or wires; nothing is changed then. Allocates.
  void set(const std::string& name, double value);
  void set(const std::string& name, const std::string& text);
  /// Writes an input from the next tick on, until it is written again; the numbers are SI. Throws Error where
  /// there are not as many as the input has, or one is NaN.
  void set(InputId input, double value);
  void set(InputId input, std::span<const double> values);
  void set(InputId input, std::initializer_list<double> values) {
    set(input, std::span(values.begin(), values.size()));
  }

  /// Computes the next tick: that of time 0 at first. Throws Error where a block or the solver ends the run
  /// for a fault, and where the run has ended.
  void step();
  /// Has the last tick been computed, or the file's `stop_when` come true, or a fault ended the run?
  bool finished() const;
  /// Of the tick that is shown [s]; 0 before the first one.
  double time() const;
  /// The numbers of a signal at that tick, in SI; valid until the next call that changes the simulation.
  std::span<const double> operator[](SignalId signal) const;

  Snapshot snapshot();
  /// Returns to a moment of this simulation or of another one of the same model.
  void restore(const Snapshot& snapshot);
  /// Stands before time 0 again, with the parameters that are set; inputs have their defaults.
  void reset();

  /// Is the next tick computed by compiled code?
  bool compiled() const;
  /// Why there is none although it was chosen; empty where there is.
  const std::string& compile_problem() const;
  const Model& model() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stepwire
