#include "engine/generate/generated_code.hpp"

#include <algorithm>

namespace stepwire {

namespace {

/// Numbers in which the programs differ; nothing where they have not the same numbers at all.
Varying differences(const std::vector<GeneratedProgram>& programs) {
  Varying varying(programs.front().parameters.size(), false);
  for (const GeneratedProgram& program : programs) {
    if (program.parameters.size() != varying.size()) return {};
    for (std::size_t i = 0; i < varying.size(); ++i)
      if (program.parameters[i] != programs.front().parameters[i]) varying[i] = true;
  }
  return varying;
}

/// The plans' programs, with what varies between them as parameters.
std::vector<GeneratedProgram> programs_of(const std::vector<const Plan*>& plans) {
  std::vector<GeneratedProgram> programs;
  for (const Plan* plan : plans) programs.push_back(make_program(*plan));
  const Varying varying = differences(programs);
  if (std::find(varying.begin(), varying.end(), true) == varying.end()) return programs;
  for (std::size_t i = 0; i < plans.size(); ++i) programs[i] = make_program(*plans[i], &varying);
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
  const std::string* last = nullptr;
  for (GeneratedProgram& program : programs) {
    std::string problem;
    const bool same = last && program.text == *last;
    const StepFunctions functions =
        same ? code.back().functions : cache_.load(program, *compiler_, stop, problem);
    if (!problem.empty() && !stop.stop_requested()) tell(problem);
    if (!functions.evaluate || !functions.advance) return {};
    code.push_back({functions, std::move(program.parameters)});
    last = &program.text;
  }
  return code;
}

void GeneratedCode::tell(const std::string& problem) {
  if (!std::exchange(told_, true)) problem_ = problem;
}

}  // namespace stepwire
