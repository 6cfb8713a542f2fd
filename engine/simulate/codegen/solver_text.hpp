#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/codegen/lane_places.hpp"

namespace stepwire::codegen {

/// The body of the part of advance() that takes the states over a step, after the updates: the same
/// operations in the same order as the solver's. It calls `derivatives(w, numbers, dot)` for the slopes at
/// the tick and `slopes(w, numbers, s, dot)` for those at a stage, whose time and states stand in `s`.
struct StepForm {
  bool small = false;  ///< the stages have numbers of their own, which a compiler can keep in registers
  bool begins = true;  ///< else the slopes at the start are in the workspace
  std::string slopes = "slopes(w, numbers, s, dot)";
  LanePlaces lanes{};
  std::string stops{};  ///< function that ends the way behind one of the solver's own steps; empty: none
};
std::string solver_text(const plan::Plan& plan, const StepForm& form);

}  // namespace stepwire::codegen
