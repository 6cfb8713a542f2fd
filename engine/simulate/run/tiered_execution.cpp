#include "engine/simulate/run/tiered_execution.hpp"

namespace stepwire::run {

namespace {

// Measured compile times of g++ 12 [s]; an estimate that is wrong by a factor of a few does no harm.
constexpr double for_headers = 0.8, for_a_block = 1e-3;

double compile_seconds(const std::vector<PlanOfRuns>& plans) {
  double seconds = 0.0;
  for (const PlanOfRuns& member : plans)
    seconds += for_headers + for_a_block * static_cast<double>(member.plan->blocks.size());
  return seconds;
}

}  // namespace

TieredExecution::TieredExecution(ExecutionMode engine, plan::CodeSource* source,
                                 std::vector<PlanOfRuns> plans, double ticks)
    : source_(engine == ExecutionMode::interpreted ? nullptr : source),
      plans_(std::move(plans)),
      compilation_({.seconds = source_ ? compile_seconds(plans_) : 0.0, .ticks = ticks},
                   [this](const plan::CodeLimits& limits) { return compile(limits); }) {
  if (engine == ExecutionMode::compiled) compilation_.at_once();
}

const plan::CompiledPlan* TieredExecution::code(std::size_t plan) const {
  const bool there = ready_.load(std::memory_order_acquire) && plan < code_.size();
  return there ? &code_[plan] : nullptr;
}

bool TieredExecution::compile(const plan::CodeLimits& limits) {
  code_.clear();
  for (const PlanOfRuns& of : plans_) {
    auto code = source_->compile(*of.plan, of.differences.variable, limits);
    if (!code) return false;
    code_.push_back(std::move(*code));
  }
  ready_.store(true, std::memory_order_release);
  return true;
}

}  // namespace stepwire::run
