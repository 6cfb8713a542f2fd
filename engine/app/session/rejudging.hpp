#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/app/session/monitor.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::session {

/// Line in which a file differs from a computed text; an absent line is empty.
struct DifferentLine {
  std::size_t number;
  std::string there, computed;
};

/// Returns the first line in which a file differs from a text; std::nullopt if none does. Throws
/// EnvironmentError.
std::optional<DifferentLine> first_difference(const std::string& path, const std::string& computed);

/// Result of computing claims and tables of a folder again.
struct Rejudged {
  std::string difference{};  ///< first line that differs, with its place; empty without one
  std::string left_out{};    ///< reason why they were not computed; empty if they were
  bool interrupted = false;
  std::string note{};  ///< how the file differs from the run, although both may be right; empty if it does not
};

/// Compares run.json with the flattened diagram of its folder, and with the diagram file of the run. Then the
/// file runs again with the values that were set, and claims.json is compared; of a study also trials, errors
/// and tables. Without a readable file these are left out. Throws Error and EnvironmentError.
Rejudged rejudge(const std::string& folder, const Registry& registry, const Monitor& monitor);

}  // namespace stepwire::session
