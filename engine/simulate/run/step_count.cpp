#include "engine/simulate/run/step_count.hpp"

#include "engine/simulate/solve/error_control.hpp"

namespace stepwire::run {

StepCount step_count(const plan::Plan& plan, const double* values) {
  if (!plan.diagram.error_control) return {};
  const double* report = values + plan.layout.report;
  return {static_cast<std::int64_t>(report[solve::ControlReport::steps]),
          static_cast<std::int64_t>(report[solve::ControlReport::rejected]),
          report[solve::ControlReport::largest], report[solve::ControlReport::stiff] != 0.0};
}

}  // namespace stepwire::run
