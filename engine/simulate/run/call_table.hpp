#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/participants.hpp"
#include "engine/simulate/solve/loop_solver.hpp"

namespace stepwire::run {

/// A list of calls of the plan, made on the blocks of one run. A call whose period is not due, or that a
/// guard has switched off, is left out. Calls of an algebraic loop are made again until they agree.
class CallTable {
 public:
  CallTable(const std::vector<plan::KernelCall>& batches, BoundBlocks& blocks, Participants& who);
  CallTable(const CallTable&) = delete;
  CallTable& operator=(const CallTable&) = delete;

  bool empty() const { return calls_.empty(); }
  /// Makes all calls, of any period.
  void run();
  /// Makes those that are due.
  void run_due();
  /// Lets loops begin at 0 as in a new run, and not where they were solved last: the last bit hangs on it.
  void forget_loops();

 private:
  struct Call {
    Kernel run;
    std::byte *first, *end;
  };
  /// Of a call, in plans with guards.
  struct Gate {
    const double* active;  ///< 0 while the call is left out
    std::size_t next;      ///< the call after it then
  };
  /// Calls that are made until they agree.
  struct Loop {
    Loop(const plan::Plan& plan, const plan::LoopCall& call);

    std::size_t first, end, unknowns = 0;
    std::vector<solve::Tear> tears;
    solve::LoopTask task{};
    solve::LoopSolver<> solver;
  };

  void add_gates();
  bool is_watched() const { return who_.probe && who_.probe->phase == &batches_; }
  /// With loops, gates, late states or a probe.
  void run_slowly();
  void run_watched();
  /// Makes the calls of a part of the table that are due; a loop belongs to the part that has its first call.
  void run_range(std::size_t first, std::size_t end);
  void run_calls(std::size_t first, std::size_t end);
  void run_guarded(std::size_t first, std::size_t end);
  /// Keeps new states of a call for the end of the table, and puts those before in their place.
  void set_aside(const plan::KernelCall& call);
  void begin_late();
  void end_late();
  void solve(Loop& loop);

  const std::vector<plan::KernelCall>& batches_;
  const plan::Plan& plan_;
  double* const values_;
  Participants& who_;
  std::vector<Call> calls_;
  std::vector<Gate> gates_;  ///< of each call; empty where the plan has no guard
  std::vector<Loop> loops_;
  std::vector<plan::LateStates> late_;  ///< that its calls write
};

}  // namespace stepwire::run
