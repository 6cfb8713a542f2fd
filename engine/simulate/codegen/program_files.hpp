#pragma once

#include <map>
#include <string>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// How a program is written.
struct ProgramOptions {
  std::string name;            ///< that of the diagram's file, without its ending, or another
  std::string made_by;         ///< which program of which version wrote it
  bool c_interface = false;    ///< to be called from C as well
  bool between_ticks = false;  ///< for solvers of others as well; why_ticks_only() has to be empty
};

/// What a program is called in its own files. Each is a word that is none of C++, of a library or of CMake.
struct ProgramNames {
  /// From the name of the options.
  explicit ProgramNames(const std::string& name);

  std::string stem;   ///< "rig", of files and of the program
  std::string space;  ///< the namespace
  std::string header, source;
  std::string main, c_header, c_source;  ///< no identifier has a '-'
};

/// A plan as a program of its own, by file name: a header with one struct, its source, a main() that writes
/// what the diagram records as the file's run does, a CMakeLists.txt with a library and that program, and the
/// headers of blocks that they need. Throws Error for what cannot be generated, with its line.
std::map<std::string, std::string> program_files(const plan::Plan& plan, const Tuning& tuning,
                                                 const ProgramOptions& options);

/// True where some of these files include headers of Eigen, which no program holds itself.
bool needs_eigen(const std::map<std::string, std::string>& files);

/// Folders of those files, besides that of the program and stepwire/, in which headers of others are looked
/// for.
std::vector<std::string> header_folders(const plan::Plan& plan);

}  // namespace stepwire::codegen
