#include "engine/model/diagram/block_keys.hpp"

#include <algorithm>

namespace stepwire::diagram {

std::string initial_key(const BlockType& type, const StateSpec& state) {
  const auto settable =
      std::count_if(type.states.begin(), type.states.end(), [](const StateSpec& s) { return s.settable; });
  return settable == 1 ? "initial" : "initial_" + state.name;
}

int state_of_key(const BlockType& type, const std::string& key) {
  if (!key.starts_with("initial")) return -1;
  for (std::size_t i = 0; i < type.states.size(); ++i)
    if (type.states[i].settable && initial_key(type, type.states[i]) == key) return static_cast<int>(i);
  return -1;
}

bool has_value(const BlockType& type, const std::string& key) {
  return type.parameter(key) || state_of_key(type, key) >= 0;
}

std::vector<std::string> keys_of(const BlockType& type) {
  std::vector<std::string> keys;
  for (const ParameterSpec& parameter : type.parameters) keys.push_back(parameter.name);
  for (const InputSpec& input : type.inputs)
    if (!has_value(type, input.name)) keys.push_back(input.name);
  for (const StateSpec& state : type.states)
    if (state.settable) keys.push_back(initial_key(type, state));
  if (!type.presets.empty()) keys.push_back("preset");
  if (!type.has_continuous_state()) keys.push_back("every");
  for (const char* key : {"enable", "trigger"})
    if (type.input(key) < 0 && !type.parameter(key)) keys.push_back(key);
  return keys;
}

}  // namespace stepwire::diagram
