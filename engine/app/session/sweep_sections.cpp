#include "engine/app/session/sweep_sections.hpp"

#include <algorithm>
#include <iterator>

#include "engine/analyse/kept/kept_numbers.hpp"

namespace stepwire::session {

std::size_t recordings_of(const LoadedModel& model) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  if (!model.kept) return diagram.records.size();
  return 1 + (diagram.sweep->recorded_runs > 0 ? diagram.records.size() : 0);
}

query::SymbolTable names_of_figures(const LoadedModel& model, const query::SymbolTable& names) {
  query::SymbolTable all = names;
  if (!model.kept || recordings_of(model) == 1) return all;
  const query::SymbolTable rows = kept::names_of(model.job);
  for (query::RecordedName& name : all.columns) {
    const query::RecordedName* of_rows = rows.find(name.name);
    if (!name.recording && (!of_rows || of_rows->recording)) name.recording = 0;
  }
  for (query::RecordedName name : rows.columns) {
    if (!name.recording && all.find(name.name)) continue;
    // A swept parameter of the cases is a column of these rows only.
    name.recording = name.recording.value_or(0) + 1;
    all.columns.push_back(std::move(name));
  }
  all.unknown = "is no number that the sweep keeps of a run, and no signal that is recorded";
  return all;
}

namespace {

/// True if the column is set by the cases of the sweep, so that it has one value in each case.
bool is_of_cases(const diagram::Sweep& sweep, const std::string& column) {
  return std::ranges::any_of(sweep.axes, [&](const diagram::Sweep::Axis& axis) {
    return axis.of_cases() && axis.parameter == column;
  });
}

bool is_kept(const run::RunNumbers& kept, const std::string& column) {
  return std::ranges::find(kept.columns, column, &table::Column::name) != kept.columns.end();
}

/// Returns `count` numbers: every `step`-th one from index `first` on.
std::vector<double> every(const std::vector<double>& all, std::size_t step, std::size_t first,
                          std::size_t count) {
  std::vector<double> some(count);
  for (std::size_t i = 0; i < count; ++i) some[i] = all[first + i * step];
  return some;
}

/// Refuses numbers with the name of a recorded signal, because figures can name both.
void refuse_names_of_signals(const LoadedModel& model, yaml::Faults& faults) {
  const query::SymbolTable rows = kept::names_of(model.job);
  for (const yaml::Entry& kept : model.job.plan.diagram.sweep->kept.entries)
    if (const query::RecordedName* name = rows.find(kept.key); name && name->recording)
      faults.add({{model.file, kept.mark},
                  "sweep.keep." + kept.key,
                  "a signal that is recorded has this name, too; give the number another one",
                  {}});
}

/// Renames the kept numbers of a sweep by its cases, as in the table of by_cases(): error becomes HV.error.
/// Without cases it changes nothing.
void name_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept, query::SymbolTable& names) {
  const std::vector<std::string> cases = sweep.cases();
  if (cases.empty()) return;
  std::vector<query::RecordedName> all;
  for (const query::RecordedName& column : names.columns) {
    if (is_of_cases(sweep, column.name)) continue;
    if (!is_kept(kept, column.name)) {
      all.push_back(column);
      continue;
    }
    for (const std::string& one : cases) {
      all.push_back(column);
      all.back().name = one + "." + column.name;
    }
  }
  names.columns = std::move(all);
}

}  // namespace

record::Recording by_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept,
                           const record::Recording& runs) {
  const std::vector<std::string> cases = sweep.cases();
  const bool whole = static_cast<double>(runs.table.rows()) == sweep.count();
  const std::size_t rows = whole ? runs.table.rows() / cases.size() : 0;
  record::Recording all{{}, {}, runs.categories};
  const auto add = [&](const table::Column& column, const std::string& name, std::size_t first) {
    all.table.columns.push_back({name, column.unit, every(column.values, cases.size(), first, rows)});
  };
  for (const table::Column& column : runs.table.columns) {
    if (!is_kept(kept, column.name)) {
      if (!is_of_cases(sweep, column.name)) add(column, column.name, 0);
      continue;
    }
    for (std::size_t i = 0; i < cases.size(); ++i) add(column, cases[i] + "." + column.name, i);
  }
  for (std::size_t row = 0; row < rows; ++row) all.starts.push_back(row);
  return all;
}

void add_kept(LoadedModel& model, query::SymbolTable& names, yaml::Faults& faults) {
  const auto& sweep = model.job.plan.diagram.sweep;
  if (model.study && sweep && sweep->keep != diagram::Sweep::Keep::rows)
    faults.add(
        {{model.file, {}}, "sweep.keep", "the trials of a study are kept as scores; leave it out", {}});
  model.kept = kept::read_kept_numbers(model.job.plan.diagram, names, faults);
  if (model.kept && recordings_of(model) > 1) {
    refuse_names_of_signals(model, faults);
    names.unknown += ", and rows stay of some of them only";
  }
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

/// True if a panel shows the kept numbers of all runs, not rows of some runs.
static bool reads_kept(const LoadedModel& model, const plot::Panel& panel) {
  return !model.kept || std::ranges::find(panel.recordings, std::size_t{0}) != panel.recordings.end();
}

void draw_kept_as_points(const LoadedModel& model, std::vector<plot::Figure>& figures) {
  const auto& sweep = model.job.plan.diagram.sweep;
  if (!sweep || model.job.points.empty() || sweep->keep == diagram::Sweep::Keep::rows) return;
  for (plot::Figure& figure : figures)
    for (plot::Panel& panel : figure.panels)
      if (panel.find("x") && reads_kept(model, panel)) {
        panel.final_rows = true;
        panel.points_only = panel.points_only || sweep->design;  // drawn points have no order
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
