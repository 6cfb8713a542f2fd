#include "engine/simulate/codegen/late_text.hpp"

#include <algorithm>

#include "engine/simulate/codegen/guard_text.hpp"

namespace stepwire::codegen {

namespace {

const plan::LateStates& late_of(const plan::Plan& plan, const plan::KernelCall& call) {
  return plan.late[static_cast<std::size_t>(call.late)];
}

}  // namespace

bool has_late(const std::vector<plan::KernelCall>& calls) {
  return std::ranges::any_of(calls, [](const plan::KernelCall& call) { return call.late >= 0; });
}

std::string begin_late_text(const plan::Plan& plan, const std::vector<plan::KernelCall>& calls) {
  std::string text;
  for (const plan::KernelCall& call : calls) {
    if (call.late < 0) continue;
    const plan::LateStates& late = late_of(plan, call);
    text += copy_text(late.state, late.before, late.size) + copy_text(late.state, late.after, late.size);
  }
  return text;
}

std::string end_late_text(const plan::Plan& plan, const std::vector<plan::KernelCall>& calls) {
  std::string text;
  for (const plan::KernelCall& call : calls)
    if (call.late >= 0)
      text += copy_text(late_of(plan, call).after, late_of(plan, call).state, late_of(plan, call).size);
  return text;
}

std::string set_aside_text(const plan::Plan& plan, const plan::KernelCall& call) {
  const plan::LateStates& late = late_of(plan, call);
  return copy_text(late.state, late.after, late.size) + copy_text(late.before, late.state, late.size);
}

}  // namespace stepwire::codegen
