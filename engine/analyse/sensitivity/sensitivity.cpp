#include "engine/analyse/sensitivity/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::sensitivity {

using yaml::form;

namespace {

using statistics::Estimate;

/// Returns the parameter that each step of the trajectories changes, and by how much.
std::vector<statistics::MorrisStep> steps_of(const sampling::Points& points, std::size_t of_way) {
  std::vector<statistics::MorrisStep> steps;
  for (std::size_t point = 0; point < points.front().size(); ++point)
    for (std::size_t d = 0; point % of_way != 0 && d < points.size(); ++d)
      if (points[d][point] != points[d][point - 1])
        steps.push_back({d, points[d][point] - points[d][point - 1]});
  return steps;
}

/// Returns one row per run: the parameters, then the outcome.
std::vector<double> rows_of(const std::vector<double>& outcomes,
                            const std::vector<std::vector<double>>& parameters) {
  std::vector<double> rows;
  for (std::size_t run = 0; run < outcomes.size(); ++run) {
    for (const std::vector<double>& parameter : parameters) rows.push_back(parameter[run]);
    rows.push_back(outcomes[run]);
  }
  return rows;
}

/// Returns the estimates as [measure][parameter].
std::vector<std::vector<Estimate>> estimates_of(const Request& request, const std::vector<double>& outcomes,
                                                const std::vector<std::vector<double>>& of_runs) {
  const std::size_t parameters = request.parameters.size();
  if (request.ranks()) {
    auto found = statistics::rank_sensitivity(rows_of(outcomes, of_runs), parameters, request.bootstrap);
    return {std::move(found.rank), std::move(found.partial)};
  }
  if (request.screens()) {
    const auto steps = steps_of(sampling::points_of(request.design, parameters),
                                request.design.points_of_sample(parameters));
    auto effects = statistics::morris_effects(outcomes, steps, parameters, request.bootstrap);
    return {std::move(effects.size), std::move(effects.mean), std::move(effects.deviation)};
  }
  auto indices = statistics::sobol_indices(outcomes, parameters, request.bootstrap);
  return {std::move(indices.first), std::move(indices.total)};
}

std::string column_name(const Outcome& outcome, const std::string& measure, const std::string& parameter) {
  return outcome.name + "." + measure + "." + parameter;
}

/// Returns the runs of one sample, and the least number of samples of all measures.
std::pair<std::size_t, std::size_t> needed_samples(const Request& request) {
  const std::size_t parameters = request.parameters.size();
  if (request.ranks()) return {1, statistics::fewest_rows(parameters - 1)};
  return {request.design.points_of_sample(parameters), request.screens() ? 2 : statistics::fewest_samples};
}

/// Returns the reason why an outcome has no measures, or not all of them; empty if its numbers are complete,
/// many and differ.
std::string note_on(const Request& request, const Outcome& outcome, const std::vector<double>& numbers) {
  const auto missing = std::ranges::count_if(numbers, [](double number) { return std::isnan(number); });
  if (missing > 0)
    return fmt::format("'{}' is not a number in {} of {}, so no parameter can be judged by it", outcome.name,
                       missing, text::counted(numbers.size(), "run"));
  const auto [runs, least] = needed_samples(request);
  if (const std::size_t samples = numbers.size() / runs; samples < least)
    return fmt::format("'{}' has {} {}, and {} are needed for all of these numbers: raise 'samples'",
                       outcome.name, samples, samples == 1 ? "sample" : "samples", least);
  if (numbers.empty() || std::ranges::adjacent_find(numbers, std::not_equal_to()) != numbers.end()) return "";
  return fmt::format("'{}' is {} in all {} runs: no parameter changes it, and none has a share of it",
                     outcome.name, query::short_number(numbers.front()), numbers.size());
}

/// Formats a number of the results; "-" for nan.
std::string number_text(const record::Recording& results, const std::string& name) {
  const double value = results.table.find(name)->values.front();
  return std::isnan(value) ? "-" : query::short_number(value, 3);
}

std::string interval_text(const record::Recording& results, const std::string& name) {
  const std::string low = number_text(results, name + ".low"), high = number_text(results, name + ".high");
  return low == "-" && high == "-" ? "-" : fmt::format("{} to {}", low, high);
}

using Table = yaml::KeyTable<Request, query::NamesReading>;

void read_outcomes(Request& request, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark, "names no outcome of a run: {peak: max(x)}");
  for (const yaml::Entry& entry : node.entries)
    if (auto of_run = claim::read_run_formula(entry.value, yaml::below(read, entry.key)))
      request.outcomes.push_back({entry.key, std::move(*of_run)});
}

yaml::Key confidence_form() {
  yaml::Key confidence = form::computed();
  confidence.least = 0.5;
  confidence.most = 0.999;
  return confidence;
}

