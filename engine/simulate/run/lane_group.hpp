#pragma once

#include <memory>
#include <vector>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/stop_condition.hpp"

namespace stepwire::run {

/// Runs of one plan that code steps together in SIMD lanes, from time 0. Each run ends by itself, at the tick
/// at which it would end alone. The lanes of ended runs are refilled with a copy of a running one, whose
/// results are discarded.
class LaneGroup {
 public:
  struct Run {
    Executor* simulation;
    std::vector<record::Recorder>* recorders;
  };

  /// `runs` has at least one run and at most as many as there are lanes; all must outlive this object.
  LaneGroup(const plan::CompiledLanes& code, std::vector<Run> runs);

  /// True if the code was compiled for the numbers of these runs.
  bool fits() const { return fits_; }
  bool goes_on() const { return task_.active != 0; }
  std::int64_t tick() const { return task_.tick; }
  /// Steps `ticks` ticks, at most `ticks_at_once`, or until all runs have ended.
  void step(std::int64_t ticks);
  /// Ends all active runs between two ticks. Returns their bits.
  std::uint32_t interrupt();
  std::size_t runs() const { return runs_.size(); }

  static constexpr std::int64_t ticks_at_once = 64;  ///< upper limit that keeps the rows in the cache

 private:
  /// Numbers aligned for vector registers.
  struct FreeAligned {
    void operator()(double* numbers) const;
  };
  using Aligned = std::unique_ptr<double[], FreeAligned>;
  static Aligned aligned(std::size_t count);

  bool gather_values();
  bool gather_numbers();
  void make_rows();
  void begin_rows();
  void write_rows();
  void check_steps();
  bool has_stable_steps(std::size_t lane);
  void leave(std::uint32_t lanes, int how);
  void remove(std::uint32_t lanes);
  void take_out(std::size_t lane, int how);
  void copy_lane(std::size_t from, std::size_t to);
  std::vector<double> values_of(std::size_t lane) const;

  const plan::CompiledLanes& code_;
  std::size_t lanes_;
  std::vector<Run> runs_;  ///< runs of the first lanes; the other lanes have copies of the last one
  const plan::Plan& plan_;
  StopConditionEvaluator stopper_;
  std::int64_t next_check_;  ///< tick of next_step_check()
  plan::LaneTask task_{};
  Aligned values_, numbers_, row_memory_;
  std::size_t singles_ = 0;            ///< numbers of a table before its lists
  std::vector<double*> first_, next_;  ///< Rows of each request.
  bool fits_;
};

}  // namespace stepwire::run
