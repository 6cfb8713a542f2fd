#include "engine/study/trial_code.hpp"

#include <system_error>

namespace stepwire {

TrialCode::TrialCode(CodeSource& source, std::vector<Plan> probes, bool ahead)
    : source_(source), probes_(std::move(probes)), busy_(ahead) {
  if (!ahead) return;
  try {
    thread_ = std::jthread([this](const std::stop_token& stop) { compile_ahead(stop); });
  } catch (const std::system_error&) {  // without a thread for it nothing is compiled ahead
    busy_ = false;
  }
}

void TrialCode::compile_ahead(const std::stop_token& stop) {
  source_.compile(with_probes({}), stop);
  {
    const std::lock_guard lock(mutex_);
    busy_ = false;
  }
  finished_.notify_all();
}

std::vector<CompiledPlan> TrialCode::compile(const std::vector<const Plan*>& plans,
                                             const std::stop_token& stop) {
  {
    std::unique_lock lock(mutex_);
    if (!finished_.wait(lock, stop, [this] { return !busy_; })) return {};
  }
  std::vector<CompiledPlan> code = source_.compile(with_probes(plans), stop);
  if (code.size() == plans.size() + probes_.size()) code.resize(plans.size());
  return code;
}

std::vector<const Plan*> TrialCode::with_probes(std::vector<const Plan*> plans) const {
  for (const Plan& probe : probes_) plans.push_back(&probe);
  return plans;
}

}  // namespace stepwire
