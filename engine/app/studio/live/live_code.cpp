#include "engine/app/studio/live/live_code.hpp"

#include "engine/model/diagram/variation.hpp"

namespace stepwire::live {

namespace {

/// Returns the parameters of the diagram that can be set without changing its structure.
std::vector<std::string> names_to_set(const diagram::Diagram& diagram) {
  std::vector<std::string> names;
  for (const diagram::DiagramParameter& parameter : diagram.parameters)
    if (std::holds_alternative<double>(parameter.value.content) &&
        !diagram::Variation(diagram, {parameter.name}).structural())
      names.push_back(parameter.name);
  return names;
}

}  // namespace

LiveCode::LiveCode(const plan::Plan& plan, plan::CodeSource* source) : plan_(plan), source_(source) {
  if (!source) return;
  const std::vector<std::string> names = names_to_set(plan.diagram);
  names_.insert(names.begin(), names.end());
  variable_ = plan::variable_blocks(plan, diagram::Variation(plan.diagram, names));
  compile();
}

void LiveCode::compile() {
  code_.reset();  // ends a pending compilation
  code_ = std::make_unique<run::TieredExecution>(run::ExecutionMode::automatic, source_,
                                                 std::vector<run::PlanOfRuns>{{&plan_, {variable_, {}}}},
                                                 static_cast<double>(plan_.steps));
}

void LiveCode::look(run::Executor& run, std::int64_t ticks) {
  if (!code_) return;
  code_->done(ticks);
  const plan::CompiledPlan* code = run.compiled() ? nullptr : code_->code(0);
  if (!code) return;
  run.use(*code);
  if (run.compiled()) return;
  run.widen(variable_);  // the run has another value for a constant of the code
  compile();
}

void LiveCode::was_set(const std::string& name) {
  if (!source_ || !names_.insert(name).second) return;
  plan::unite(variable_, plan_, plan::variable_blocks(plan_, diagram::Variation(plan_.diagram, {name})));
}

}  // namespace stepwire::live
