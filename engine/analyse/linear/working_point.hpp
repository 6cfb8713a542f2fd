#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "engine/analyse/linear/paths.hpp"
#include "engine/analyse/linear/prepared_diagram.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::linear {

/// A state of a sampled block whose rows lie in a circle: row `age` behind the one to which an index points.
struct Circle {
  std::size_t index = 0;  ///< offset of the index
  std::size_t first = 0;  ///< offset of the rows
  std::size_t rows = 1, width = 1;
};

/// A state as a column: where it lies, in a circle perhaps, by its age.
struct StatePlace : Place {
  bool continuous = true;
  bool may_count = false;  ///< it may be a counter or a mark, as states without a unit are
  bool own = false;        ///< no file sets it
  int circle = -1;         ///< index of the circle
  std::size_t age = 0, element = 0;
};

/// A moment of a run, with the columns and rows of its linear system as numbers that may be changed and read.
class WorkingPoint {
 public:
  /// Runs to the time, and cuts. Throws Error where the run ends before.
  WorkingPoint(const PreparedDiagram& diagram, const Request& request);

  const std::vector<StatePlace>& states() const { return states_; }
  const std::vector<Place>& inputs() const { return diagram_.inputs; }
  const std::vector<Place>& outputs() const { return diagram_.outputs; }
  bool sampled() const { return sampled_; }
  std::int64_t base_ticks() const { return base_ticks_; }
  double time() const { return diagram_.plan.time_of(point_.tick); }
  const std::vector<TakenDelay>& delays() const { return diagram_.delays; }
  /// A number of the workspace at the point.
  double number(std::size_t offset);
  const Paths& paths() const { return paths_; }
  /// Counters and marks of sampled blocks on the way, which stay as the run has them.
  const std::vector<std::string>& counts() const { return counts_; }

  /// What a state or, behind them, an input is at the point.
  double value(std::size_t column) const;
  void set(std::size_t column, double value);
  /// By how much it may be changed at most: what counts discrete states by whole numbers must find one there.
  double most_change(std::size_t column) const;
  /// Where the states go (their derivatives, or their next values), and below them the outputs, with another
  /// number in a column.
  Eigen::VectorXd respond(std::size_t column, double value);
  Eigen::VectorXd respond();
  std::size_t columns() const { return states_.size() + inputs().size(); }
  void remove_state(std::size_t state) {
    states_.erase(states_.begin() + static_cast<std::ptrdiff_t>(state));
  }

 private:
  /// Offset of a column, and what lies there where the column is this.
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
  std::unique_ptr<run::Executor> run_;  ///< with which it is stepped from the point
  run::Workspace point_;
  std::vector<double> carried_;  ///< by the wires of the inputs, before anything is added
  std::vector<double> later_;    ///< the numbers of the point a base period later
  std::vector<StatePlace> states_;
  std::vector<std::string> counts_;
  std::vector<Circle> circles_;
};

}  // namespace stepwire::linear
