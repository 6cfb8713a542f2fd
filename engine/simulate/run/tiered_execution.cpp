#include "engine/simulate/run/tiered_execution.hpp"

#include <algorithm>
#include <system_error>

namespace stepwire::run {

namespace {

// Measured for g++ 12: what a compilation takes [s]; a few times more than expected does no harm.
constexpr double for_headers = 0.8, for_a_block = 1e-3;
constexpr double patience = 0.1;  // [s] after which it is known how fast the runs are
constexpr double margin = 2.0;    // times a compilation that must be left to do

}  // namespace

TieredExecution::TieredExecution(ExecutionMode engine, plan::CodeSource* source, std::vector<Member> plans,
                                 double ticks)
    : source_(engine == ExecutionMode::interpreted ? nullptr : source),
      plans_(std::move(plans)),
      all_ticks_(ticks) {
  for (const Member& member : plans_)
    compile_seconds_ += for_headers + for_a_block * static_cast<double>(member.plan->blocks.size());
  if (!source_) begun_ = true;
  if (source_ && engine == ExecutionMode::compiled && !begun_.exchange(true)) compile({});
}

const plan::CompiledPlan* TieredExecution::code(std::size_t plan) const {
  const bool there = ready_.load(std::memory_order_acquire) && plan < code_.size();
  return there ? &code_[plan] : nullptr;
}

void TieredExecution::compile(const std::stop_token& stop) {
  for (const Member& member : plans_) {
    auto code = source_->compile(*member.plan, member.variable, stop);
    if (!code) return;
    code_.push_back(std::move(*code));
  }
  ready_.store(true, std::memory_order_release);
}

bool TieredExecution::is_worth_it(std::int64_t done) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = seconds * (all_ticks_ - static_cast<double>(done)) / static_cast<double>(done);
  return seconds > patience && left > margin * compile_seconds_;
}

void TieredExecution::done(std::int64_t ticks) {
  const std::int64_t done = done_ += ticks;
  if (begun_.load(std::memory_order_relaxed) || !is_worth_it(done) || begun_.exchange(true)) return;
  try {
    thread_ = std::jthread([this](const std::stop_token& stop) { compile(stop); });
  } catch (const std::system_error&) {  // without a thread for it nothing is compiled
  }
}

}  // namespace stepwire::run
