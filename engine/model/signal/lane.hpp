#pragma once

#include "engine/model/signal/index.hpp"

namespace stepwire {

/// The numbers of one run, from one of them on: one behind the other, or `lanes` apart where generated code
/// steps several runs together.
struct Lane {
  double* first;
  operator double*() const { return first; }
  double& operator[](Index n) const { return first[n * lanes]; }
  Lane operator+(Index n) const { return {first + n * lanes}; }
};

}  // namespace stepwire
