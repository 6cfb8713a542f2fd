#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

// Late states as C++: states that updates of a table store until all updates are done (plan::LateStates).

bool has_late(const std::vector<plan::KernelCall>& calls);
/// Return the statements before and after the calls.
std::string begin_late_text(const plan::Plan& plan, const std::vector<plan::KernelCall>& calls);
std::string end_late_text(const plan::Plan& plan, const std::vector<plan::KernelCall>& calls);
/// Returns the statements after the call of a block with late states.
std::string set_aside_text(const plan::Plan& plan, const plan::KernelCall& call);

}  // namespace stepwire::codegen
