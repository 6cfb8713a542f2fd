#include "engine/generate/generated_code.hpp"

#include <optional>

namespace stepwire {

namespace {

/// How plans share a program.
struct Sharing {
  Lists lists = Lists::in_place;
  Varying varying{};
};

/// Numbers in which the plans differ; nothing where they have not the same numbers at all.
std::optional<Varying> differences(const std::vector<const Plan*>& plans, Lists lists) {
  const GeneratedProgram first = make_program(*plans.front(), nullptr, lists);
  Varying varying(first.before_lists, false);
  for (const Plan* plan : plans) {
    const GeneratedProgram own = make_program(*plan, nullptr, lists);
    if (own.before_lists != first.before_lists) return std::nullopt;
    for (std::size_t i = 0; i < first.before_lists; ++i)
      if (own.parameters[i] != first.parameters[i]) varying[i] = true;
  }
  return varying;
}

/// Lists stand apart only where that lets plans share a program: code that knows their lengths is faster.
Sharing sharing_of(const std::vector<const Plan*>& plans) {
  if (plans.size() == 1) return {};
  for (const Lists lists : {Lists::in_place, Lists::apart})
    if (const auto varying = differences(plans, lists)) return {lists, *varying};
  return {};
}

/// The plans' programs, with what varies between them as parameters. A text that is that of the plan before
/// is left out: a sweep may have very many points.
std::vector<GeneratedProgram> programs_of(const std::vector<const Plan*>& plans) {
  const Sharing sharing = sharing_of(plans);
  const Varying& varying = sharing.varying;
  std::vector<GeneratedProgram> programs;
  std::string last;
  for (const Plan* plan : plans) {
    programs.push_back(make_program(*plan, varying.empty() ? nullptr : &varying, sharing.lists));
    if (programs.back().text == last) {
      programs.back().text.clear();
    } else {
      last = programs.back().text;
    }
  }
  return programs;
}

}  // namespace

std::vector<CompiledPlan> GeneratedCode::compile(const std::vector<const Plan*>& plans,
                                                 const std::stop_token& stop) {
  if (!compiler_) compiler_.emplace();
  try {
    if (compiler_->found()) return load(programs_of(plans), stop);
    tell("no C++ compiler is there (c++, g++ or clang++, or what CXX names)");
  } catch (const Error& error) {
    tell(error.what());
  }
  return {};
}

std::vector<CompiledPlan> GeneratedCode::load(std::vector<GeneratedProgram> programs,
                                              const std::stop_token& stop) {
  std::vector<CompiledPlan> code;
  for (GeneratedProgram& program : programs) {
    std::string problem;
    const bool same = program.text.empty();
    const StepFunctions functions =
        same ? code.back().functions : cache_.load(program, *compiler_, stop, problem);
    if (!problem.empty() && !stop.stop_requested()) tell(problem);
    if (!functions.evaluate || !functions.advance) return {};
    code.push_back({functions, std::move(program.parameters)});
  }
  return code;
}

void GeneratedCode::tell(const std::string& problem) {
  if (!std::exchange(told_, true)) problem_ = problem;
}

}  // namespace stepwire
