#pragma once

#include <map>
#include <string>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// How a program is written.
struct ProgramOptions {
  std::string name;          ///< that of the diagram's file, without its ending, or another
  std::string made_by;       ///< which program of which version wrote it
  bool c_interface = false;  ///< to be called from C as well
};

/// A plan as a program of its own, by file name: a header with one struct, its source, a main() that writes
/// what the diagram records as the file's run does, a CMakeLists.txt with a library and that program, and the
/// headers of blocks that they need. Throws Error for what cannot be generated, with its line.
std::map<std::string, std::string> program_files(const plan::Plan& plan, const Tuning& tuning,
                                                 const ProgramOptions& options);

}  // namespace stepwire::codegen