const Table& table() {
  static const Table rows(
      "a sensitivity", "{of: {peak: max(x)}}",
      {yaml::needed(Table::Row{"of", "outcomes of a run, by name: {peak: max(x)}",
                               form::names(form::expression(), 1, "^[A-Za-z_][A-Za-z0-9_]*$"),
                               read_outcomes}),
       {"confidence", "of the intervals, which are percentiles of a bootstrap: 95 %", confidence_form(),
        [](Request& request, const yaml::Node& node, const query::NamesReading& read) {
          read.take(node, confidence_form(), request.bootstrap.confidence);
        }},
       {"replicates", "how often the samples are drawn again for them: 500", form::whole(20, 100'000),
        [](Request& request, const yaml::Node& node, const query::NamesReading& read) {
          read.take(node, form::whole(20, 100'000), request.bootstrap.replicates);
        }}});
  return rows;
}

/// True for a case axis whose kept numbers are in one row.
bool is_in_a_row(const diagram::Sweep::Axis& axis, const diagram::Sweep& sweep) {
  return axis.of_cases() && sweep.keep == diagram::Sweep::Keep::numbers;
}

/// Copies the design of the sweep. Adds a fault if anything but cases varies besides it.
void take_design(const yaml::Node& node, const diagram::Diagram& diagram, const query::NamesReading& read,
                 Request& request) {
  const auto& sweep = diagram.sweep;
  if (!sweep || !sweep->design)
    return read.fault(node.mark,
                      "needs a sweep that draws; write sweep: {k: {uniform: [1 N, 3 N]}, design: {samples: "
                      "1000, kind: sobol}}, or kind: saltelli or morris");
  request.design = *sweep->design;
  for (const diagram::Sweep::Axis& axis : sweep->axes) {
    if (axis.sampled() && (!request.ranks() || axis.values.are_numbers()))
      request.parameters.push_back(axis.parameter);
    else if (!axis.sampled() && axis.count() > 1 && !is_in_a_row(axis, *sweep))
      read.fault(node.mark,
                 fmt::format("'{}' has several values of its own; a sensitivity is that of what is "
                             "drawn, so give it one",
                             axis.parameter));
  }
  if (request.parameters.empty())
    read.fault(node.mark, "has nothing to order by: words have no ranks; draw a number");
}

}  // namespace

std::vector<query::RecordedName> result_names(const Request& request, std::size_t recording) {
  std::vector<query::RecordedName> names;
  for (const Outcome& outcome : request.outcomes)
    for (const std::string& measure : request.measures())
      for (const std::string& parameter : request.parameters)
        for (const char* of : {"", ".low", ".high"})
          names.push_back({column_name(outcome, measure, parameter) + of,
                           request.screens() ? outcome.of_run.formula->dimension : unit::Dimension{},
                           recording});
  return names;
}

void add_outcomes(const Request& request, std::span<const record::Recording> runs, RunOutcomes& numbers) {
  numbers.outcomes.resize(request.outcomes.size());
  for (std::size_t i = 0; i < numbers.outcomes.size(); ++i)
    for (const std::optional<double>& value : claim::values_of(request.outcomes[i].of_run, runs))
      numbers.outcomes[i].push_back(value.value_or(query::nothing));
  if (!request.ranks()) return;
  numbers.parameters.resize(request.parameters.size());
  for (std::size_t i = 0; i < numbers.parameters.size(); ++i) {
    const std::vector<double>& values = runs.front().table.find(request.parameters[i])->values;
    for (const std::size_t row : runs.front().starts)
      numbers.parameters[i].push_back(row < values.size() ? values[row] : query::nothing);
  }
}

record::Recording results(const Request& request, const RunOutcomes& numbers) {
  record::Recording found;
  found.table.columns.push_back({"time", "s", {0.0}});
  for (std::size_t i = 0; i < request.outcomes.size(); ++i) {
    const Outcome& outcome = request.outcomes[i];
    const auto estimates = estimates_of(request, numbers.outcomes.at(i), numbers.parameters);
    const auto& dimension = outcome.of_run.formula->dimension;
    const std::string unit = request.screens() && dimension ? unit::si_name(*dimension) : "1";
    const std::vector<std::string> measures = request.measures();
    for (std::size_t m = 0; m < measures.size(); ++m)
      for (std::size_t p = 0; p < request.parameters.size(); ++p) {
        const Estimate& one = estimates[m][p];
        const std::string name = column_name(outcome, measures[m], request.parameters[p]);
        found.table.columns.push_back({name, unit, {one.value}});
        found.table.columns.push_back({name + ".low", unit, {one.interval.low}});
        found.table.columns.push_back({name + ".high", unit, {one.interval.high}});
      }
  }
  return found;
}

text::TextTable results_table(const Request& request, const RunOutcomes& numbers,
                              const record::Recording& results) {
  text::TextTable table{request.screens() ? "Effects of Morris"
                        : request.ranks() ? "Rank correlations"
                                          : "Indices of Sobol",
                        {"outcome", "parameter"},
                        {},
                        {}};
  for (const std::string& measure : request.measures()) {
    table.columns.push_back(measure);
    table.columns.push_back(fmt::format("{:g} %", 100.0 * request.bootstrap.confidence));
  }
  for (const Outcome& outcome : request.outcomes)
    for (const std::string& parameter : request.parameters) {
      std::vector<std::string> line{outcome.name, parameter};
      for (const std::string& measure : request.measures()) {
        const std::string name = column_name(outcome, measure, parameter);
        line.push_back(number_text(results, name));
        line.push_back(interval_text(results, name));
      }
      table.rows.push_back(std::move(line));
    }
  for (std::size_t i = 0; i < request.outcomes.size() && i < numbers.outcomes.size(); ++i)
    if (std::string note = note_on(request, request.outcomes[i], numbers.outcomes[i]); !note.empty())
      table.notes.push_back(std::move(note));
  return table;
}

std::vector<std::string> Request::measures() const {
  if (screens()) return {"size", "mean", "deviation"};
  if (ranks()) return {"rank", "partial"};
  return {"first", "total"};
}

const yaml::Key& sensitivity_form() {
  return table().form;
}

Request read_sensitivity(const yaml::Node& node, const diagram::Diagram& diagram,
                         const query::SymbolTable& names, yaml::Faults& faults) {
  const query::NamesReading read("sensitivity", names, faults);
  Request request;
  table().read(node, request, read);
  take_design(node, diagram, read, request);
  return request;
}

}  // namespace stepwire::sensitivity
