#include <dlfcn.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/support/allocations.hpp"

using namespace stepwire;

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t ticks = 10'000;

/// The loaded functions of a program, compiled from the same text as a generated source.
struct Loaded {
  using Reset = void (*)(double*, const double*);
  Reset reset = nullptr;
  plan::StepFunctions step;
  std::string problem;
};

Loaded load(const run::Job& job, const codegen::Compiler& compiler, const std::string& stem) {
  Loaded loaded;
  const plan::Plan& plan = job.plan;
  const codegen::GeneratedProgram program = codegen::make_program(plan);
  std::string source = codegen::library_source(program);
  source += "extern \"C\" void stepwire_reset(double* w, const double* p) { reset(w, p); }\n";
  std::ofstream(stem + ".cpp") << source;
  std::vector<std::string> flags = codegen::flags_for_this_machine(program.headers);
  // Sweeps are compared as the compiler optimises them below. Of long programs it would take minutes.
  if (!job.points.empty() || source.size() > 150'000) flags.push_back("-O0");
  loaded.problem = compiler.compile(stem + ".cpp", stem + ".so", flags, {});
  void* library = loaded.problem.empty() ? ::dlopen((stem + ".so").c_str(), RTLD_NOW | RTLD_LOCAL) : nullptr;
  if (!library) return loaded;
  loaded.reset = reinterpret_cast<Loaded::Reset>(::dlsym(library, "stepwire_reset"));
  loaded.step.evaluate =
      reinterpret_cast<decltype(loaded.step.evaluate)>(::dlsym(library, "stepwire_evaluate"));
  loaded.step.advance = reinterpret_cast<decltype(loaded.step.advance)>(::dlsym(library, "stepwire_advance"));
  return loaded;
}

/// Marks the numbers that are compared. Derivatives are internal to the solver and excluded, unless they are
/// outputs.
std::vector<bool> compared(const plan::Plan& plan) {
  const plan::Layout& layout = plan.layout;
  std::vector<bool> all(layout.size, true);
  std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(layout.derivatives), layout.state_count, false);
  for (const plan::PlannedBlock& block : plan.blocks)
    for (const plan::SignalSlot& slot : block.outputs)
      std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(slot.offset), slot.size, true);
  return all;
}

/// First number that differs, by its place.
std::size_t first_difference(const std::vector<bool>& compared, const double* a, const double* b) {
  for (std::size_t i = 0; i < compared.size(); ++i)
    if (compared[i] && std::memcmp(a + i, b + i, sizeof(double)) != 0) return i;
  return compared.size();
}

/// Returns the first difference between interpreter and generated code, or that the code allocates memory; an
/// empty text if there is neither.
std::string difference(const plan::Plan& plan, const Loaded& loaded) {
  run::Executor interpreted(plan);
  std::vector<double> w(plan.layout.size, -1.0);
  loaded.reset(w.data(), nullptr);
  const std::vector<bool> of_run = compared(plan);
  long requests = 0;
  for (std::int64_t tick = 0; tick <= ticks && interpreted.healthy(); ++tick) {
    interpreted.evaluate();
    const long before = allocations();
    loaded.step.evaluate(w.data(), nullptr, tick);
    requests += allocations() - before;
    const std::size_t place = first_difference(of_run, interpreted.values(), w.data());
    if (place < plan.layout.size)
      return "number " + std::to_string(place) + " of the workspace at tick " + std::to_string(tick);
    interpreted.advance();
    loaded.step.advance(w.data(), nullptr, tick);
    requests += allocations() - before;
  }
  return requests == 0 ? "" : "the generated code asks for memory";
}

/// True if a run has the bits of its plan for a thousand ticks, and compiled code, if given, takes over at
/// tick 100.
bool same_bits(const plan::Plan& plan, run::Executor& run, const std::optional<plan::CompiledPlan>& code) {
  run::Executor own(plan);
  const std::vector<bool> of_run = compared(plan);
  while (own.tick() < 1000 && own.healthy()) {
    if (run.tick() == 100 && code) run.use(*code);
    if (run.tick() >= 100 && run.compiled() != code.has_value()) return false;
    own.evaluate();
    run.evaluate();
    if (first_difference(of_run, own.values(), run.values()) < plan.layout.size) return false;
    own.advance();
    run.advance();
  }
  return run.healthy() == own.healthy();
}

}  // namespace

TEST_CASE("every diagram that can be generated gives the interpreter's bits and asks for no memory") {
  const codegen::Compiler compiler;
  if (!compiler.found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const std::vector<run::Job> jobs = distinct_jobs();
  const fs::path folder = fs::temp_directory_path() / ("stepwire-generated-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::vector<Loaded> loaded(jobs.size());
  std::vector<std::string> refused(jobs.size());
  in_parallel(jobs.size(), [&](std::size_t i) {
    try {
      loaded[i] = load(jobs[i], compiler, (folder / std::to_string(i)).string());
    } catch (const yaml::Error& error) {
      refused[i] = error.what();
    }
  });
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    INFO(jobs[i].plan.diagram.file);
    if (!refused[i].empty()) {
      WARN("cannot be generated: " << refused[i]);
      continue;
    }
    CHECK(loaded[i].problem == "");
    if (loaded[i].reset) CHECK(difference(jobs[i].plan, loaded[i]) == "");
  }
  fs::remove_all(folder);
}

TEST_CASE("the runs of a sweep are those of plans of their own, compiled or not") {
  const bool has_compiler = codegen::Compiler().found();
  if (!has_compiler) WARN("there is no C++ compiler here; compiled runs are not compared");
  std::vector<run::Job> jobs = distinct_jobs();
  std::erase_if(jobs, [](const run::Job& job) { return job.points.empty(); });
  in_parallel(jobs.size(), [&](std::size_t i) {
    const run::Job& job = jobs[i];
    codegen::GeneratedCode source{run::code_trial()};
    std::vector<std::optional<plan::CompiledPlan>> code(job.family->size());
    for (std::size_t m = 0; has_compiler && m < code.size(); ++m)
      code[m] = source.compile(job.family->plan(m), job.family->variable(m), {});
    static std::mutex mutex;  // of the checks
    for (std::size_t point : {std::size_t{0}, job.points.size() - 1}) {
      const std::size_t member = job.points[point].member;
      run::Executor run(job.family->plan(member));
      if (job.points[0].member == member)
        job.family->begin(member, job.settings_of(0), run);  // what it had before leaves no trace
      job.family->begin(member, job.settings_of(point), run);
      const plan::Plan own = plan_at(job, point);
      const bool same = same_bits(own, run, code[member]);
      const std::lock_guard lock(mutex);
      INFO(job.plan.diagram.file << ", point " << point << " " << source.take_problem());
      CHECK(same);
      CHECK(code[member].has_value() == has_compiler);
    }
  });
}
