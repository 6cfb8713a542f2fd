#include "engine/replay/sweep_runs.hpp"

#include <fmt/format.h>

#include "engine/replay/replay_folder.hpp"

namespace stepwire {

/// A diagram of the folder, with its present run.
struct SweepRuns::Diagram {
  Diagram(const std::string& path, const Registry& registry)
      : loader(registry, wide_limits),
        plan(make_plan(loader.load(path))),
        family(loader, path, {}, plan) {}

  Loader loader;
  Plan plan;
  PlanFamily family;
  std::unique_ptr<Simulation> run;
  std::size_t member = 0;  ///< of the run
};

SweepRuns::SweepRuns(std::string folder, std::size_t runs, const Registry& registry)
    : folder_(std::move(folder)), registry_(registry) {
  const std::string path = folder_ + "/" + sweep_name;
  for (const Column& column : read_csv_header(path).columns) words_[column.name];
  table_ = read_csv(path, words_);
  if (table_.rows() != runs)
    throw Error(Fault{
        {path, {}}, "", fmt::format("has {} rows, and run.json says {} runs", table_.rows(), runs), {}});
}

SweepRuns::~SweepRuns() = default;

const std::string& SweepRuns::text(std::size_t column, std::size_t run) const {
  const Column& of = table_.columns[column];
  return words_.at(of.name)[static_cast<std::size_t>(of.values[run])];
}

SweepRuns::Diagram& SweepRuns::diagram_of(std::size_t run) {
  const bool several = !table_.columns.empty() && table_.columns.front().name == diagram_column;
  const std::string name = several ? text(0, run) : flattened_name;
  auto& diagram = diagrams_[name];
  if (!diagram) diagram = std::make_unique<Diagram>(folder_ + "/" + name, registry_);
  return *diagram;
}

Simulation& SweepRuns::begin(std::size_t run) {
  Diagram& diagram = diagram_of(run);
  std::vector<Setting> values;
  const std::string place = fmt::format("{}/{}", folder_, sweep_name);
  for (std::size_t column = 0; column < table_.columns.size(); ++column)
    if (const std::string& value = text(column, run);
        table_.columns[column].name != diagram_column && !value.empty())
      values.push_back({table_.columns[column].name, value, place, {static_cast<int>(run) + 2, 1}});
  const std::size_t member = diagram.family.find(values);
  if (!diagram.run || member != diagram.member)
    diagram.run = std::make_unique<Simulation>(diagram.family.plan(member));
  diagram.member = member;
  diagram.family.begin(member, values, *diagram.run);
  return *diagram.run;
}

}  // namespace stepwire
