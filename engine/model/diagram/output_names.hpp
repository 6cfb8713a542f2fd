#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"

namespace stepwire::diagram {

/// Does this output show the state that the first output shows, too? Then it is that state as it is, also
/// where outputs() computes the first one: Integrator.before.
inline bool is_bare_state(const BlockType& type, std::size_t output) {
  return output > 0 && !type.outputs[output].state.empty() &&
         type.outputs[output].state == type.outputs[0].state;
}

/// Does the name of a block alone stand for its first output?
inline bool has_one_output(const BlockType& type) {
  if (type.outputs.empty()) return false;
  for (std::size_t o = 1; o < type.outputs.size(); ++o)
    if (!is_bare_state(type, o)) return false;
  return true;
}

/// The name of an output as others read it: "lag", "rig.position".
inline std::string output_name(const std::string& block, const BlockType& type, std::size_t output) {
  return output == 0 && has_one_output(type) ? block : block + "." + type.outputs[output].name;
}

}  // namespace stepwire::diagram
