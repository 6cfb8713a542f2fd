#include "engine/simulate/replay/sweep_runs.hpp"

#include <fmt/format.h>

#include "engine/model/diagram/load.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::replay {

/// Diagram of the folder, with its run.
struct SweepRuns::Diagram {
  Diagram(const std::string& path, const Registry& registry)
      : plan(plan::make_plan(loaded(path, registry))), run(plan) {}

  static stepwire::diagram::Diagram loaded(const std::string& path, const Registry& registry) {
    return diagram::Loader(registry, wide_limits).load(path);
  }

  plan::Plan plan;
  run::Executor run;
};

SweepRuns::SweepRuns(std::string folder, std::size_t runs, const Registry& registry)
    : folder_(std::move(folder)), registry_(registry) {
  const std::string path = folder_ + "/" + sweep_name;
  for (const table::Column& column : table::read_csv_header(path).columns) words_[column.name];
  table_ = table::read_csv(path, words_);
  if (table_.rows() != runs)
    throw yaml::Error(yaml::Fault{
        {path, {}}, "", fmt::format("has {} rows, and run.json says {} runs", table_.rows(), runs), {}});
}

SweepRuns::~SweepRuns() = default;

const std::string& SweepRuns::text(std::size_t column, std::size_t run) const {
  const table::Column& of = table_.columns[column];
  return words_.at(of.name)[static_cast<std::size_t>(of.values[run])];
}

SweepRuns::Diagram& SweepRuns::diagram_of(std::size_t run) {
  const bool several = !table_.columns.empty() && table_.columns.front().name == diagram_column;
  const std::string name = several ? text(0, run) : flattened_name;
  auto& diagram = diagrams_[name];
  if (!diagram) diagram = std::make_unique<Diagram>(folder_ + "/" + name, registry_);
  return *diagram;
}

run::Executor& SweepRuns::begin(std::size_t run) {
  Diagram& diagram = diagram_of(run);
  const std::string place = folder_ + "/" + sweep_name;
  const yaml::Mark mark{static_cast<int>(run) + 2, 1};
  std::vector<diagram::Assignment> values;
  std::vector<std::string> names;
  for (std::size_t column = 0; column < table_.columns.size(); ++column) {
    const std::string& name = table_.columns[column].name;
    const std::string& value = text(column, run);
    if (name == diagram_column || value.empty()) continue;
    names.push_back(name);
    values.push_back({name, diagram::value_of_text(value, place), place});
    values.back().value.mark = mark;
  }
  if (diagram.run.set(diagram::Variation(diagram.plan.diagram, names), values) !=
      run::Executor::Setting::done)
    throw yaml::Error(yaml::Fault{{place, mark}, "", diagram.run.structure_change(), {}});
  diagram.run.reset();
  return diagram.run;
}

}  // namespace stepwire::replay
