#pragma once

#include <memory>
#include <vector>

#include "engine/model/plan/active_pieces.hpp"
#include "engine/simulate/run/call_table.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

/// Continuous part of a run: integrates the states from one time to another.
class Stepper {
 public:
  /// Throws Error if the diagram names an unknown solver.
  Stepper(BoundBlocks& blocks, Participants& who);
  ~Stepper();

  bool moves() const { return solver_ != nullptr; }
  /// Computes the signals that depend on time alone, if the time has changed.
  void follow_time();
  /// Computes the outputs of continuous blocks from the present states and inputs.
  void find_outputs() { stage_.run(); }
  void find_slopes() { derivatives_.run(); }
  /// Integrates one step; the derivatives at its start must be computed.
  void advance(const solve::TimeStep& step, const solve::Stops* stops = nullptr);
  /// Integrates from one tick to the next.
  void step(const solve::TimeStep& step);
  /// Integrates from a tick to a time before the next one, which becomes the present time.
  void step_to(std::int64_t tick, double end);
  /// Writes the states at the start of the last step, for the states that it has changed.
  void copy_start(double* states) const;

 private:
  struct Equations;

  const plan::Plan& plan_;
  double* const values_;
  const bool guarded_;
  CallTable timed_, stage_, derivatives_;
  std::vector<plan::ActivePiece> states_;  ///< Continuous states.
  std::unique_ptr<solve::Solver> solver_;  ///< nullptr without continuous states
  std::unique_ptr<Equations> equations_;
};

}  // namespace stepwire::run
