#include "engine/app/session/sweep_sections.hpp"

#include <algorithm>
#include <iterator>

#include "engine/analyse/kept/kept_numbers.hpp"
#include "engine/app/session/cases_table.hpp"

namespace stepwire::session {

std::size_t recordings_of(const LoadedModel& model) {
  return model.kept ? 1 : model.job.plan.diagram.records.size();
}

void add_kept(LoadedModel& model, query::SymbolTable& names, yaml::Faults& faults) {
  const auto& sweep = model.job.plan.diagram.sweep;
  if (model.study && sweep && sweep->keep != diagram::Sweep::Keep::rows)
    faults.add(
        {{model.file, {}}, "sweep.keep", "the trials of a study are kept as scores; leave it out", {}});
  model.kept = kept::read_kept_numbers(model.job.plan.diagram, names, faults);
  if (!model.kept || !has_cases(model)) return;
  name_cases(*sweep, *model.kept, names);
  for (const query::RecordedName& column : names.columns)
    if (std::ranges::count(names.columns, column.name, &query::RecordedName::name) > 1)
      return faults.add({{model.file, {}},
                         "sweep.cases",
                         "'" + column.name + "' would be two columns; give the case another name",
                         {}});
}

bool has_cases(const LoadedModel& model) {
  const auto& sweep = model.job.plan.diagram.sweep;
  return model.kept && sweep && !sweep->cases().empty();
}

void draw_kept_as_points(const LoadedModel& model, std::vector<plot::Figure>& figures) {
  const auto& sweep = model.job.plan.diagram.sweep;
  if (!sweep || model.job.points.empty() || sweep->keep == diagram::Sweep::Keep::rows) return;
  for (plot::Figure& figure : figures)
    for (plot::Panel& panel : figure.panels)
      if (panel.find("x")) {
        panel.final_rows = true;
        panel.points_only = panel.points_only || sweep->design;  // what is drawn has no order
      }
}

void add_sensitivity(LoadedModel& model, query::SymbolTable& names, yaml::Faults& faults) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  if (diagram.sensitivity.kind == yaml::Node::Kind::empty) return;
  const std::size_t before = faults.size();
  model.sensitivity = sensitivity::read_sensitivity(diagram.sensitivity, diagram, names, faults);
  if (faults.size() != before) return;
  std::ranges::move(sensitivity::result_names(*model.sensitivity, recordings_of(model) + model.linear.size()),
                    std::back_inserter(names.columns));
  model.tables.push_back({sensitivity_table});
  names.tables = model.tables;
}

}  // namespace stepwire::session
