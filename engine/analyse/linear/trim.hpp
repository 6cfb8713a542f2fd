#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/state_space.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/base/result/record.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// Entry of the section `trim` for a state, an input or an output.
struct TrimEntry {
  WrittenName name;
  std::optional<double> fixed;  ///< Given value; std::nullopt: the value is a result.
  std::optional<double> start;  ///< Start of the search; std::nullopt: the file's own value.
  std::optional<double> lower, upper;
  bool steady = true;  ///< For a state: its derivative must be 0.
};

/// The section `trim`: a search for an operating point. States without an entry are free and steady, inputs
/// have the file's value, outputs are unconstrained.
struct TrimRequest {
  std::vector<TrimEntry> states, inputs, outputs;
  double time = 0.0;  ///< Time at which sources are evaluated [s].
  yaml::Place at{};   ///< Place of the time in the file.
};

/// A number of the operating point.
struct TrimmedValue {
  Channel channel;
  double value = 0.0;
  bool free = false, at_bound = false;
  std::string setting;  ///< Name for --set; empty if no file can set it.
};

struct TrimResult {
  std::string file{};  ///< Diagram file.
  std::vector<TrimmedValue> states, inputs, outputs;
  std::vector<std::pair<Channel, double>> residuals;  ///< Derivatives, and outputs minus their targets.
  double largest = 0.0;  ///< Largest residual, each as a share of 1 or of its number.
  bool converged = false;
  std::size_t iterations = 0;
  std::size_t undetermined = 0;  ///< Free numbers that the conditions leave open: the point is one of many.
};

const yaml::Key& trim_form();

/// Reads the value under the key `trim`. Adds all faults to `faults`.
TrimRequest read_trim(const yaml::Node& node, const query::SymbolTable& names, const plan::Plan& plan,
                      yaml::Faults& faults);

/// Finds the operating point by the Levenberg-Marquardt method within the bounds. If blocks act at ticks, the
/// point must repeat after a base period. Throws Error.
TrimResult trim(const diagram::Diagram& diagram, const TrimRequest& request);

/// Declares the fields of trim.json.
void declare(result::Record<TrimResult>& is);

}  // namespace stepwire::linear
