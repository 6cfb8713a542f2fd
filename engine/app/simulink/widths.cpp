// The number of elements of signals, as far as it follows from the blocks before them.
#include <algorithm>

#include "engine/app/simulink/flat_model.hpp"

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

}  // namespace

std::size_t FlatModel::width(const std::string& source, int depth) {
  if (source == "0") return 1;
  const auto at = token_of(source);
  if (!at || depth > max_depth) return 0;
  if (const auto known = widths_.find(*at); known != widths_.end()) return known->second;
  widths_[*at] = 0;  // of a loop
  const std::size_t found = width_of(blocks_[at->first], at->second, depth + 1);
  widths_[*at] = found;
  return found;
}

std::size_t FlatModel::width_of(FlatBlock& flat, int port, int depth) {
  const Block& block = *flat.block;
  Instance& in = *flat.in;
  const auto numbers = [&](const char* name) {
    try {
      const Value value = evaluate(in, text_of(model_, block, name, "1"));
      return value.is_missing ? std::size_t{0} : value.cells.size();
    } catch (const ValueError&) {
      return std::size_t{0};
    }
  };
  if (ends_in_one_number(block.type)) return 1;
  if (block.type == "Constant") return numbers("Value");
  if (block.type == "SubSystem" || block.type == "Reference" || block.type == "StateSpace" || port > 1)
    return 0;
  const bool is_sum = block.type == "Mux" || block.type == "Concatenate" || block.type == "VectorConcatenate";
  std::size_t sum = 0, most = 1;
  for (int i = 1; is_connected(in, block, "in:" + std::to_string(i)); ++i) {
    const std::size_t one = width(source(in, block, "in:" + std::to_string(i)), depth);
    if (one == 0) return 0;
    sum += one;
    most = std::max(most, one);
  }
  if (is_sum) return sum;
  if (block.type == "Gain") return numbers("Gain") == 1 ? most : 0;
  static const std::set<std::string> by_element{
      "Sum",       "Product",      "Abs",           "Signum",    "UnaryMinus",         "Sqrt",
      "Math",      "Trigonometry", "Saturate",      "DeadZone",  "RelationalOperator", "Logic",
      "UnitDelay", "Memory",       "ZeroOrderHold", "Quantizer", "Rounding",           "RateLimiter"};
  static const std::set<std::string> by_value{"Step", "Sin", "DiscretePulseGenerator", "Integrator", "Bias"};
  if (by_value.contains(block.type)) {
    for (const char* name : {"After", "Before", "Time", "Amplitude", "Frequency", "Bias", "InitialCondition"})
      if (block.texts.contains(name)) most = std::max(most, numbers(name));
    return most;
  }
  return by_element.contains(block.type) ? most : 0;
}

}  // namespace stepwire::simulink
