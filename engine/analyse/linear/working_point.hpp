#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "engine/analyse/linear/prepared_diagram.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::linear {

/// Ring buffer in the states of a sampled block: row `age` is counted from the row at the index.
struct Circle {
  std::size_t index = 0;  ///< Offset of the index.
  std::size_t first = 0;  ///< Offset of the rows.
  std::size_t rows = 1, width = 1;
};

/// A state as a column of the system: its place, or its age in a ring buffer.
struct StatePlace : Place {
  bool continuous = true;
  bool may_count = false;  ///< True for a possible counter or flag: a discrete state without a unit.
  bool own = false;        ///< True if no file can set it.
  int circle = -1;         ///< Index of the ring buffer; -1: none.
  std::size_t age = 0, element = 0;
};

/// An instant of a run whose numbers can be perturbed, to get the columns of its linear system.
class WorkingPoint {
 public:
  /// Runs to the time and cuts the wires. Throws Error if the run ends before.
  WorkingPoint(const PreparedDiagram& diagram, const Request& request);

  const std::vector<StatePlace>& states() const { return states_; }
  const std::vector<Place>& inputs() const { return diagram_.inputs; }
  const std::vector<Place>& outputs() const { return diagram_.outputs; }
  bool sampled() const { return sampled_; }
  std::int64_t base_ticks() const { return base_ticks_; }
  double time() const { return diagram_.plan.time_of(point_.tick); }
  const std::vector<TakenDelay>& delays() const { return diagram_.delays; }
  /// Returns a number of the workspace at the point.
  double number(std::size_t offset);
  const Paths& paths() const { return paths_; }
  /// Returns the counters and flags of sampled blocks on the paths, which keep their values.
  const std::vector<std::string>& counts() const { return counts_; }

  /// Returns the value of a column: the states, then the inputs.
  double value(std::size_t column) const;
  void set(std::size_t column, double value);
  /// Returns the largest change of a column; 1/16 for possible counters, so that they round to the count.
  double most_change(std::size_t column) const;
  /// Returns the derivatives or next values of the states, then the outputs, for a number in one column.
  Eigen::VectorXd respond(std::size_t column, double value);
  void step_to_next_sample();
  Eigen::VectorXd respond();
  std::size_t columns() const { return states_.size() + inputs().size(); }
  void remove_state(std::size_t state) {
    states_.erase(states_.begin() + static_cast<std::ptrdiff_t>(state));
  }

 private:
  /// Returns the offset of a column, and the number to write there for this value.
  std::pair<std::size_t, double> written(std::size_t column, double value) const;
  void run_to(double time, const Request& request);
  void leave_start();
  void cut();
  void find_states();
  void add_state(std::size_t block, std::size_t state);
  bool is_count(const StateSpec& spec, const plan::SignalSlot& slot) const;
  void find_circles(std::size_t block);
  std::size_t offset_of(const StatePlace& state, const double* values) const;

  const PreparedDiagram& diagram_;
  Paths paths_;
  bool sampled_ = false;
  std::int64_t base_ticks_ = 1;
  std::unique_ptr<run::Executor> run_;  ///< Executor that steps from the point.
  run::Workspace point_;
  std::vector<double> carried_;  ///< Signals in the wires of the inputs, without perturbation.
  std::vector<double> later_;    ///< Numbers of the point a base period later.
  std::vector<StatePlace> states_;
  std::vector<std::string> counts_;
  std::vector<Circle> circles_;
};

}  // namespace stepwire::linear
