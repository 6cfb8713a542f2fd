// A parameter that is set or swept gives the bits of a file that has its value, whatever sizes signals have.
#include <catch2/catch.hpp>
#include <fstream>
#include <map>

#include "engine/simulate/run/run.hpp"
#include "tests/blocks/contract_values.hpp"
#include "tests/support/plan_text.hpp"

using namespace stepwire;

namespace {

struct Case {
  std::string text;  ///< a diagram with parameters p_NAME
  std::string name;
  std::string value, other;
  bool all_inputs;
};

/// The values of a parameter that are tried: a factor and an addend each.
constexpr std::pair<double, double> changes[] = {{1.25, 0.0}, {0.7, 0.1}};

/// Returns a case for each parameter of numbers of a block, in a diagram with signals of `elements` elements.
std::vector<Case> cases_of(const BlockType& type, int elements) {
  std::vector<Case> cases;
  const std::vector<Wiring> plain = wirings_of(type), wide = wide_wirings_of(type, elements);
  for (const Wiring& wiring : wide) {
    if (!plan_of(wiring)) continue;
    const std::string text = with_parameters(wiring, plain.front());
    if (text.empty()) continue;
    const auto plan = plan_of({text, true});
    if (!plan) continue;  // a value that fits one element alone
    for (const diagram::DiagramParameter& parameter : plan->diagram.parameters) {
      const ParameterSpec* spec = type.parameter(parameter.name.substr(2));
      const auto varied = [&](std::size_t i) {
        const auto [factor, more] = changes[i];
        return yaml_of(changed(parameter.value, factor, more, spec->kind == ParameterKind::integer));
      };
      cases.push_back(
          {text + "record: all\n", parameter.name, varied(0), varied(1), &wiring == &wide.back()});
    }
  }
  return cases;
}

std::vector<double> numbers_of(const std::vector<record::Recording>& recordings) {
  std::vector<double> numbers;
  for (const table::Column& column : recordings.front().table.columns)
    numbers.insert(numbers.end(), column.values.begin(), column.values.end());
  return numbers;
}

/// Returns the numbers of a run whose file has the value; std::nullopt if the value is refused.
std::optional<std::vector<double>> written(const DiagramFolder& folder, const Case& one,
                                           const std::string& value) try {
  return numbers_of(run::run_plan(folder.plan("one.yaml", {{one.name, value}})).recordings);
} catch (const yaml::Error&) {
  return std::nullopt;
}

/// The same where the value is set before the first tick; `structure` where that takes another plan.
std::optional<std::vector<double>> set(const plan::Plan& plan, const Case& one, const std::string& value,
                                       bool& structure) try {
  run::Executor simulation(plan);
  structure = simulation.set(one.name, value) != run::Executor::Setting::done;
  if (structure) return std::nullopt;
  simulation.reset();
  record::RunRecording recording(plan);
  run::TieredExecution none(run::ExecutionMode::interpreted, nullptr, {}, 0.0);
  run::run_simulation(simulation, recording.recorders(), {}, none, 0, 0);
  return numbers_of(recording.take());
} catch (const yaml::Error&) {
  return std::nullopt;
}

/// Returns the rows of both points of a sweep; std::nullopt if a value is refused.
std::optional<table::Table> swept(const DiagramFolder& folder) try {
  diagram::Loader loader(library());
  return run::run_job(run::make_job(loader, folder.path("swept.yaml")), {}).recordings.front().table;
} catch (const yaml::Error&) {
  return std::nullopt;
}

/// The rows that a sweep has for one of its two points, but for the column of what is swept.
std::vector<double> point_of(const table::Table& table, const Case& one, std::size_t point) {
  std::vector<double> numbers;
  for (const table::Column& column : table.columns) {
    if (column.name == one.name) continue;
    const auto& values = column.values;
    const auto half = static_cast<std::ptrdiff_t>(values.size() / 2);
    const auto first = values.begin() + (point == 0 ? 0 : half);
    numbers.insert(numbers.end(), first, first + half);
  }
  return numbers;
}

/// The diagram of a case, alone and with its sweep, beside what it reads.
void write(const DiagramFolder& folder, const Case& one) {
  std::ifstream record(std::string(STEPWIRE_SOURCE_DIR) + "/tests/blocks/contract_record.csv");
  folder.write("contract_record.csv", {std::istreambuf_iterator<char>(record), {}});
  folder.write("one.yaml", one.text);
  folder.write("swept.yaml",
               one.text + "sweep: {" + one.name + ": [" + one.value + ", " + one.other + "]}\n");
}

/// Compares one case; true where the parameter can be set without another plan.
bool compare(const Case& one) {
  const DiagramFolder folder;
  write(folder, one);
  const plan::Plan plan = folder.plan("one.yaml");
  INFO(one.text << one.name << ": " << one.value);
  bool structure = false;
  const auto first = written(folder, one, one.value), second = written(folder, one, one.other);
  const auto by_set = set(plan, one, one.value, structure);
  if (!structure) {
    CHECK(by_set.has_value() == first.has_value());
    if (by_set && first) CHECK(same_bits(*by_set, *first));
  }
  const auto table = swept(folder);
  CHECK(table.has_value() == (first && second));
  if (!table || !first || !second || first->size() != second->size()) return !structure;
  if ((table->columns.size() - 1) * table->columns.front().values.size() != first->size() + second->size())
    return !structure;  // runs that end at different ticks
  CHECK(same_bits(point_of(*table, one, 0), *first));
  CHECK(same_bits(point_of(*table, one, 1), *second));
  return !structure;
}

}  // namespace

TEST_CASE("each parameter of each block is set and swept to the bits of a file with its value", "[full]") {
  std::map<std::string, bool> may_be_set;  // with signals of one element
  std::size_t compared = 0;
  for (const int elements : {1, 3})
    for (const BlockType* type : library().types()) {
      if (type->file_output) continue;
      for (const Case& one : cases_of(*type, elements)) {
        const bool done = compare(one);
        const std::string name =
            type->name + "." + one.name + (one.all_inputs ? " with all inputs" : " alone");
        if (elements == 1) may_be_set[name] = done;
        INFO(name << ", " << elements << " elements");
        if (const auto known = may_be_set.find(name); known != may_be_set.end()) CHECK(done == known->second);
        ++compared;
      }
    }
  CHECK(compared > 500);
}
