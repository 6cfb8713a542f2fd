#pragma once

#include <map>
#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire {

/// A plan as a program of its own, by file name: a header with one struct, its source, a main() that writes
/// what the diagram records as the file's run does, a CMakeLists.txt, and the headers of blocks that it
/// needs. `name` is that of the diagram's file, without its ending; `made_by` says which program of which
/// version wrote it. Throws Error for what cannot be generated, with its line.
std::map<std::string, std::string> program_files(const Plan& plan, const std::string& name,
                                                 const std::string& made_by);

}  // namespace stepwire
