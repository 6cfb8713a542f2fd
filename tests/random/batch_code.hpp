#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "tests/random/batch_units.hpp"

namespace stepwire::random {

/// A generated program that runs by itself, once compiled.
struct OwnProgram {
  void* (*make)() = nullptr;
  void (*free)(void* program) = nullptr;
  void (*evaluate)(void* program, double* numbers) = nullptr;
  void (*advance)(void* program) = nullptr;
};

/// Code of many diagrams, compiled in few sources: a tenth of the time. At first a call notes its code and
/// returns std::nullopt; after compile_all() the same call returns functions.
class BatchCode : public plan::CodeSource {
 public:
  std::optional<plan::CompiledPlan> compile(const plan::Plan& plan,
                                            const std::vector<plan::VariableBlock>& variable,
                                            const plan::CodeLimits& limits) override;
  std::optional<plan::CompiledLanes> compile_lanes(const plan::Plan& plan,
                                                   const plan::RunDifferences& differences,
                                                   const plan::CodeLimits& limits, std::string& why) override;
  int lanes() override;
  /// The program that `generate` writes, with parameters to change or without; nullopt before compile_all()
  /// and where it does not compile.
  std::optional<OwnProgram> program(const plan::Plan& plan, bool constant_parameters);

  /// Code as a run has it, with all that the compiler optimises, from the cache or compiled.
  std::optional<plan::CompiledPlan> as_runs_have_it(const plan::Plan& plan);

  /// Exported units, which compile_all() makes as well.
  BatchUnits& units() { return units_; }

  bool has_compiler() const { return compiler_.found(); }
  /// Compiles all that was noted since the last call, on all cores.
  void compile_all();
  /// Forgets everything; what is loaded stays loaded.
  void clear() {
    pieces_.clear();
    units_.clear();
  }
  /// The errors of the compiler in the code of the last call; empty if it has none.
  const std::string& problem() const { return problem_; }

 private:
  /// One program among others in a source.
  struct Piece {
    std::string text;  ///< with {0} in the place of its number
    std::vector<std::string> headers;
    int lanes = 1;
    std::optional<codegen::GeneratedProgram> whole{};  ///< compiled as a run does it
    std::map<std::string, void*> functions{};          ///< by their names without the number
    std::string problem{};
    bool done = false;
  };
  using Group = std::vector<Piece*>;

  Piece& piece(Piece wanted);
  std::vector<Group> open_groups();
  void compile(const Group& group);
  void compile_whole(Piece& piece);
  static std::string source_of(const Group& group);

  codegen::Compiler compiler_;
  BatchUnits units_;
  std::map<std::string, Piece> pieces_;  ///< by their text
  std::string problem_;
};

}  // namespace stepwire::random
