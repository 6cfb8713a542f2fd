#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace stepwire::broken {

using Texts = std::vector<std::pair<std::string, std::string>>;

/// One thing that is done to a diagram, and the claims that must fail after it.
struct Change {
  std::string what;
  std::string in;  ///< beside the figure's file; empty: that file itself
  Texts replaced;
  std::vector<diagram::Setting> settings;
  std::vector<std::string> fails;  ///< first words of claims
};

/// What a file of this folder says of its diagram.
struct Broken {
  Texts always;  ///< replaced in the diagram before all else
  std::vector<Change> changes;
  Texts unmoved;
  Texts unseen;

  /// Returns true where the name is listed with a reason.
  static bool lists(const Texts& listed, const std::string& name);
};

/// The name under `unseen` for all wrong pictures of a file.
inline constexpr const char* all_pictures = "all";

/// Throws Error where it is no YAML, runtime_error where it says something else.
Broken read_broken(const std::string& file);

}  // namespace stepwire::broken
