#include "engine/run/changeover.hpp"

#include <algorithm>
#include <system_error>

namespace stepwire {

namespace {

// Measured for g++ 12: what a compilation takes [s]; a few times more than expected does no harm.
constexpr double for_headers = 0.8, for_a_block = 1e-3;
constexpr double patience = 0.1;  // [s] after which it is known how fast the runs are
constexpr double margin = 2.0;    // times a compilation that must be left to do

}  // namespace

Changeover::Changeover(Engine engine, CodeSource* source, std::vector<const Plan*> plans)
    : source_(engine == Engine::interpreted ? nullptr : source), plans_(std::move(plans)) {
  for (const Plan* plan : plans_) {
    all_ticks_ += plan->steps;
    compile_seconds_ =
        std::max(compile_seconds_, for_headers + for_a_block * static_cast<double>(plan->blocks.size()));
  }
  if (!source_) begun_ = true;
  if (source_ && engine == Engine::compiled && !begun_.exchange(true)) compile({});
}

const CompiledPlan* Changeover::code(std::size_t plan) const {
  return ready_.load(std::memory_order_acquire) ? &code_[plan] : nullptr;
}

void Changeover::compile(const std::stop_token& stop) {
  code_ = source_->compile(plans_, stop);
  if (code_.size() == plans_.size()) ready_.store(true, std::memory_order_release);
}

bool Changeover::is_worth_it(std::int64_t done) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = seconds * static_cast<double>(all_ticks_ - done) / static_cast<double>(done);
  return seconds > patience && left > margin * compile_seconds_;
}

void Changeover::done(std::int64_t ticks) {
  const std::int64_t done = done_ += ticks;
  if (begun_.load(std::memory_order_relaxed) || !is_worth_it(done) || begun_.exchange(true)) return;
  try {
    thread_ = std::jthread([this](const std::stop_token& stop) { compile(stop); });
  } catch (const std::system_error&) {  // without a thread for it nothing is compiled
  }
}

}  // namespace stepwire
