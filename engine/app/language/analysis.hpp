#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/app/language/diagram_files.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire::language {

/// Result of analysing a diagram file.
struct Analysis {
  std::shared_ptr<const diagram::UnfinishedDiagram> draft;  ///< nullptr if the file is no YAML.
  std::vector<yaml::Fault> faults;                          ///< Faults as `stepwire check` finds them.
  std::vector<std::string> uses;                            ///< Files on which the result depends.
  /// Prefix of the file's names in the draft: "part." for a part, which the draft contains within a generated
  /// diagram.
  std::string prefix;
  int scope = 0;  ///< scope of the file in the draft
};

/// Depth of an analysis: up to blocks and wires with their units, these with their sizes, or everything that
/// `stepwire check` does. The sizes of a part are those of its user and are not checked.
enum class Depth { draft, sizes, model };

/// Analyses a file. A file that is no diagram gets neither draft nor faults. A part is analysed within a
/// generated diagram, with zeros at its inputs.
Analysis analyse(DiagramFiles& files, const std::string& file, Depth depth = Depth::model);

}  // namespace stepwire::language
