#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/participants.hpp"
#include "engine/simulate/solve/loop_solver.hpp"

namespace stepwire::run {

/// List of kernel calls of the plan, bound to the blocks of one run. Calls whose period is not due or whose
/// guard is inactive are skipped. Calls of an algebraic loop are repeated until they converge.
class CallTable {
 public:
  CallTable(const std::vector<plan::KernelCall>& batches, BoundBlocks& blocks, Participants& who);
  CallTable(const CallTable&) = delete;
  CallTable& operator=(const CallTable&) = delete;

  bool empty() const { return calls_.empty(); }
  /// Runs all calls, of any period.
  void run();
  /// Runs the calls that are due.
  void run_due();
  /// Sets the unknowns of all loops to their initial guess in a new run: 0, or what a block of the loop
  /// gives. A warm start from the last solution would change the last bits.
  void forget_loops();

 private:
  struct Call {
    Kernel run;
    std::byte *first, *end;
  };
  /// Gate of a call, in plans with guards.
  struct Gate {
    const double* active;  ///< address of the guard's number; 0.0 skips the call
    std::size_t next;      ///< index of the call after the skipped ones
  };
  /// Calls of one algebraic loop, with its solver.
  struct Loop {
    Loop(BoundBlocks& blocks, const plan::LoopCall& call);
    /// Finds the blocks of the loop that give the first guess.
    void find_starts(const std::vector<plan::KernelCall>& batches);
    /// Sets the guess to that of a new run.
    void forget(double* values) const;

    std::size_t first, end, unknowns = 0;
    BoundBlocks& blocks;
    std::vector<std::size_t> starts;  ///< blocks with a function start()
    std::vector<solve::Tear> tears;
    solve::LoopTask task{};
    solve::LoopSolver<> solver;
  };

  void add_gates();
  bool is_watched() const { return who_.probe && who_.probe->phase == &batches_; }
  /// Runs the table with loops, gates, late states or a probe.
  void run_slowly();
  void run_watched();
  /// Runs the due calls with an index in [first, end). A loop is part of the range that has its first call.
  void run_range(std::size_t first, std::size_t end);
  void run_calls(std::size_t first, std::size_t end);
  void run_guarded(std::size_t first, std::size_t end);
  /// Stores the new states of a call until the end of the table, and restores the old ones for the calls
  /// after it.
  void set_aside(const plan::KernelCall& call);
  void begin_late();
  void end_late();
  void solve(Loop& loop);

  const std::vector<plan::KernelCall>& batches_;
  const plan::Plan& plan_;
  double* const values_;
  Participants& who_;
  std::vector<Call> calls_;
  std::vector<Gate> gates_;  ///< one for each call; empty list in a plan without guards
  std::vector<Loop> loops_;
  std::vector<plan::LateStates> late_;  ///< late states that these calls write
};

}  // namespace stepwire::run
