#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/statistics/bootstrap.hpp"
#include "engine/base/sampling/design.hpp"
#include "engine/base/text/text_table.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::sensitivity {

/// An outcome of a run, by its name.
struct Outcome {
  std::string name;
  claim::RunFormula of_run;
};

/// The section `sensitivity` of a diagram file: of which outcomes it is found out how much which drawn
/// parameter matters. By the design of the sweep these are indices of Sobol, effects of Morris, or rank
/// correlations.
struct Request {
  std::vector<Outcome> outcomes;
  statistics::Bootstrap bootstrap;
  sampling::Design design;
  std::vector<std::string> parameters;  ///< that the design draws, in its order; for ranks those of numbers

  bool screens() const { return design.layout == sampling::Layout::morris; }
  bool ranks() const { return !screens() && design.layout != sampling::Layout::saltelli; }
  /// What is found of each parameter, as names have it: first, total.
  std::vector<std::string> measures() const;
};

/// The keys of the section.
const yaml::Key& sensitivity_form();

/// Reads the section. Everything that is wrong goes to `faults`.
Request read_sensitivity(const yaml::Node& node, const diagram::Diagram& diagram,
                         const query::SymbolTable& names, yaml::Faults& faults);

/// What figures and claims may name, all in one recording: peak.total.k, peak.total.k.low, peak.total.k.high.
std::vector<query::RecordedName> result_names(const Request& request, std::size_t recording);

/// What an analysis needs of all runs.
struct RunOutcomes {
  std::vector<std::vector<double>> outcomes;    ///< [outcome][run]
  std::vector<std::vector<double>> parameters;  ///< [parameter][run]; none where the design says them
};

/// Adds the numbers of runs that come behind those that are there.
void add_outcomes(const Request& request, std::span<const record::Recording> runs, RunOutcomes& numbers);

/// What is found of the numbers of all runs, as a recording of one row with these columns.
record::Recording results(const Request& request, const RunOutcomes& numbers);

/// The same for readers: a line for each outcome and parameter, and notes on outcomes that have no such
/// numbers.
text::TextTable results_table(const Request& request, const RunOutcomes& numbers,
                              const record::Recording& results);

}  // namespace stepwire::sensitivity
