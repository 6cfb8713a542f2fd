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

}  // namespace

Verdict exported(const Trial& trial, BatchCode& code) try {
  const MadeUnit* made = code.units().unit(trial.loaded->plan(), trial.seed / 12 % 2 == 0 ? 3 : 2);
  if (!made) return skipped("it is not compiled yet");
  if (!made->refused.empty()) return skipped(made->refused);
  if (!made->problem.empty()) return verdict_of(made->problem);
  const std::string text = difference_by(trial, *made, "co_simulation");
  if (!text.empty() || !made->exchanges) return verdict_of(text);
  return verdict_of(difference_by(trial, *made, "model_exchange"));
} catch (const yaml::Error& error) {
  return verdict_of(std::string("the unit is refused: ") + error.what());
}

}  // namespace stepwire::random
