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
  ExecutionMode engine = ExecutionMode::interpreted;  ///< automatic is the same as compiled here
  /// Names that set() will set. After set() of any other name, compiled code is no longer used.
  std::vector<std::string> tuned{};
};

/// Run of a model, tick by tick, with the file's own values in place of a sweep. Keeps the model alive.
/// Between two steps it returns the numbers of the last computed tick. step() neither allocates nor locks;
/// only one thread at a time may use a simulation.
class Simulation {
 public:
  /// Creates the run before time 0, with all signals 0. Throws Error for an unknown name in `tuned`.
  explicit Simulation(Model model, const SimulationOptions& options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Sets a parameter ("rig.mass"), a value of a block ("spring.gain") or an initial value from the next tick
  /// on. A number is SI; a text has its unit. Throws Error if the value is refused, or if it changes sizes,
  /// rates or wires; the run is then unchanged. Allocates.
  void set(const std::string& name, double value);
  void set(const std::string& name, const std::string& text);
  /// Writes an input from the next tick on, until it is written again; the numbers are SI. Throws Error for a
  /// wrong count of numbers, and for NaN.
  void set(InputId input, double value);
  void set(InputId input, std::span<const double> values);
  void set(InputId input, std::initializer_list<double> values) {
    set(input, std::span(values.begin(), values.size()));
  }

  /// Computes the next tick; the first one is that of time 0. Throws Error if a fault of a block or the
  /// solver ends the run, and if the run has already ended.
  void step();
  /// True once the last tick is computed, the file's `stop_when` holds, or a fault has ended the run.
  bool finished() const;
  /// Returns the time of the last computed tick [s]; 0 before the first one.
  double time() const;
  /// Returns the numbers of a signal at that tick, in SI; valid until the next call that changes the
  /// simulation.
  std::span<const double> operator[](SignalId signal) const;

  Snapshot snapshot();
  /// Loads a snapshot of this simulation or of another one of the same model.
  void restore(const Snapshot& snapshot);
  /// Returns to before time 0, with the present parameters and the default inputs.
  void reset();

  /// True if compiled code computes the next tick.
  bool compiled() const;
  /// Returns the reason why chosen compiled code is missing; an empty text if it is used.
  const std::string& compile_problem() const;
  const Model& model() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stepwire
