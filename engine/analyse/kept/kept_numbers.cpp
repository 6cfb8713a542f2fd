#include "engine/analyse/kept/kept_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/kept/names.hpp"

namespace stepwire::kept {

namespace {

/// A named reduction.
struct Kept {
  std::string name;
  claim::RunFormula formula;
  bool read_later = false;  ///< True if a later kept number refers to it.
};

/// Adds a kept number as a constant column, in the form of a swept parameter.
void add_column(const std::string& name, double number, std::vector<record::Recording>& run) {
  for (record::Recording& one : run)
    one.table.columns.push_back({name, "", std::vector<double>(one.table.rows(), number)});
}

std::vector<double> numbers_of(const std::vector<Kept>& all, std::span<const record::Recording> run) {
  std::vector<record::Recording> own;
  std::vector<double> numbers;
  for (const Kept& kept : all) {
    const auto values = claim::values_of(kept.formula, own.empty() ? run : own);
    numbers.push_back(values.empty() ? query::nothing : values.front().value_or(query::nothing));
    if (!kept.read_later) continue;
    if (own.empty()) own.assign(run.begin(), run.end());
    add_column(kept.name, numbers.back(), own);
  }
  return numbers;
}

void note_names(const claim::RunFormula& formula, std::vector<Kept>& before) {
  for (const std::string& name : formula.columns())
    for (Kept& one : before) one.read_later = one.read_later || one.name == name;
}

/// Reads all kept numbers. A formula may refer to earlier ones, unless a signal has the same name.
std::vector<Kept> read_all(const yaml::Node& section, const query::NamesReading& outer) {
  query::SymbolTable names = outer.names;
  const query::NamesReading read(outer.subject, names, outer.faults);
  std::vector<Kept> all;
  for (const yaml::Entry& entry : section.entries) {
    const query::NamesReading one = yaml::below(read, entry.key);
    if (const query::RecordedName* taken = read.names.find(entry.key); taken && !taken->recording)
      one.fault(entry.mark, fmt::format("'{}' is a column already; give the number another name", entry.key));
    auto formula = claim::read_run_formula(entry.value, one);
    if (!formula) continue;
    note_names(*formula, all);
    if (!names.find(entry.key)) names.columns.push_back({entry.key, formula->formula->dimension, {}});
    all.push_back({entry.key, std::move(*formula)});
  }
  return all;
}

/// Replaces the recorded signals by the kept numbers, which are one number per run.
void rename(const std::vector<Kept>& all, query::SymbolTable& names) {
  std::erase_if(names.columns,
                [](const query::RecordedName& column) { return column.recording.has_value(); });
  for (const Kept& kept : all) names.columns.push_back({kept.name, kept.formula.formula->dimension, {}});
  names.unknown = "is none of the numbers that the sweep keeps of a run";
}

}  // namespace

std::shared_ptr<const run::RunNumbers> read_kept_numbers(const diagram::Diagram& diagram,
                                                         query::SymbolTable& names, yaml::Faults& faults) {
  if (!diagram.sweep || diagram.sweep->keep != diagram::Sweep::Keep::numbers) return nullptr;
  const std::size_t before = faults.size();
  auto all = std::make_shared<const std::vector<Kept>>(
      read_all(diagram.sweep->kept, query::NamesReading("sweep.keep", names, faults)));
  if (faults.size() != before) return nullptr;
  auto numbers = std::make_shared<run::RunNumbers>();
  for (const Kept& kept : *all) {
    const auto& dimension = kept.formula.formula->dimension;
    numbers->columns.push_back({kept.name, dimension ? unit::si_name(*dimension) : "", {}});
  }
  numbers->of = [all](std::span<const record::Recording> run) { return numbers_of(*all, run); };
  rename(*all, names);
  return numbers;
}

namespace {

std::string text_of(const yaml::Node& node, const char* key) {
  const yaml::Node* value = node.find(key);
  return value ? value->text : "";
}

/// Takes the parameters of the unflattened diagram from run.json; their places are those of the numbers in
/// the flattened one.
void take_parameters(const yaml::Node& note, diagram::Diagram& diagram) {
  const yaml::Node* parameters = note.find("parameters");
  if (!parameters) return;
  for (const yaml::Node& node : parameters->items) {
    diagram::DiagramParameter parameter;
    parameter.name = text_of(node, "name");
    parameter.text = text_of(node, "written");
    const std::string unit = text_of(node, "unit");
    const auto known = unit.empty() || unit == "null" ? std::nullopt : unit::parse_unit(unit);
    if (known) parameter.dimension = known->dimension;
    const auto number = unit::parse_quantity(text_of(node, "value"));
    if (number)
      parameter.value.content = number->value;
    else
      parameter.value.content = text_of(node, "value");
    diagram.parameters.push_back(std::move(parameter));
  }
}

void take_sweep(const yaml::Node& note, const table::Table& swept, const table::ColumnWords& words,
                diagram::Diagram& diagram) {
  diagram::Sweep sweep;
  sweep.keep = diagram::Sweep::Keep::numbers;
  if (const yaml::Node* kept = note.find("kept")) sweep.kept = *kept;
  for (const table::Column& column : swept.columns) {
    const auto known = words.find(column.name);
    const bool is_word = known != words.end();
    sweep.axes.push_back({column.name,
                          diagram::SweptValues(is_word ? known->second : std::vector<std::string>{"0"}),
                          {},
                          is_word});
  }
  diagram.sweep = std::move(sweep);
}

}  // namespace

std::shared_ptr<const run::RunNumbers> numbers_of_folder(const plan::Plan& plan, const yaml::Node& note,
                                                         const table::Table& swept,
                                                         const table::ColumnWords& words) {
  diagram::Diagram diagram = plan.diagram;
  diagram.parameters.clear();
  take_parameters(note, diagram);
  take_sweep(note, swept, words, diagram);
  const run::Job job{plan::make_plan(std::move(diagram)), {{}}, {}};
  query::SymbolTable names = names_of_file(job);
  yaml::Faults faults;
  auto numbers = read_kept_numbers(job.plan.diagram, names, faults);
  faults.throw_if_any();
  return numbers;
}

}  // namespace stepwire::kept
