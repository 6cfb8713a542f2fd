#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace stepwire::broken {

using Texts = std::vector<std::pair<std::string, std::string>>;

/// Texts and settings that make a diagram shorter, so that a change takes less time.
struct Cut {
  Texts replaced;
  std::vector<diagram::Setting> settings;
};

/// One thing that is done to a diagram, and the claims that must fail after it and hold without it.
struct Change {
  std::string what;
  std::string in;  ///< beside the figure's file; empty: that file itself
  Cut cut;         ///< made before the change, and alone
  Texts replaced;
  std::vector<diagram::Setting> settings;
  std::vector<std::string> fails;  ///< first words of claims
};

/// Content of a file of this folder: the changes of one diagram, and the exceptions with their reasons.
struct Broken {
  Texts always;  ///< replaced in the diagram before all else
  std::vector<Change> changes;
  Texts unmoved;
  Texts unseen;

  /// Returns true where the name is listed with a reason.
  static bool lists(const Texts& listed, const std::string& name);
};

/// Reads such a file. Throws Error if it is no YAML, and std::runtime_error if its content has another form.
Broken read_broken(const std::string& file);

}  // namespace stepwire::broken
