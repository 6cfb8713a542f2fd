#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/random/batch_code.hpp"
#include "tests/random/outcome.hpp"

namespace stepwire::random {

/// A valid diagram, and its run in the interpreter.
struct Trial {
  std::uint64_t seed = 0;
  Sketch sketch;
  const Registry* registry = nullptr;
  std::string folder;  ///< with the data files that diagrams name
  std::unique_ptr<Loaded> loaded{};
  run::RunResult expected{};
};

/// Loads and runs it. Throws yaml::Error where the loader refuses it.
void begin(Trial& trial);

/// Outcome of a law for one diagram.
struct Verdict {
  enum class Kind { same, different, skipped };

  Kind kind = Kind::same;
  std::string text{};  ///< the difference, or the reason for which nothing was compared
};

/// Two ways to the same numbers.
struct Law {
  const char* name;
  Verdict (*check)(const Trial& trial, BatchCode& code);
  std::uint64_t every = 1,
                from = 0;  ///< it is tried on the seeds from, from + every, ...
  bool asks = false;       ///< the first call notes the code that it takes
  bool isolated = false;   ///< code of it may end the process

  bool is_for(std::uint64_t seed) const { return seed % every == from; }
};

/// All laws, each of which holds for every diagram.
const std::vector<Law>& laws();

}  // namespace stepwire::random
