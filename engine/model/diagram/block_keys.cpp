#include "engine/model/diagram/block_keys.hpp"

#include <algorithm>

namespace stepwire::diagram {

std::string initial_key(const BlockType& type, const StateSpec& state) {
  const auto settable =
      std::count_if(type.states.begin(), type.states.end(), [](const StateSpec& s) { return s.settable; });
  return settable == 1 ? "initial" : "initial_" + state.name;
}

std::vector<std::string> keys_of(const BlockType& type) {
  std::vector<std::string> keys;
  for (const ParameterSpec& parameter : type.parameters) keys.push_back(parameter.name);
  for (const InputSpec& input : type.inputs) keys.push_back(input.name);
  for (const StateSpec& state : type.states)
    if (state.settable) keys.push_back(initial_key(type, state));
  if (!type.presets.empty()) keys.push_back("preset");
  if (!type.has_continuous_state()) keys.push_back("every");
  return keys;
}

}  // namespace stepwire::diagram
