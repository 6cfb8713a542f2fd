#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "engine/simulate/codegen/library.hpp"

namespace stepwire::codegen {

/// Compiled code for runs, made by this machine's compiler and kept in a cache. From any thread.
class GeneratedCode : public plan::CodeSource {
 public:
  /// New code is compared by `trial`, which must outlive it, before anything uses it.
  explicit GeneratedCode(const plan::CodeTrial& trial) : trial_(trial) {}

  std::optional<plan::CompiledPlan> compile(const plan::Plan& plan,
                                            const std::vector<plan::VariableBlock>& variable,
                                            const plan::CodeLimits& limits) override;

  /// With as many lanes as a register of this machine's processor has.
  std::optional<plan::CompiledLanes> compile_lanes(const plan::Plan& plan,
                                                   const plan::RunDifferences& differences,
                                                   const plan::CodeLimits& limits, std::string& why) override;
  int lanes() override;

  /// Why there was no code the first time that there was none; empty once it has been taken.
  std::string take_problem();

 private:
  /// On failure `problem` says why, but for that of the limits.
  ProgramFunctions functions_of(const GeneratedProgram& program, const plan::CodeLimits& limits,
                                const CodeCache::Trial& trial, std::string& problem);
  /// Sets the function of lanes. Otherwise `why` has the reason, but for that of the limits.
  bool load_lanes(const plan::Plan& plan, const GeneratedProgram& program, const plan::CodeLimits& limits,
                  plan::CompiledLanes& code, std::string& why);
  void note(const std::string& problem);

  const plan::CodeTrial& trial_;
  std::mutex mutex_;
  std::optional<Compiler> compiler_;               ///< looked for when it is needed
  std::map<std::string, ProgramFunctions> known_;  ///< by the program's text
  CodeCache cache_;
  std::string problem_;
  bool noted_ = false;
};

}  // namespace stepwire::codegen
