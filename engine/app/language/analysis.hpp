#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/app/language/diagram_files.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire::language {

/// What a diagram file is, and all that is wrong with it.
struct Analysis {
  std::shared_ptr<const diagram::UnfinishedDiagram> draft;  ///< null where the file is no YAML
  std::vector<yaml::Fault> faults;                          ///< what `stepwire check` finds
  std::vector<std::string> uses;                            ///< the files that it was made of
  /// Before each name of the file in the draft: "part." for a part, which the draft has inside of a diagram.
  std::string prefix;
  int scope = 0;  ///< of the file in the draft
};

/// How far a file is looked at: to its blocks and wires, or to all that `stepwire check` does.
enum class Depth { draft, model };

/// Loads a file; one that is no diagram has neither draft nor faults, and one that is used as a part only
/// with zeros at its inputs.
Analysis analyse(DiagramFiles& files, const std::string& file, Depth depth = Depth::model);

}  // namespace stepwire::language
