#pragma once

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire::estimation {

/// What the section `fit` is read with.
struct FitReading : query::NamesReading {
  const diagram::Diagram& diagram;
  std::vector<FitParameter>& parameters;  ///< all of the file, also those that the call sets

  FitReading(const query::SymbolTable& names, const diagram::Diagram& diagram,
             std::vector<FitParameter>& parameters, yaml::Faults& faults)
      : query::NamesReading("fit", names, faults), diagram(diagram), parameters(parameters) {}

  bool is_swept(const std::string& name) const;
};

/// Reads the value of `parameters`, what one of them has, and that of one of `curves`.
void read_fit_parameters(FitRequest& request, const yaml::Node& node, const FitReading& read);
const yaml::Key& fit_parameter_form();
const yaml::Key& fit_curve_form();

}  // namespace stepwire::estimation
