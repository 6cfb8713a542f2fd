#include "engine/simulate/run/lane_code.hpp"

#include <algorithm>
#include <system_error>

namespace stepwire::run {

namespace {

// Measured for g++ 12: what a compilation takes [s].
constexpr double for_headers = 0.7, for_a_block = 40e-3;
constexpr double patience = 0.2;   // [s] after which it is known how fast the runs are
constexpr double margin = 2.0;     // times a compilation that must be left to do
constexpr std::size_t fewest = 3;  // runs of a plan that are worth a compilation

}  // namespace

LaneCode::LaneCode(LaneUse use, plan::CodeSource* source, std::vector<Member> members)
    : source_(use == LaneUse::never ? nullptr : source),
      members_(std::move(members)),
      states_(members_.size()) {
  if (!source_) why_not_ = "no code is compiled";
  for (std::size_t m = 0; m < members_.size(); ++m) {
    add_ticks(members_[m]);
    if (members_[m].runs.value_or(fewest) < fewest && use != LaneUse::at_once)
      refuse(m, "too few runs have the same structure");
    else
      compile_seconds_ += for_headers + for_a_block * static_cast<double>(members_[m].plan->blocks.size());
  }
  begun_ = !source_ || compile_seconds_ == 0.0;
  if (!begun_ && use == LaneUse::at_once) {
    begun_ = true;
    compile({});
  }
}

void LaneCode::add_ticks(const Member& member) {
  if (!member.runs) all_ticks_.reset();
  if (all_ticks_) *all_ticks_ += static_cast<double>(*member.runs) * static_cast<double>(member.plan->steps);
}

const plan::CompiledLanes* LaneCode::code(std::size_t member) const {
  if (member >= states_.size() || !states_[member].ready.load(std::memory_order_acquire)) return nullptr;
  return &states_[member].code;
}

void LaneCode::compile(const std::stop_token& stop) {
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (states_[m].decided) continue;
    std::string why;
    auto code = source_->compile_lanes(*members_[m].plan, members_[m].differences, stop, why);
    if (!code) {
      refuse(m, why);
      continue;
    }
    states_[m].code = std::move(*code);
    states_[m].ready.store(true, std::memory_order_release);
  }
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

bool LaneCode::is_worth_it(std::int64_t done) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left =
      all_ticks_ ? seconds * (*all_ticks_ - static_cast<double>(done)) / static_cast<double>(done) : seconds;
  return seconds > patience && left > margin * compile_seconds_;
}

void LaneCode::done(std::int64_t ticks) {
  const std::int64_t done = done_ += ticks;
  if (begun_.load(std::memory_order_relaxed) || !is_worth_it(done) || begun_.exchange(true)) return;
  try {
    thread_ = std::jthread([this](const std::stop_token& stop) { compile(stop); });
  } catch (const std::system_error&) {  // without a thread for it the runs go one by one
  }
}

int LaneCode::lanes() const {
  int lanes = 1;
  for (const State& state : states_)
    if (state.ready.load(std::memory_order_acquire)) lanes = std::max(lanes, state.code.lanes);
  return lanes;
}

int LaneCode::most_lanes() const {
  return source_ && compile_seconds_ > 0.0 ? source_->lanes() : 1;
}

std::string LaneCode::why_not() const {
  const std::lock_guard lock(mutex_);
  if (!why_not_.empty() || lanes() > 1) return why_not_;
  return "the runs are too short for a compilation to be worth it";
}

}  // namespace stepwire::run
