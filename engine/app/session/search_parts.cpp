#include "engine/app/session/search_parts.hpp"

#include <fmt/format.h>

#include "engine/base/text/characters.hpp"

namespace stepwire::session {

namespace {

bool outlast_compilation(const run::Job& job, double runs) {
  // Costs of an interpreted block per tick, and of a compilation [s].
  constexpr double per_block = 5e-8, compilation = 1.5;
  double ticks = job.points.empty() ? static_cast<double>(job.plan.steps) : 0.0;
  for (std::size_t point = 0; point < job.points.size(); ++point)
    ticks += static_cast<double>(job.plan_of(point).steps);
  return per_block * ticks * static_cast<double>(job.plan.diagram.blocks.size()) * runs > compilation;
}

}  // namespace

std::vector<diagram::Setting> call_settings(const LoadOptions& options) {
  std::vector<diagram::Setting> settings = options.settings;
  if (options.stop) settings.push_back({"stop", *options.stop, "--stop " + *options.stop});
  return settings;
}

std::string parameters_text(const std::string& origin, const std::string& file,
                            const std::vector<diagram::Setting>& settings) {
  std::string text =
      fmt::format("# {} {}; stepwire run FILE --set-from takes this file.\n", origin, text::visible(file));
  for (const diagram::Setting& setting : settings)
    text += fmt::format("{}: {}\n", setting.name, setting.value);
  return text;
}

SearchParts::SearchParts(const Registry& registry, const LoadedModel& model, run::ExecutionMode engine,
                         double runs)
    : used(engine == run::ExecutionMode::compiled ||
                   (engine == run::ExecutionMode::automatic && outlast_compilation(model.job, runs))
               ? &code
               : nullptr),
      loader(registry, model.options.limits, model.options.reader),
      settings(call_settings(model.options)) {}

}  // namespace stepwire::session
