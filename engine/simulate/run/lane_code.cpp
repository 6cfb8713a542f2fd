#include "engine/simulate/run/lane_code.hpp"

#include <algorithm>

namespace stepwire::run {

namespace {

// Measured compile times of g++ 12 [s].
constexpr double for_lane_headers = 0.7, for_a_lane_block = 40e-3;
constexpr double patience = 0.2;   // Time [s] until the speed of the runs is measurable.
constexpr std::size_t fewest = 3;  // Smallest number of runs of a plan that is worth a compilation.

bool is_sought(const PlanOfRuns& member, LaneUse use) {
  return member.runs.value_or(fewest) >= fewest || use == LaneUse::at_once;
}

/// Estimates the compile time of the plans that may use lanes; 0 without a source of code.
BackgroundCompilation::Prospect prospect(const std::vector<PlanOfRuns>& members, LaneUse use,
                                         const plan::CodeSource* source) {
  BackgroundCompilation::Prospect prospect{0.0, 0.0, patience};
  for (const PlanOfRuns& member : members) {
    const auto blocks = static_cast<double>(member.plan->blocks.size());
    if (source && is_sought(member, use)) prospect.seconds += for_lane_headers + for_a_lane_block * blocks;
    if (!member.runs) prospect.ticks.reset();
    if (prospect.ticks)
      *prospect.ticks += static_cast<double>(*member.runs) * static_cast<double>(member.plan->steps);
  }
  return prospect;
}

}  // namespace

LaneCode::LaneCode(LaneUse use, plan::CodeSource* source, std::vector<PlanOfRuns> members)
    : source_(use == LaneUse::never ? nullptr : source),
      members_(std::move(members)),
      states_(members_.size()),
      compilation_(prospect(members_, use, source_),
                   [this](const plan::CodeLimits& limits) { return compile(limits); }) {
  if (!source_) why_not_ = "no code is compiled";
  for (std::size_t m = 0; m < members_.size(); ++m)
    if (is_sought(members_[m], use))
      seeks_ = source_ != nullptr;
    else
      refuse(m, "too few runs have the same structure");
  if (use == LaneUse::at_once) compilation_.at_once();
}

const plan::CompiledLanes* LaneCode::code(std::size_t member) const {
  if (member >= states_.size() || !states_[member].ready.load(std::memory_order_acquire)) return nullptr;
  return &states_[member].code;
}

bool LaneCode::compile(const plan::CodeLimits& limits) {
  bool all = true;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (states_[m].decided || code(m)) continue;
    std::string why;
    auto code = source_->compile_lanes(*members_[m].plan, members_[m].differences, limits, why);
    if (code) {
      states_[m].code = std::move(*code);
      states_[m].ready.store(true, std::memory_order_release);
    } else if (why.empty()) {
      all = false;
    } else {
      refuse(m, why);
    }
  }
  return all;
}

void LaneCode::decide(std::size_t member, const std::string& why_not) {
  if (why_not.empty())
    states_[member].decided = true;
  else
    refuse(member, why_not);
}

void LaneCode::refuse(std::size_t member, const std::string& why) {
  states_[member].decided = true;
  states_[member].ready = false;
  const std::lock_guard lock(mutex_);
  if (why_not_.empty()) why_not_ = why;
}

int LaneCode::lanes() const {
  int lanes = 1;
  for (const State& state : states_)
    if (state.ready.load(std::memory_order_acquire)) lanes = std::max(lanes, state.code.lanes);
  return lanes;
}

int LaneCode::most_lanes() const {
  return seeks_ ? source_->lanes() : 1;
}

std::string LaneCode::why_not() const {
  const std::lock_guard lock(mutex_);
  if (!why_not_.empty() || lanes() > 1) return why_not_;
  return "the runs are too short for a compilation to be worth it";
}

}  // namespace stepwire::run
