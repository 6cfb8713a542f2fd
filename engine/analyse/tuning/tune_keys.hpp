#pragma once

#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/tuning/tune_request.hpp"

namespace stepwire::tuning {

/// Context for reading the section `tune`.
struct TuneReading : query::NamesReading {
  const diagram::Diagram& diagram;

  TuneReading(const query::SymbolTable& names, const diagram::Diagram& diagram, yaml::Faults& faults)
      : query::NamesReading("tune", names, faults), diagram(diagram) {}
};

/// Reads the value of `parameters`; tune_parameter_form() is the schema of one of them.
void read_tune_parameters(TuneRequest& request, const yaml::Node& node, const TuneReading& read);
const yaml::Key& tune_parameter_form();

}  // namespace stepwire::tuning
