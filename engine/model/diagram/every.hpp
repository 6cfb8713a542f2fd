#pragma once

#include "engine/base/yaml/key.hpp"

namespace stepwire::diagram {

/// Times at which sampled blocks run: `offset`, and each `period` after it [s].
struct Every {
  double period = 0.0;  ///< above 0
  double offset = 0.0;  ///< at least 0, below the period

  bool operator==(const Every&) const = default;
};

/// Returns the form of the key `every` of a block or part: a period, or `{period: 3 ms, offset: 1 ms}`.
yaml::Key every_key(const std::string& doc);

}  // namespace stepwire::diagram
