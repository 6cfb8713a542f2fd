#pragma once

namespace stepwire::run {

/// How a run is computed. The results are the same to the last bit.
enum class ExecutionMode {
  interpreted,
  compiled,  ///< from the first tick on; where nothing can be compiled, interpreted
  automatic  ///< interpreted at first; compiled once that is worth it and ready
};

}  // namespace stepwire::run
