#pragma once

#include <map>
#include <string>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// Options of a generated program.
struct ProgramOptions {
  std::string name;     ///< Name of the program; by default that of the diagram's file without extension.
  std::string made_by;  ///< Name and version of the generator.
  bool c_interface = false;    ///< True for an interface to C.
  bool between_ticks = false;  ///< True for an interface to external solvers.
};

/// Names of a program in its own files. None of them is a word of C++, of a library or of CMake.
struct ProgramNames {
  /// Derives the names from the name of the options.
  explicit ProgramNames(const std::string& name);

  std::string stem;   ///< "rig", for files and the program
  std::string space;  ///< namespace
  std::string header, source;
  std::string main, c_header, c_source;  ///< with '_' where the name has '-'
};

/// Generates a standalone program from a plan, as texts by file name.
///
/// The files are a header with one struct, its source, a main() that records the same as a run of the file,
/// and the headers of blocks. A CMakeLists.txt builds a library and that program. Throws Error for anything
/// that cannot be generated, with its line.
std::map<std::string, std::string> program_files(const plan::Plan& plan, const Tuning& tuning,
                                                 const ProgramOptions& options);

/// True if some of these files include headers of Eigen, which a program does not contain.
bool needs_eigen(const std::map<std::string, std::string>& files);

/// Returns the lines of a CMakeLists.txt that give the target SLEEF's elementary functions where the host has
/// them.
std::string sleef_search(const std::string& target);

/// Returns the include folders of those files for foreign headers, without those of the program and
/// stepwire/.
std::vector<std::string> header_folders(const plan::Plan& plan);

}  // namespace stepwire::codegen
