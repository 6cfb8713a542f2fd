#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::fmu {

/// Options of export_unit().
struct ExportOptions {
  int version = 3;                   ///< Major version of FMI: 3 or 2.
  std::string name;                  ///< Model name, by default the stem of the diagram's file name.
  std::string made_by;               ///< Name and version of the exporting program.
  std::string drawing{};             ///< SVG of the diagram; empty: no picture.
  std::string icon{};                ///< PNG of the diagram; empty: no icon.
  std::vector<std::string> flags{};  ///< Additional compiler flags.
};

/// Files of a unit, and a note on it.
struct UnitExport {
  std::map<std::string, std::string> files;  ///< content by path in the archive
  std::string no_exchange;                   ///< reason for missing model exchange; empty if it is supported
};

/// Exports a plan as an FMI unit. Throws Error for blocks that cannot be generated and for names that
/// coincide; EnvironmentError if the compilation fails.
UnitExport export_unit(const plan::Plan& plan, const codegen::Tuning& tuning, const ExportOptions& options,
                       const codegen::Compiler& compiler);

}  // namespace stepwire::fmu
