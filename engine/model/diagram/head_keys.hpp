#pragma once

#include "engine/base/sampling/design.hpp"
#include "engine/base/yaml/section.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// What the head of a file is read with: faults have the places of its scope, or of the setting that stands
/// in place of a value.
struct HeadReading : yaml::SectionReading {
  const Scope& scope;
  Report& report;
  Origin origin;

  HeadReading(std::string subject, const Scope& scope, Report& report)
      : HeadReading(std::move(subject), scope, report, scope.at({})) {}
  /// Of a value that stands at `origin`.
  HeadReading(std::string subject, const Scope& scope, Report& report, const Origin& origin);

  using yaml::SectionReading::take;
  void take(const yaml::Node& node, const yaml::Key& key, std::string& text) const;

 protected:
  /// A number in the unit of the key, `$name` or `= expression`.
  std::optional<double> read_number(const yaml::Node& node, const yaml::Key& key) const override;
};

/// The rows of the head that set something in the diagram; the form has all its keys.
const std::vector<yaml::KeyRow<Diagram, HeadReading>>& head_rows();
const yaml::Key& head_form();

/// What stands behind names under `parameters`, `inputs` and `outputs`, in `record` and in `sweep`.
const yaml::Key& parameter_form();
const yaml::Key& input_form();
const yaml::Key& output_form();
const yaml::Key& record_form();
const yaml::Key& sweep_form();
/// A range of swept values, and how one is spread that is drawn.
const yaml::Key& range_form();
const yaml::Key& distribution_form();
/// What stays of each run, as a word.
const yaml::Key& keep_word_form();
/// Of which runs the rows stay beside the numbers that are kept.
const yaml::KeyTable<Sweep, HeadReading>& recorded_runs_table();
/// Where drawn values lie.
const yaml::KeyTable<sampling::Design, HeadReading>& design_table();

}  // namespace stepwire::diagram
