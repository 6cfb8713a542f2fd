#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::language {

/// Signal under its name in a file.
struct KnownSignal {
  std::string name;
  std::optional<unit::Dimension> dimension;  ///< std::nullopt if unknown
  std::string what;                          ///< origin: "Lag", "part", "input"
};

/// Returns the signals that can be wired in a file: outputs of its blocks and parts, and its inputs. With
/// `inside` also the states and the signals within parts, which can be recorded.
std::vector<KnownSignal> signals_of(const Analysis& analysis, DiagramFiles& files, const std::string& file,
                                    bool inside);
/// Returns the names for figures and claims: recorded signals, `time` and swept parameters.
std::vector<KnownSignal> recorded_of(const Analysis& analysis);

/// Returns the unit of an input of a block; std::nullopt if unknown.
std::optional<unit::Dimension> unit_of_input(const Analysis& analysis, const std::string& block,
                                             const std::string& key);

/// Returns a parameter of the file by name; nullptr if the draft has none.
const diagram::DiagramParameter* parameter_of(const Analysis& analysis, const std::string& name);

}  // namespace stepwire::language
