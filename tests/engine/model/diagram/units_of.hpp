#pragma once

#include <string>

#include "engine/base/unit/unit.hpp"
#include "engine/model/plan/plan.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire {

/// The units of the elements of a block's first output.
inline std::string units_of(const plan::Plan& plan, const std::string& name) {
  std::string units;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    if (plan.diagram.blocks[b].name != name) continue;
    for (Eigen::Index k = 0; k < plan.blocks[b].outputs[0].size; ++k) {
      const auto dimension = plan.dimension({static_cast<int>(b), 0, -1, {k + 1, 0}});
      units += (k > 0 ? ", " : "") + (dimension ? unit::si_name(*dimension) : std::string("?"));
    }
  }
  return units;
}

inline std::string units_of(const std::string& text, const std::string& name) {
  return units_of(plan_text(text), name);
}

}  // namespace stepwire
