#include "engine/generate/generated_code.hpp"

#include <cstring>
#include <map>

#include "engine/process/process.hpp"

namespace stepwire {

namespace {

/// The bits count: 0.0 and -0.0 are two numbers.
bool same_numbers(const double* a, const double* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(double)) == 0;
}

/// Plans whose programs differ in numbers alone.
struct Kind {
  const Plan* first;
  ProgramNumbers numbers;  ///< of the first
  Varying varying;         ///< in which the others differ from it
};

void note_differences(const ProgramNumbers& own, Kind& kind) {
  const ProgramNumbers& first = kind.numbers;
  for (std::size_t i = 0; i < own.singles(); ++i)
    if (!same_numbers(&own.numbers[i], &first.numbers[i], 1)) kind.varying[i] = true;
  for (std::size_t list = 0; list < own.lists.size(); ++list) {
    const ProgramNumbers::List &a = own.lists[list], &b = first.lists[list];
    if (a.size != b.size ||
        !same_numbers(own.numbers.data() + a.first, first.numbers.data() + b.first, a.size))
      kind.varying[a.place] = true;
  }
}

/// The plans' programs, with what varies between those of a kind as parameters. A text that is that of the
/// plan before is left out: a sweep may have very many points.
std::vector<GeneratedProgram> programs_of(const std::vector<const Plan*>& plans) {
  std::vector<Kind> kinds;
  std::map<std::string, std::size_t> kind_of_outline;
  std::vector<std::size_t> kind_of;
  std::vector<GeneratedProgram> programs;
  for (const Plan* plan : plans) {
    GeneratedProgram outline = outline_of(*plan);
    const auto [known, is_new] = kind_of_outline.emplace(std::move(outline.text), kinds.size());
    if (is_new) kinds.push_back({plan, outline.parameters, Varying(outline.parameters.singles(), false)});
    note_differences(outline.parameters, kinds[known->second]);
    kind_of.push_back(known->second);
    programs.push_back({"", std::move(outline.headers), std::move(outline.parameters)});
  }
  std::vector<std::string> texts;
  for (const Kind& kind : kinds) texts.push_back(make_program(*kind.first, &kind.varying).text);
  for (std::size_t i = 0; i < plans.size(); ++i)
    if (i == 0 || kind_of[i] != kind_of[i - 1]) programs[i].text = texts[kind_of[i]];
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
