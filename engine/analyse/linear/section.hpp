#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// A named analysis; figures and claims read its results by this name.
struct NamedAnalysis {
  std::string name;
  Request request;
  std::optional<double> feedback{};            ///< Replaces the feedback of the request.
  std::optional<unit::Dimension> dimension{};  ///< Dimension of output over input.
};

/// Returns the schema of the section `linear`.
const yaml::Key& linear_form();

/// Reads the value under the key `linear`: {NAME: {from: .., to: ..}}. The signals must exist and have one
/// element each. Adds all faults to `faults`.
std::vector<NamedAnalysis> read_linear(const yaml::Node& node, const query::SymbolTable& names,
                                       const plan::Plan& plan, yaml::Faults& faults);

}  // namespace stepwire::linear
