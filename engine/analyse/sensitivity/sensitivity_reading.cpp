#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/sensitivity/sensitivity.hpp"

namespace stepwire::sensitivity {

using yaml::form;

namespace {

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
