#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::fmu {

/// How a unit is made.
struct ExportOptions {
  int version = 3;                   ///< of FMI: 3 or 2
  std::string name;                  ///< that of the diagram's file, without its ending, or another
  std::string made_by;               ///< which program of which version makes it
  std::string drawing{};             ///< of the diagram, as SVG; empty: the unit has no picture
  std::string icon{};                ///< the same as PNG; empty: the unit has no icon
  std::vector<std::string> flags{};  ///< of the compiler, besides those of all generated code
};

/// A unit, and what is to be said of it.
struct UnitExport {
  std::map<std::string, std::string> files;  ///< by their paths in the archive
  std::string no_exchange;                   ///< why it has no model exchange; empty where it has
};

/// A plan as a unit of FMI. Throws Error for what cannot be generated and for names that become one,
/// EnvironmentError where the compiler does not make the binary.
UnitExport export_unit(const plan::Plan& plan, const codegen::Tuning& tuning, const ExportOptions& options,
                       const codegen::Compiler& compiler);

}  // namespace stepwire::fmu
