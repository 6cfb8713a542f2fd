#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// An analysis with a name, by which figures and claims read what it found.
struct NamedAnalysis {
  std::string name;
  Request request;
  std::optional<double> feedback{};            ///< in the place of the request's own
  std::optional<unit::Dimension> dimension{};  ///< of output over input
};

/// The form of the section `linear`.
const yaml::Key& linear_form();

/// Reads the value under the key `linear`: {NAME: {from: .., to: ..}}. The signals must be there, each with
/// one element. Everything that is wrong goes to `faults`.
std::vector<NamedAnalysis> read_linear(const yaml::Node& node, const query::SymbolTable& names,
                                       const plan::Plan& plan, yaml::Faults& faults);

}  // namespace stepwire::linear
