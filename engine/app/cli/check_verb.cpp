#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/report/run_text.hpp"

namespace stepwire::cli {

namespace {

ExitCode check(const session::LoadedModel& model, const ModelCall& call, json::Json& results) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  if (call.json) {
    results.push(json::Json::object()
                     .set("file", model.file)
                     .set("blocks", diagram.blocks.size())
                     .set("claims", model.claims.size())
                     .set("figures", model.figures.size()));
    return ExitCode::done;
  }
  if (call.units) put_text(report::units_text(diagram));
  say("{}: {} blocks, {} claims, {} figures: nothing wrong\n", model.file, diagram.blocks.size(),
      model.claims.size(), model.figures.size());
  return ExitCode::done;
}

Action declare_check(CLI::App& verb) {
  const auto call = std::make_shared<ModelCall>();
  add_model_options(verb, *call);
  return [call](const Registry& registry) {
    return each_model(*call, registry, [&](const session::LoadedModel& model, json::Json& results) {
      return check(model, *call, results);
    });
  };
}

}  // namespace

Verb check_verb() {
  return {"check", "do all that run does before the first step",
          "Example:\n  stepwire check diagrams/examples/*.yaml", declare_check};
}

}  // namespace stepwire::cli
