// A diagram that is exported as a unit of FMI and imported again.
#include <fmt/format.h>

#include "tests/diagrams/imported_unit.hpp"
#include "tests/random/law_tools.hpp"

namespace stepwire::random {

namespace {

/// The difference of a run that has the unit in the place of the diagram.
std::string difference_by(const Trial& trial, const MadeUnit& made, const char* interface) {
  const plan::Plan& own = trial.loaded->plan();
  const std::int64_t ticks = trial.expected.ticks;
  const std::string text = text_with_unit(own.diagram, made.file,
                                          fmt::format("interface: {}, isolate: false", interface), own.steps);
  const Loaded outer(*trial.registry, text, trial.folder);
  const std::string difference = difference_of_unit(own, outer.plan(), made.exchanges, ticks);
  return difference.empty() ? "" : fmt::format("{}: {}", interface, difference);
}

Verdict as_unit(const Trial& trial, BatchCode& code, const char* interface) try {
  const MadeUnit* made = code.units().unit(trial.loaded->plan(), trial.seed % 24 < 12 ? 3 : 2);
  if (!made) return skipped("it is not compiled yet");
  if (!made->refused.empty()) return skipped(made->refused);
  if (!made->problem.empty()) return verdict_of(made->problem);
  if (std::string(interface) == "model_exchange" && !made->exchanges)
    return skipped("it has no model exchange");
  return verdict_of(difference_by(trial, *made, interface));
} catch (const yaml::Error& error) {
  const bool alike = std::string(error.what()).find("would be called") != std::string::npos;
  return alike ? skipped("two of its variables have one name as ports")
               : verdict_of(std::string("the unit is refused: ") + error.what());
}

}  // namespace

Verdict exported(const Trial& trial, BatchCode& code) {
  return as_unit(trial, code, "co_simulation");
}

Verdict exported_for_exchange(const Trial& trial, BatchCode& code) {
  return as_unit(trial, code, "model_exchange");
}

}  // namespace stepwire::random
