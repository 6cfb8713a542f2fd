#pragma once

#include "engine/model/signal/index.hpp"

namespace stepwire {

/// Pointer to numbers of one run. They are contiguous, or `lanes` apart in generated code that steps a lane
/// batch.
struct Lane {
  double* first;
  operator double*() const { return first; }
  double& operator[](Index n) const { return first[n * lanes]; }
  Lane operator+(Index n) const { return {first + n * lanes}; }
};

}  // namespace stepwire
