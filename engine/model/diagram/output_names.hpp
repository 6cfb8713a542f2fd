#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"

namespace stepwire::diagram {

/// True for a further output of the state that the first output already shows. It is the state itself, even
/// where outputs() computes the first output: Integrator.before.
inline bool is_bare_state(const BlockType& type, std::size_t output) {
  return output > 0 && !type.outputs[output].state.empty() &&
         type.outputs[output].state == type.outputs[0].state;
}

/// True where the name of the block alone denotes its first output.
inline bool has_one_output(const BlockType& type) {
  if (type.outputs.empty()) return false;
  for (std::size_t o = 1; o < type.outputs.size(); ++o)
    if (!is_bare_state(type, o)) return false;
  return true;
}

/// Returns the name of an output for readers: "lag", "rig.position".
inline std::string output_name(const std::string& block, const BlockType& type, std::size_t output) {
  return output == 0 && has_one_output(type) ? block : block + "." + type.outputs[output].name;
}

}  // namespace stepwire::diagram
