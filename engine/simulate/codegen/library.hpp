#pragma once

#include <functional>
#include <string>
#include <utility>

#include "engine/base/io/cache.hpp"
#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/program.hpp"

namespace stepwire::codegen {

/// Returns the flags for code with these headers that only this machine will run. Eigen adds in an order that
/// depends on the target processor, and the interpreter is compiled for a generic one. So only code without
/// Eigen and other libraries is compiled for this processor and still has the same bits.
std::vector<std::string> flags_for_this_machine(const std::vector<std::string>& headers);

/// Loads a shared library permanently from these bytes, independent of the file that they were read from. On
/// failure returns nullptr, with the reason in `problem`.
void* load_library(const std::string& bytes, std::string& problem);

/// Returns the flags that bind a library to its own functions. The executable exports functions of the same
/// names, of libraries such as Eigen, that are compiled for another processor.
std::vector<std::string> library_flags();

/// Returns the flags of a program, without its include folders. In lanes the vector width is the number of
/// lanes.
std::vector<std::string> flags_of(const GeneratedProgram& program);

/// Returns the beginning of a library's source: its headers. The namespace of the blocks is renamed, because
/// classes have fewer members in generated code, depending on the number of lanes. A name must not denote two
/// classes in one process. The elementary functions are those of the C library, or those of SLEEF.
std::string library_head(const std::vector<std::string>& headers, int lanes, bool uses_libm = false);

/// Returns the source of a shared library with a program's functions.
std::string library_source(const GeneratedProgram& program);

/// Functions of a compiled program.
struct ProgramFunctions {
  plan::StepFunctions steps;                    ///< set in a program for one run
  void (*run)(plan::LaneTask& task) = nullptr;  ///< set in a program for lanes
  explicit operator bool() const { return run || (steps.evaluate && steps.advance); }
};

/// Cache of compiled programs.
class CodeCache {
 public:
  explicit CodeCache(io::Cache cache = io::Cache()) : cache_(std::move(cache)) {}

  /// Returns a sentence on the fault of new code; an empty text without one.
  using Trial = std::function<std::string(const ProgramFunctions&)>;

  /// Returns the functions of a program, from the cache or compiled; they stay loaded. On failure they are
  /// nullptr and `problem` has the reason, except for a failure by the limits. Compiled code is cached if its
  /// trial finds no fault.
  ProgramFunctions load(const GeneratedProgram& program, const Compiler& compiler,
                        const plan::CodeLimits& limits, const Trial& trial, std::string& problem) const;

 private:
  io::Cache cache_;
};

}  // namespace stepwire::codegen
