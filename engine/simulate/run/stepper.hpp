#pragma once

#include <memory>
#include <vector>

#include "engine/model/plan/active_pieces.hpp"
#include "engine/simulate/run/call_table.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

/// The continuous part of a run: takes the states of its numbers from one time to another.
class Stepper {
 public:
  /// Throws Error where the diagram names a solver that is not known.
  Stepper(BoundBlocks& blocks, Participants& who);
  ~Stepper();

  bool moves() const { return solver_ != nullptr; }
  /// Computes what follows from the time alone, if it has changed.
  void follow_time();
  /// Computes outputs of continuous blocks, from the states and the inputs of the moment.
  void find_outputs() { stage_.run(); }
  void find_slopes() { derivatives_.run(); }
  /// Goes from the slopes at the start of a step to the states at its end.
  void advance(const solve::TimeStep& step, const solve::Stops* stops = nullptr);
  /// Goes from one tick to the next.
  void step(std::int64_t tick);
  /// Writes the states at the start of the last step, where it has moved them.
  void copy_start(double* states) const;

 private:
  struct Equations;

  const plan::Plan& plan_;
  double* const values_;
  const bool guarded_;
  CallTable timed_, stage_, derivatives_;
  std::vector<plan::ActivePiece> states_;  ///< continuous
  std::unique_ptr<solve::Solver> solver_;  ///< none where nothing is continuous
  std::unique_ptr<Equations> equations_;
};

}  // namespace stepwire::run
