#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "engine/simulate/codegen/library.hpp"

namespace stepwire::codegen {

/// Source of compiled code for runs, with this machine's compiler and a cache. Thread-safe.
class GeneratedCode : public plan::CodeSource {
 public:
  /// New code is compared with the interpreter by `trial`, which must outlive this object, before it is used.
  explicit GeneratedCode(const plan::CodeTrial& trial) : trial_(trial) {}

  std::optional<plan::CompiledPlan> compile(const plan::Plan& plan,
                                            const std::vector<plan::VariableBlock>& variable,
                                            const plan::CodeLimits& limits) override;

  /// Compiles with as many lanes as a register of this machine's processor has.
  std::optional<plan::CompiledLanes> compile_lanes(const plan::Plan& plan,
                                                   const plan::RunDifferences& differences,
                                                   const plan::CodeLimits& limits, std::string& why) override;
  int lanes() override;

  /// Returns the reason of the first failure and clears it; an empty text without a failure.
  std::string take_problem();

 private:
  /// Returns the functions of a program. On failure `problem` has the reason, except for a failure by the
  /// limits.
  ProgramFunctions functions_of(const GeneratedProgram& program, const plan::CodeLimits& limits,
                                const CodeCache::Trial& trial, std::string& problem);
  /// Sets the function of lanes and returns true. Otherwise `why` has the reason, except for a failure by the
  /// limits.
  bool load_lanes(const plan::Plan& plan, const GeneratedProgram& program, const plan::CodeLimits& limits,
                  plan::CompiledLanes& code, std::string& why);
  void note(const std::string& problem);

  const plan::CodeTrial& trial_;
  std::mutex mutex_;
  std::optional<Compiler> compiler_;               ///< set at the first use
  std::map<std::string, ProgramFunctions> known_;  ///< by the source of the library
  CodeCache cache_;
  std::string problem_;
  bool noted_ = false;
};

}  // namespace stepwire::codegen
