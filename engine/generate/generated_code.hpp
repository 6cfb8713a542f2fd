#pragma once

#include <optional>
#include <string>
#include <utility>

#include "engine/generate/library.hpp"

namespace stepwire {

/// Compiled code for runs, made by this machine's compiler and kept in a cache. Plans that differ in numbers
/// of their blocks only, as the points of a sweep do, share one compilation.
class GeneratedCode : public CodeSource {
 public:
  std::vector<CompiledPlan> compile(const std::vector<const Plan*>& plans,
                                    const std::stop_token& stop) override;
  std::vector<double> numbers(const Plan& plan) const override { return numbers_of(plan).numbers; }

  /// Why there was no code the first time that there was none; empty once told.
  std::string take_problem() { return std::exchange(problem_, ""); }

 private:
  std::vector<CompiledPlan> load(std::vector<GeneratedProgram> programs, const std::stop_token& stop);
  void tell(const std::string& problem);

  std::optional<Compiler> compiler_;  ///< looked for when it is needed
  CodeCache cache_;
  std::string problem_;
  bool told_ = false;
};

}  // namespace stepwire
