#pragma once

#include <string>
#include <vector>

#include "engine/app/fmu/variables.hpp"

namespace stepwire::fmu {

/// What a description says besides its variables.
struct UnitAbout {
  int version = 3;         ///< of FMI
  std::string name;        ///< of the model
  std::string identifier;  ///< of its binary
  std::string title, made_by;
  std::string token;
  std::string source;  ///< the one that is compiled; no identifier, so that it is not that of the diagram
  double step = 0.0, stop = 0.0;
  bool exchange = false;
  std::size_t crossings = 0;
  bool smooth = false;  ///< no source in it may jump
};

/// modelDescription.xml of FMI 3 or FMI 2; the variables are those of that version.
std::string description_text(const UnitAbout& about, const std::vector<Variable>& variables);

}  // namespace stepwire::fmu
