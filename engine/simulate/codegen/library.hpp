#pragma once

#include <functional>
#include <string>
#include <utility>

#include "engine/base/io/cache.hpp"
#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/program.hpp"

namespace stepwire::codegen {

/// Flags for code with these headers that only this machine will run. Eigen adds in an order that depends on
/// the processor it is compiled for, and the interpreter is compiled for any: only code without it, and
/// without other libraries, gives the same bits when it is compiled for this one.
std::vector<std::string> flags_for_this_machine(const std::vector<std::string>& headers);

/// Loads a shared library for good: these very bytes, whatever becomes of the file that they were read from.
/// Null where that fails, and `problem` says why.
void* load_library(const std::string& bytes, std::string& problem);

/// Returns the flags by which a library calls its own functions only. The program exports functions of the
/// same names, of libraries such as Eigen, too, which are compiled for another processor.
std::vector<std::string> library_flags();

/// Returns the beginning of a library's source: its headers. It gives the namespace of the blocks another
/// name than in the program: classes have fewer members in generated code, and numbers of lanes between them.
/// One name never means two classes in a process.
std::string library_head(const std::vector<std::string>& headers, int lanes);

/// Returns the source of a shared library with a program's functions.
std::string library_source(const GeneratedProgram& program);

/// What a compiled program has.
struct ProgramFunctions {
  plan::StepFunctions steps;                    ///< of one for one run
  void (*run)(plan::LaneTask& task) = nullptr;  ///< of one for several
  explicit operator bool() const { return run || (steps.evaluate && steps.advance); }
};

/// Compiled programs, kept so that the same diagram is compiled once.
class CodeCache {
 public:
  explicit CodeCache(io::Cache cache = io::Cache()) : cache_(std::move(cache)) {}

  /// Returns a sentence on the fault of new code; an empty one if there is none.
  using Trial = std::function<std::string(const ProgramFunctions&)>;

  /// Returns the functions of a program, from the cache or compiled; they stay loaded. On failure they are
  /// null and `problem` has the reason, but for that of the limits. Compiled code is kept once its trial
  /// finds nothing.
  ProgramFunctions load(const GeneratedProgram& program, const Compiler& compiler,
                        const plan::CodeLimits& limits, const Trial& trial, std::string& problem) const;

 private:
  io::Cache cache_;
};

}  // namespace stepwire::codegen
