#include "engine/generate/compiler.hpp"

#include <cstdlib>

#include "engine/generate/process.hpp"

namespace stepwire {

namespace {

/// Functions that a compiler knows, and may compute while it compiles, rounded otherwise than the library
/// does.
constexpr const char* library_functions[] = {"sin",  "cos",   "tan",  "asin", "acos",  "atan", "atan2",
                                             "sinh", "cosh",  "tanh", "exp",  "expm1", "log",  "log1p",
                                             "log2", "log10", "pow",  "cbrt", "hypot", "fmod"};

}  // namespace

Compiler::Compiler() {
  std::vector<std::string> candidates{"c++", "g++", "clang++"};
  const char* chosen = std::getenv("CXX");
  if (chosen && *chosen) candidates.insert(candidates.begin(), chosen);
  for (const std::string& candidate : candidates) {
    const ProcessResult result = run_process({candidate, "--version"});
    if (result.status != 0) continue;
    path_ = candidate;
    version_ = result.output.substr(0, result.output.find('\n'));
    return;
  }
}

std::vector<std::string> Compiler::flags() {
  std::vector<std::string> flags{"-std=c++20", "-O3", "-DNDEBUG", "-ffp-contract=off"};
  for (const char* function : library_functions) flags.push_back(std::string("-fno-builtin-") + function);
  return flags;
}

std::string Compiler::compile(const std::string& source, const std::string& library,
                              const std::vector<std::string>& more, const std::stop_token& stop) const {
  std::vector<std::string> command{path_};
  for (const std::string& flag : flags()) command.push_back(flag);
  command.insert(command.end(), more.begin(), more.end());
  // What these passes find in straight-line code is little, and the first one's time grows with its square.
  if (version_.find("clang") == std::string::npos)
    command.insert(command.end(), {"-fno-tree-pta", "-fno-tree-slp-vectorize"});
  for (const char* argument : {"-shared", "-fPIC", "-w", "-I"}) command.push_back(argument);
  command.insert(command.end(), {source_folder(), "-isystem", STEPWIRE_EIGEN, "-o", library, source});
  const ProcessResult result = run_process(command, stop);
  if (result.status == 0) return "";
  return result.output.empty() ? "the compiler could not be run, or was stopped" : result.output;
}

std::string source_folder() {
  return STEPWIRE_SOURCES;
}

}  // namespace stepwire
