#include "engine/simulate/codegen/times_ahead.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "engine/simulate/codegen/event_text.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/solver_text.hpp"
#include "engine/simulate/codegen/workspace_text.hpp"
#include "engine/simulate/solve/additions.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::codegen {

namespace {

constexpr std::size_t longest_lane = 4096;  // numbers of a lane, which are on the stack

/// Returns the times at which a tick computes what follows from the time, in their order and without
/// repetitions: those of the stages, and the next tick.
std::vector<std::string> times_of_tick(const plan::Plan& plan) {
  std::vector<std::string> times;
  const auto add = [&](const std::string& time) {
    if (std::ranges::find(times, time) == times.end()) times.push_back(time);
  };
  if (plan.layout.state_count > 0) {
    const auto stages = solve::stages_of(*solve::find_tableau(plan.diagram.solver));
    for (std::size_t stage = 0; stage + 1 < stages.size(); ++stage) add(stage_time_text(stages[stage].next));
  }
  add(plan.jumps ? time_text(plan, "tick + 1") : "end");
  return times;
}

std::vector<std::size_t> timed_blocks(const plan::Plan& plan) {
  std::map<std::size_t, std::size_t> at_memory;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) at_memory[plan.blocks[b].memory] = b;
  std::vector<std::size_t> blocks;
  for (const plan::KernelCall& batch : plan.timed) {
    const std::size_t bytes = plan.diagram.blocks[at_memory.at(batch.first)].type().bytes;
    for (std::size_t i = 0; i < batch.count; ++i) blocks.push_back(at_memory.at(batch.first + i * bytes));
  }
  return blocks;
}

}  // namespace

TimesAhead::TimesAhead(const plan::Plan& plan, const LanePlaces& lanes)
    : plan_(plan),
      ahead_{lanes.lanes, std::vector<bool>(plan.layout.size), std::vector<bool>(plan.blocks.size())} {
  const std::vector<std::size_t> blocks = timed_blocks(plan);
  if (lanes.lanes == 1 || blocks.empty()) return;
  for (const std::size_t block : blocks)
    if (lanes.blocks[block] || !plan.blocks[block].diagnostics.empty()) return;
  find_places(blocks);
  times_ = times_of_tick(plan);
  if (size_ <= longest_lane) ticks_ = lanes.lanes / static_cast<int>(times_.size());
}

void TimesAhead::find_places(const std::vector<std::size_t>& blocks) {
  ahead_.places[plan::Layout::time] = true;
  size_ = plan::Layout::time + 1;
  for (const std::size_t block : blocks) {
    ahead_.blocks[block] = true;
    for (const plan::SignalSlot& slot : plan_.blocks[block].outputs) {
      const std::size_t end = slot.offset + static_cast<std::size_t>(slot.size);
      std::fill(ahead_.places.begin() + static_cast<std::ptrdiff_t>(slot.offset),
                ahead_.places.begin() + static_cast<std::ptrdiff_t>(end), true);
      size_ = std::max(size_, end);
    }
  }
}

Places TimesAhead::places(Places others) const {
  others.fresh = "s";
  others.is_fresh = ahead_.places;
  others.lanes = &ahead_;
  others.min_in_loop = std::numeric_limits<std::size_t>::max();
  return others;
}

std::string TimesAhead::fill_text(const std::string& attribute, const std::string& calls) const {
  std::string times;
  for (std::size_t i = 0; i < times_.size(); ++i)
    times += fmt::format("    s.lane(k * {} + {})[at::time] = {};\n", times_.size(), i, times_[i]);
  return fmt::format(
      "/// Computes what follows from the time alone, for the times of the next {0} ticks.\n"
      "{1} void fill_ahead({2}, std::int64_t first) {{\n  const Lanes s{{w.ahead->first}};\n"
      "  for (int k = 0; k < {0}; ++k) {{\n    const std::int64_t tick = first + k;\n{3}{4}  }}\n"
      "  for (int l = {5}; l < lanes; ++l) s.lane(l)[at::time] = s[at::time];\n{6}"
      "  w.ahead->tick = first;\n}}\n\n",
      ticks_, attribute, workspace_parameters(ahead_), times_of_step_text(plan_), times,
      ticks_ * static_cast<int>(times_.size()), calls);
}

std::string TimesAhead::take_text() const {
  std::string text =
      "  if (const int l = w.ahead->next; l < lanes && Lanes{w.ahead->first}.lane(l)[at::time] == "
      "w[at::time]) {\n"
      "    const Lane s = Lanes{w.ahead->first}.lane(l);\n    w.ahead->next = l + 1;\n";
  for (const LanePlaces::Stretch& one : ahead_.stretches(plan::Layout::time + 1, size_))
    if (one.differs)
      text += fmt::format("    for (int i = {}; i < {}; ++i) w[i] = s[i];\n", one.first, one.end);
  return text + "    return;\n  }\n";
}

std::string TimesAhead::memory_text() const {
  if (!possible()) return "  const Lanes w{task.values};\n";
  return fmt::format(
      "  alignas(64) double numbers_ahead[{} * lanes];\n  TimesAhead ahead{{numbers_ahead, task.tick - {}, "
      "lanes}};\n"
      "  const Lanes w{{task.values, &ahead}};\n",
      size_, ticks_);
}

std::string TimesAhead::tick_text() const {
  if (!possible()) return "";
  return fmt::format(
      "    if (tick - ahead.tick >= {}) fill_ahead(w, numbers, tick);\n"
      "    ahead.next = static_cast<int>(tick - ahead.tick) * {};\n",
      ticks_, times_.size());
}

}  // namespace stepwire::codegen
