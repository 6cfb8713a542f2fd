#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/state_space.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// What the section `trim` says of a state, an input or an output.
struct TrimEntry {
  WrittenName name;
  std::optional<double> fixed;  ///< it is this; else it is found
  std::optional<double> start;  ///< from where it is looked for; without it the file's own value
  std::optional<double> lower, upper;
  bool steady = true;  ///< of a state: its rate is 0
};

/// The section `trim`: an operating point that is looked for. States that it does not name are free and
/// steady, inputs as the file has them, outputs anything.
struct TrimRequest {
  std::vector<TrimEntry> states, inputs, outputs;
  double time = 0.0;  ///< for which sources count [s]
};

/// A number of the point that was found.
struct TrimmedValue {
  Channel channel;
  double value = 0.0;
  bool free = false, at_bound = false;
  std::string setting;  ///< the name by which --set sets it; empty where no file can
};

struct TrimResult {
  std::vector<TrimmedValue> states, inputs, outputs;
  std::vector<std::pair<Channel, double>> residuals;  ///< rates, and outputs less what is wanted
  double largest = 0.0;                               ///< of them, each as a share of 1 or of its number
  bool converged = false;
  std::size_t iterations = 0;
};

const yaml::Key& trim_form();

/// Reads the value under the key `trim`. Everything that is wrong goes to `faults`.
TrimRequest read_trim(const yaml::Node& node, const query::SymbolTable& names, const plan::Plan& plan,
                      yaml::Faults& faults);

/// Looks for the point by Levenberg-Marquardt within the bounds: of a diagram in which something acts at
/// ticks, one that is the same a base period later. Throws Error.
TrimResult trim(const diagram::Diagram& diagram, const TrimRequest& request);

}  // namespace stepwire::linear
