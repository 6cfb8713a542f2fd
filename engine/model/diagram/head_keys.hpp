#pragma once

#include "engine/base/sampling/design.hpp"
#include "engine/base/yaml/section.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Context for reading the head of a file. Faults are located in its scope, or in the setting that replaces a
/// value.
struct HeadReading : yaml::SectionReading {
  const Scope& scope;
  Report& report;
  Origin origin;

  HeadReading(std::string subject, const Scope& scope, Report& report)
      : HeadReading(std::move(subject), scope, report, scope.at({})) {}
  /// Makes the context of a value written at `origin`.
  HeadReading(std::string subject, const Scope& scope, Report& report, const Origin& origin);

  using yaml::SectionReading::take;
  void take(const yaml::Node& node, const yaml::Key& key, std::string& text) const;

 protected:
  /// Reads a number in the unit of the key, `$name` or `= expression`.
  std::optional<double> read_number(const yaml::Node& node, const yaml::Key& key) const override;
};

/// Rows of the head that set members of the diagram; head_form() has all keys.
const std::vector<yaml::KeyRow<Diagram, HeadReading>>& head_rows();
const yaml::Key& head_form();
/// True for a solver that controls its error also where its name is written alone.
bool always_controls_error(const std::string& solver);

/// Forms of the values under `parameters`, `inputs` and `outputs`, in `record` and in `sweep`.
const yaml::Key& parameter_form();
const yaml::Key& input_form();
const yaml::Key& output_form();
const yaml::Key& record_form();
const yaml::Key& sweep_form();
/// Forms of a range of swept values, and of a distribution.
const yaml::Key& range_form();
const yaml::Key& distribution_form();
/// Form of the word that selects the results kept of each run.
const yaml::Key& keep_word_form();
/// Table of the runs whose rows are kept beside the reduced numbers.
const yaml::KeyTable<Sweep, HeadReading>& recorded_runs_table();
/// Table of a sampling design.
const yaml::KeyTable<sampling::Design, HeadReading>& design_table();

}  // namespace stepwire::diagram
