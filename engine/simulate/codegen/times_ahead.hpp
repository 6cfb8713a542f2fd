#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/lane_places.hpp"
#include "engine/simulate/codegen/statements.hpp"

namespace stepwire::codegen {

/// Text of code in lanes that computes what follows from the time alone ahead: one time in each lane, for as
/// many ticks as fit into the lanes. Such numbers are common to all runs, so a call for each time would use a
/// single lane. The times are computed as the step computes them, and a number is only taken for its own
/// time.
class TimesAhead {
 public:
  /// `plan` must outlive it.
  TimesAhead(const plan::Plan& plan, const LanePlaces& lanes);

  /// False if nothing follows from the time alone, or if a run may change or observe it: such a block differs
  /// between runs or raises diagnostics. Also false if a tick has more times than there are lanes.
  bool possible() const { return ticks_ > 0; }
  /// Returns the places of the numbers ahead, for the calls of their blocks.
  Places places(Places others) const;
  /// Returns the function that fills the lanes, with these calls.
  std::string fill_text(const std::string& attribute, const std::string& calls) const;
  /// Returns the statements that take the numbers of the present time and return, where they are ahead.
  std::string take_text() const;
  /// Returns the declarations before a loop over ticks: memory, and a workspace that knows it.
  std::string memory_text() const;
  /// Returns the statement at the start of a tick.
  std::string tick_text() const;

 private:
  void find_places(const std::vector<std::size_t>& blocks);

  const plan::Plan& plan_;
  LanePlaces ahead_;                ///< The places that are ahead, as if they differed between lanes.
  std::vector<std::string> times_;  ///< Times of a tick, in order.
  std::size_t size_ = 0;            ///< Count of numbers in a lane.
  int ticks_ = 0;                   ///< Ticks at a time.
};

}  // namespace stepwire::codegen
