#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/active_pieces.hpp"
#include "engine/simulate/run/bound_blocks.hpp"
#include "engine/simulate/run/run_fault.hpp"

namespace stepwire::run {

/// Health of a run: checks whether it may continue, and finds the fault that ended it.
class Health {
 public:
  explicit Health(const BoundBlocks& blocks);

  bool fine() const { return fine_; }
  /// True once a diagnostic that is no fault has ended the run.
  bool has_ended() const;
  /// Returns the time at which such a diagnostic ends the run [s], which may be within the present step;
  /// infinity without one.
  double end() const;
  /// Returns the tick after `tick` at which the block that ends the run is due.
  std::int64_t tick_of_end(std::int64_t tick) const;
  bool may_end() const { return !whole_ends_.empty(); }
  void restart() { fine_ = true; }
  /// Check the outputs of a tick, and the states after a step.
  void look_at_outputs() { fine_ = fine_ && is_finite() && loops_solved(); }
  void look_at_step();
  /// True while all signals and continuous states are finite.
  bool is_finite() const;
  /// Disables the fault of a loop that is not solved.
  void accept_unsolved() { accepts_unsolved_ = true; }

  /// Returns the fault that has ended the run at a time [s]; std::nullopt while fine().
  std::optional<RunFault> fault(double time) const;
  std::vector<RaisedDiagnostic> diagnostics() const;

 private:
  bool is_raised(const std::vector<std::size_t>& places) const;
  bool loops_solved() const;
  std::optional<RunFault> diagnostic_fault() const;
  std::optional<RunFault> not_finite(double time) const;
  std::string diagnostic_text(std::size_t block, std::size_t diagnostic) const;

  const BoundBlocks& blocks_;
  const plan::Plan& plan_;
  const double* const values_;
  std::vector<plan::ActivePiece> checked_;  ///< pieces of the workspace that must be finite
  std::vector<std::size_t> ending_;         ///< places of diagnostics that end a run as a fault
  std::vector<std::size_t> whole_ends_;     ///< places of diagnostics that end it as `stop_when` does
  bool fine_ = true, accepts_unsolved_ = false;
};

}  // namespace stepwire::run
