#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/codegen/lane_places.hpp"

namespace stepwire::codegen {

/// Form of the part of advance() that integrates the states over a step, after the updates. The operations
/// and their order are those of the solver. It calls `derivatives(w, numbers, dot)` for the derivatives at
/// the tick. It calls `slopes(w, numbers, s, dot)` for those at a stage, with the time and states in `s`.
struct StepForm {
  bool small = false;  ///< True if stages have numbers of their own.
  bool begins = true;  ///< False if the derivatives at the start are in the workspace.
  std::string slopes = "slopes(w, numbers, s, dot)";
  LanePlaces lanes{};
  std::string stops{};  ///< Function that may end the integration after one of the solver's own steps; an
                        ///< empty text for none.
};
/// Returns the time of a stage at a fraction of the step: "now + 0.5 * length", "end".
std::string stage_time_text(double fraction);
std::string solver_text(const plan::Plan& plan, const StepForm& form);

}  // namespace stepwire::codegen
