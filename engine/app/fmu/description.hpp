#pragma once

#include <string>
#include <vector>

#include "engine/app/fmu/variables.hpp"

namespace stepwire::fmu {

/// Content of a model description except its variables.
struct UnitAbout {
  int version = 3;         ///< major version of FMI
  std::string name;        ///< name of the model
  std::string identifier;  ///< model identifier, the name of the binary
  std::string title, made_by;
  std::string token;
  std::string source;  ///< file name of the compiled source; unlike that of the diagram's source it is no C++
                       ///< identifier
  double step = 0.0, stop = 0.0;
  bool exchange = false;
  std::size_t crossings = 0;
  bool smooth = false;  ///< true if no source in the diagram can jump
};

/// Returns modelDescription.xml of FMI 3 or FMI 2. The variables must be those of that version.
std::string description_text(const UnitAbout& about, const std::vector<Variable>& variables);

}  // namespace stepwire::fmu
