#pragma once

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire::estimation {

/// Context for reading the section `fit`.
struct FitReading : query::NamesReading {
  const diagram::Diagram& diagram;
  std::vector<FitParameter>& parameters;  ///< All parameters of the file, including those that the call sets.

  FitReading(const query::SymbolTable& names, const diagram::Diagram& diagram,
             std::vector<FitParameter>& parameters, yaml::Faults& faults)
      : query::NamesReading("fit", names, faults), diagram(diagram), parameters(parameters) {}

  bool is_swept(const std::string& name) const;
};

/// Read the value of `parameters`, and the schemas of a parameter and of a curve.
void read_fit_parameters(FitRequest& request, const yaml::Node& node, const FitReading& read);
const yaml::Key& fit_parameter_form();
const yaml::Key& fit_curve_form();

}  // namespace stepwire::estimation
