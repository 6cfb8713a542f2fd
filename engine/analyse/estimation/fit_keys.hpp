#pragma once

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire {

/// What the section `fit` is read with.
struct FitReading : NamesReading {
  const Diagram& diagram;
  std::vector<FitParameter>& parameters;  ///< all of the file, also those that the call sets

  FitReading(const SymbolTable& names, const Diagram& diagram, std::vector<FitParameter>& parameters,
             Faults& faults)
      : NamesReading("fit", names, faults), diagram(diagram), parameters(parameters) {}

  bool is_swept(const std::string& name) const;
};

/// Reads the value of `parameters`, what one of them has, and that of one of `curves`.
void read_fit_parameters(FitRequest& request, const Node& node, const FitReading& read);
const Key& fit_parameter_form();
const Key& fit_curve_form();

}  // namespace stepwire
