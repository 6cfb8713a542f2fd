#pragma once

#include <memory>
#include <vector>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::run {

/// Runs of one plan at time 0 that code steps together. Each ends by itself, as if it went alone; what then
/// stands in its lane is a copy of another one that goes on unseen.
class LaneGroup {
 public:
  struct Run {
    Executor* simulation;
    std::vector<record::Recorder>* recorders;
  };

  /// At least one run, at most as many as there are lanes; all must outlive it.
  LaneGroup(const plan::CompiledLanes& code, std::vector<Run> runs);

  /// Has the code the numbers of these runs?
  bool fits() const { return fits_; }
  bool goes_on() const { return task_.active != 0; }
  std::int64_t tick() const { return task_.tick; }
  /// Goes on for so many ticks, at most `ticks_at_once`, or to the end of all.
  void step(std::int64_t ticks);
  /// Ends all that go on, between two ticks: their bits.
  std::uint32_t interrupt();
  std::size_t runs() const { return runs_.size(); }

  static constexpr std::int64_t ticks_at_once = 64;  ///< whose rows are kept in the cache

 private:
  /// Numbers that registers are filled from.
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
  void leave(std::uint32_t lanes, int how);
  void take_out(std::size_t lane, int how);
  void copy_lane(std::size_t from, std::size_t to);
  std::vector<double> values_of(std::size_t lane) const;

  const plan::CompiledLanes& code_;
  std::size_t lanes_;
  std::vector<Run> runs_;  ///< of the first lanes; the others have copies of the last
  const plan::Plan& plan_;
  plan::LaneTask task_{};
  Aligned values_, numbers_, row_memory_;
  std::size_t singles_ = 0;            ///< numbers of a table, before its lists
  std::vector<double*> first_, next_;  ///< rows of each request
  bool fits_;
};

}  // namespace stepwire::run
