#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/statistics/sensitivity_indices.hpp"
#include "engine/base/sampling/design.hpp"
#include "engine/base/text/text_table.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::sensitivity {

/// A named outcome of a run.
struct Outcome {
  std::string name;
  claim::RunFormula of_run;
};

/// The section `sensitivity` of a diagram file: outcomes, and the design of the sweep. The design determines
/// the measures: Sobol indices, Morris effects or rank correlations.
struct Request {
  std::vector<Outcome> outcomes;
  statistics::Bootstrap bootstrap;
  sampling::Design design;
  std::vector<std::string> parameters;  ///< Parameters, in the order of the design; numeric ones for ranks.

  bool screens() const { return design.layout == sampling::Layout::morris; }
  bool ranks() const { return !screens() && design.layout != sampling::Layout::saltelli; }
  /// Returns the names of the measures of each parameter: first, total.
  std::vector<std::string> measures() const;
};

/// Returns the schema of the section.
const yaml::Key& sensitivity_form();

/// Reads the section. Adds all faults to `faults`.
Request read_sensitivity(const yaml::Node& node, const diagram::Diagram& diagram,
                         const query::SymbolTable& names, yaml::Faults& faults);

/// Returns the names of the results for figures and claims, all in one recording: peak.total.k,
/// peak.total.k.low, peak.total.k.high.
std::vector<query::RecordedName> result_names(const Request& request, std::size_t recording);

/// Numbers of all runs that an analysis needs.
struct RunOutcomes {
  std::vector<std::vector<double>> outcomes;    ///< [outcome][run]
  std::vector<std::vector<double>> parameters;  ///< [parameter][run]; empty if the design determines them.
};

/// Appends the numbers of further runs.
void add_outcomes(const Request& request, std::span<const record::Recording> runs, RunOutcomes& numbers);

/// Computes the measures from the numbers of all runs, as a recording of one row with these columns.
record::Recording results(const Request& request, const RunOutcomes& numbers);

/// Returns the measures as a table for reports: one line per outcome and parameter, and a note on each
/// outcome without measures.
text::TextTable results_table(const Request& request, const RunOutcomes& numbers,
                              const record::Recording& results);

}  // namespace stepwire::sensitivity
