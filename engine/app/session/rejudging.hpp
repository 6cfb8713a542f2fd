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
};

/// Runs the diagram file of a recorded run again, with the values that were set. Compares claims.json and,
/// of a study, trials, errors and tables. They are left out if the file is now another diagram than that of
/// the run. Throws Error and EnvironmentError.
Rejudged rejudge(const std::string& folder, const Registry& registry, const Monitor& monitor);

}  // namespace stepwire::session
