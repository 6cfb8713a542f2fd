#include "engine/generate/generated_code.hpp"

#include <algorithm>

#include "engine/process/process.hpp"

namespace stepwire {

namespace {

bool equal(const ProgramNumbers& one, const ProgramNumbers& other, std::size_t list) {
  const ProgramNumbers::List &a = one.lists[list], &b = other.lists[list];
  const auto at = [](const ProgramNumbers& all, std::size_t i) {
    return all.numbers.begin() + static_cast<std::ptrdiff_t>(i);
  };
  return std::equal(at(one, a.first), at(one, a.first + a.size), at(other, b.first),
                    at(other, b.first + b.size));
}

/// Numbers in which the plans differ; empty where they differ in nothing, or have not the same numbers at
/// all.
Varying differences(const std::vector<const Plan*>& plans) {
  if (plans.size() == 1) return {};
  const ProgramNumbers first = numbers_of(*plans.front());
  Varying varying(first.singles(), false);
  for (const Plan* plan : plans) {
    const ProgramNumbers own = numbers_of(*plan);
    if (own.singles() != first.singles() || own.lists.size() != first.lists.size()) return {};
    for (std::size_t i = 0; i < own.singles(); ++i)
      if (own.numbers[i] != first.numbers[i]) varying[i] = true;
    for (std::size_t list = 0; list < own.lists.size(); ++list)
      if (!equal(own, first, list)) varying[own.lists[list].place] = true;
  }
  return std::find(varying.begin(), varying.end(), true) == varying.end() ? Varying{} : varying;
}

/// The plans' programs, with what varies between them as parameters. A text that is that of the plan before
/// is left out: a sweep may have very many points.
std::vector<GeneratedProgram> programs_of(const std::vector<const Plan*>& plans) {
  const Varying varying = differences(plans);
  std::vector<GeneratedProgram> programs;
  std::string last;
  for (const Plan* plan : plans) {
    programs.push_back(make_program(*plan, varying.empty() ? nullptr : &varying));
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
    tell(compiler_->problem());
  } catch (const std::exception& error) {  // no reason to end a run, which goes on without
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
    code.push_back({functions, std::move(program.parameters.numbers)});
  }
  return code;
}

void GeneratedCode::tell(const std::string& problem) {
  if (processes_stop()) return;  // an interruption explains itself
  if (!std::exchange(told_, true)) problem_ = problem;
}

}  // namespace stepwire
