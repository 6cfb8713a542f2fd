#include <dlfcn.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <thread>

#include "engine/generate/generated_code.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/support/allocations.hpp"

using namespace stepwire;

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t ticks = 10'000;

/// A program's own functions, loaded: of the very text that stands in a generated source.
struct Loaded {
  using Reset = void (*)(double*, const double*);
  Reset reset = nullptr;
  StepFunctions step;
  std::string problem;
};

Loaded load(const Job& job, const Compiler& compiler, const std::string& stem) {
  Loaded loaded;
  const Plan& plan = job.plan;
  const GeneratedProgram program = make_program(plan);
  std::string source = library_source(program);
  source += "extern \"C\" void stepwire_reset(double* w, const double* p) { reset(w, p); }\n";
  std::ofstream(stem + ".cpp") << source;
  std::vector<std::string> flags = flags_for_this_machine(program.headers);
  if (!job.points.empty())
    flags.push_back("-O0");  // sweeps are compared as the compiler optimises them below
  loaded.problem = compiler.compile(stem + ".cpp", stem + ".so", flags, {});
  void* library = loaded.problem.empty() ? ::dlopen((stem + ".so").c_str(), RTLD_NOW | RTLD_LOCAL) : nullptr;
  if (!library) return loaded;
  loaded.reset = reinterpret_cast<Loaded::Reset>(::dlsym(library, "stepwire_reset"));
  loaded.step.evaluate =
      reinterpret_cast<decltype(loaded.step.evaluate)>(::dlsym(library, "stepwire_evaluate"));
  loaded.step.advance = reinterpret_cast<decltype(loaded.step.advance)>(::dlsym(library, "stepwire_advance"));
  return loaded;
}

/// Are these numbers those of a run? Slopes are the solver's own affair, but for those that outputs write.
std::vector<bool> compared(const Plan& plan) {
  const Layout& layout = plan.layout;
  std::vector<bool> all(layout.size, true);
  std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(layout.dots), layout.state_count, false);
  for (const PlannedBlock& block : plan.blocks)
    for (const SignalSlot& slot : block.outputs)
      std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(slot.offset), slot.size, true);
  return all;
}

/// First number that differs, by its place.
std::size_t first_difference(const std::vector<bool>& compared, const double* a, const double* b) {
  for (std::size_t i = 0; i < compared.size(); ++i)
    if (compared[i] && std::memcmp(a + i, b + i, sizeof(double)) != 0) return i;
  return compared.size();
}

/// Where and when the two part; empty where they never do.
std::string difference(const Plan& plan, const Loaded& loaded) {
  Simulation interpreted(plan);
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

/// Does compiled code that takes over at tick 100 go on with the same bits for a thousand ticks?
bool same_bits(const Plan& plan, const CompiledPlan& code) {
  Simulation interpreted(plan), compiled(plan);
  const std::vector<bool> of_run = compared(plan);
  while (interpreted.tick() < 1000 && interpreted.healthy()) {
    if (compiled.tick() == 100) compiled.use(code);
    interpreted.evaluate();
    compiled.evaluate();
    if (first_difference(of_run, interpreted.values(), compiled.values()) < plan.layout.size) return false;
    interpreted.advance();
    compiled.advance();
  }
  return compiled.healthy() == interpreted.healthy();
}

/// Calls `work` for each index, from as many threads as there are processors.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([&] {
      for (std::size_t at = next++; at < count; at = next++) work(at);
    });
}

std::vector<Job> all_jobs() {
  std::vector<Job> jobs;
  for_every_job([&](Job job) { jobs.push_back(std::move(job)); });
  return jobs;
}

/// A solver and the length of its steps stand in the code.
bool same_steps(const Plan& one, const Plan& other) {
  return one.diagram.solver == other.diagram.solver && one.diagram.step == other.diagram.step;
}

}  // namespace

TEST_CASE("every diagram that can be generated gives the interpreter's bits and asks for no memory") {
  const Compiler compiler;
  if (!compiler.found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const std::vector<Job> jobs = all_jobs();
  const fs::path folder = fs::temp_directory_path() / ("stepwire-generated-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::vector<Loaded> loaded(jobs.size());
  std::vector<std::string> refused(jobs.size());
  in_parallel(jobs.size(), [&](std::size_t i) {
    try {
      loaded[i] = load(jobs[i], compiler, (folder / std::to_string(i)).string());
    } catch (const Error& error) {
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

TEST_CASE("the points of a sweep share code and give the interpreter's bits") {
  if (!Compiler().found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  std::vector<Job> jobs = all_jobs();
  std::erase_if(jobs, [](const Job& job) { return job.points.empty(); });
  in_parallel(jobs.size(), [&](std::size_t i) {
    GeneratedCode source;
    std::vector<const Plan*> plans;
    for (const SweepPoint& point : jobs[i].points) plans.push_back(&point.plan);
    const std::vector<CompiledPlan> code = source.compile(plans, {});
    static std::mutex mutex;  // of the checks
    for (std::size_t point : {std::size_t{0}, plans.size() - 1}) {
      if (code.size() != plans.size()) break;
      const bool same = same_bits(*plans[point], code[point]);
      const std::lock_guard lock(mutex);
      INFO(jobs[i].plan.diagram.file << ", point " << point);
      CHECK(same);
    }
    const std::lock_guard lock(mutex);
    INFO(jobs[i].plan.diagram.file << ": " << source.take_problem());
    CHECK(code.size() == plans.size());
    for (std::size_t point = 1; point < code.size(); ++point)
      if (same_steps(*plans[point], *plans[0]))
        CHECK(code[point].functions.evaluate == code[0].functions.evaluate);
  });
}
