#pragma once

namespace stepwire::run {

/// Engine that computes a run. The results are the same to the last bit.
enum class ExecutionMode {
  interpreted,
  compiled,  ///< compiled from the first tick; interpreted if nothing can be compiled
  automatic  ///< interpreted first; compiled once the code is worth its compile time and is ready
};

}  // namespace stepwire::run
