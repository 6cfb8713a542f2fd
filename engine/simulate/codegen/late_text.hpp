#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

// States that updates of a table set aside until all are done (plan::LateStates), as C++.

bool has_late(const std::vector<plan::KernelCall>& calls);
/// Before the calls, and behind them.
std::string begin_late_text(const plan::Plan& plan, const std::vector<plan::KernelCall>& calls);
std::string end_late_text(const plan::Plan& plan, const std::vector<plan::KernelCall>& calls);
/// Behind the call of a block whose states are late.
std::string set_aside_text(const plan::Plan& plan, const plan::KernelCall& call);

}  // namespace stepwire::codegen
