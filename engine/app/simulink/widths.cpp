#include <algorithm>

#include "engine/app/simulink/widths.hpp"

namespace stepwire::simulink {

namespace {

constexpr int max_depth = 100;  // blocks in a row

bool ends_in_one_number(const std::string& type) {
  static const std::set<std::string> types{"TransferFcn",
                                           "ZeroPole",
                                           "DotProduct",
                                           "DiscreteTransferFcn",
                                           "DiscreteFilter",
                                           "Clock",
                                           "DigitalClock",
                                           "Demux",
                                           "Fcn",
                                           "Ground",
                                           "DiscreteZeroPole"};
  return types.contains(type);
}

bool is_by_element(const std::string& type) {
  static const std::set<std::string> types{
      "Sum",       "Product",  "Abs",           "Signum",    "UnaryMinus",         "Sqrt",
      "Math",      "Saturate", "Trigonometry",  "DeadZone",  "RelationalOperator", "Logic",
      "UnitDelay", "Memory",   "ZeroOrderHold", "Quantizer", "Rounding",           "RateLimiter"};
  return types.contains(type);
}

}  // namespace

std::size_t Widths::of(const std::string& source, int depth) {
  if (source == "0") return 1;
  const auto at = FlatModel::token_of(source);
  if (!at || depth > max_depth) return 0;
  if (const auto known = known_.find(*at); known != known_.end()) return known->second;
  known_[*at] = 0;  // of a loop
  const std::size_t found = of_block(model_.blocks()[at->first], at->second, depth + 1);
  known_[*at] = found;
  return found;
}

std::size_t Widths::of_parameter(const FlatBlock& flat, const char* name) {
  try {
    const Value value = model_.evaluate(*flat.in, text_of(model_.model(), *flat.block, name, "1"));
    return value.is_missing ? 0 : value.cells.size();
  } catch (const ValueError&) {
    return 0;
  }
}

std::size_t Widths::of_inputs(const FlatBlock& flat, bool adds, int depth) {
  std::size_t sum = 0, most = 1;
  for (int i = 1; model_.is_connected(*flat.in, *flat.block, "in:" + std::to_string(i)); ++i) {
    const std::size_t one = of(model_.source(*flat.in, *flat.block, "in:" + std::to_string(i)), depth);
    if (one == 0) return 0;
    sum += one;
    most = std::max(most, one);
  }
  return adds ? sum : most;
}

std::size_t Widths::of_block(const FlatBlock& flat, int port, int depth) {
  const std::string& type = flat.block->type;
  if (ends_in_one_number(type)) return 1;
  if (type == "Constant") return of_parameter(flat, "Value");
  if (port > 1) return 0;
  if (type == "Mux") return of_inputs(flat, true, depth);
  if (type == "Gain" && of_parameter(flat, "Gain") != 1) return 0;
  static const std::set<std::string> by_value{"Step", "Sin", "DiscretePulseGenerator", "Integrator", "Bias"};
  const bool has_values = by_value.contains(type);
  if (!has_values && type != "Gain" && !is_by_element(type)) return 0;
  std::size_t most = of_inputs(flat, false, depth);
  for (const char* name : {"After", "Before", "Time", "Amplitude", "Frequency", "Bias", "InitialCondition"})
    if (has_values && most > 0 && flat.block->texts.contains(name))
      most = std::max(most, of_parameter(flat, name));
  return most;
}

}  // namespace stepwire::simulink
