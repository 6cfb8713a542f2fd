#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::language {

/// A signal as a file calls it.
struct KnownSignal {
  std::string name;
  std::optional<unit::Dimension> dimension;  ///< none where it is not known
  std::string what;                          ///< what makes it: "Lag", "part", "input"
};

/// What may be wired in a file: outputs of its blocks and parts, and its inputs. With `inside` also states,
/// and what lies inside of parts, which may be recorded.
std::vector<KnownSignal> signals_of(const Analysis& analysis, DiagramFiles& files, const std::string& file,
                                    bool inside);
/// Those that the file records, `time` and what it sweeps: what figures and claims may name.
std::vector<KnownSignal> recorded_of(const Analysis& analysis);

/// The unit that a key of a block in a file takes; nothing where it is not known.
std::optional<unit::Dimension> unit_of_input(const Analysis& analysis, const std::string& block,
                                             const std::string& key);

/// The parameter of that name in a file; nullptr where the draft has none.
const diagram::DiagramParameter* parameter_of(const Analysis& analysis, const std::string& name);

}  // namespace stepwire::language
