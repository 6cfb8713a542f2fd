#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <set>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/codegen/library.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/support/allocations.hpp"

using namespace stepwire;

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t ticks = 10'000;

/// The loaded functions of a diagram's program.
struct Loaded {
  using Reset = void (*)(double*, const double*);
  Reset reset = nullptr;
  plan::StepFunctions step;
  std::string refused, problem;
};

/// Programs that are compiled as one source with the same flags, by their places in the list of diagrams.
struct Group {
  std::vector<std::string> flags;
  std::vector<std::size_t> members;
  std::size_t size = 0;  ///< of their texts [bytes]
};

using Programs = std::vector<std::optional<codegen::GeneratedProgram>>;

/// How programs are optimised: as compiled runs are, or in half of that time.
enum class Optimised { as_runs, quickly };

std::vector<std::string> flags_of(const run::Job& job, const codegen::GeneratedProgram& program,
                                  Optimised optimised) {
  std::vector<std::string> flags = codegen::flags_for_this_machine(program.headers);
  if (optimised == Optimised::quickly) flags.push_back("-O1");
  // Sweeps are compared as the compiler optimises them below. Of long programs it would take minutes.
  if (!job.points.empty() || program.text.size() > 150'000) flags.push_back("-O0");
  return flags;
}

/// Headers and their templates are compiled once for each group, which takes half of the time.
std::vector<Group> groups_of(const std::vector<run::Job>& jobs, const Programs& programs,
                             Optimised optimised) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!programs[i]) continue;
    const std::vector<std::string> flags = flags_of(jobs[i], *programs[i], optimised);
    const bool is_plain = !flags.empty() && flags.back() == "-O0";
    const std::size_t most = flags.empty() ? 1 : is_plain ? 8 : 2;  // optimised code has little in common
    const auto open = std::ranges::find_if(groups, [&](const Group& group) {
      return group.flags == flags && group.members.size() < most && group.size < 400'000;
    });
    Group& group = open != groups.end() ? *open : groups.emplace_back(Group{flags, {}});
    group.members.push_back(i);
    group.size += programs[i]->text.size();
  }
  return groups;
}

std::string source_of(const Group& group, const Programs& programs) {
  std::set<std::string> headers;
  for (const std::size_t i : group.members)
    headers.insert(programs[i]->headers.begin(), programs[i]->headers.end());
  std::string source = codegen::library_head({headers.begin(), headers.end()}, 1);
  for (const std::size_t i : group.members) {
    source += fmt::format("namespace of_{} {{\nnamespace {{\nusing namespace stepwire;\n{}\n}}\n}}\n", i,
                          programs[i]->text);
    source += fmt::format(
        "extern \"C\" void reset_{0}(double* w, const double* p) {{ of_{0}::reset(w, p); }}\n", i);
    for (const char* function : {"evaluate", "advance"})
      source += fmt::format(
          "extern \"C\" [[gnu::flatten]] void {0}_{1}(double* w, const double* p, std::int64_t tick) {{\n"
          "  of_{1}::{0}(w, p, tick);\n}}\n",
          function, i);
  }
  return source;
}

/// Compiles a group and finds the functions of its programs.
void load(const Group& group, const Programs& programs, const codegen::Compiler& compiler,
          const std::string& stem, std::vector<Loaded>& loaded) {
  std::ofstream(stem + ".cpp") << source_of(group, programs);
  const std::string problem = compiler.compile(stem + ".cpp", stem + ".so", group.flags, {});
  void* library = problem.empty() ? ::dlopen((stem + ".so").c_str(), RTLD_NOW | RTLD_LOCAL) : nullptr;
  for (const std::size_t i : group.members) {
    loaded[i].problem = problem;
    if (!library) continue;
    const auto find = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
          ::dlsym(library, fmt::format("{}_{}", name, i).c_str()));
    };
    find(loaded[i].reset, "reset");
    find(loaded[i].step.evaluate, "evaluate");
    find(loaded[i].step.advance, "advance");
  }
}

/// Compiles the programs of all diagrams.
std::vector<Loaded> load_all(const std::vector<run::Job>& jobs, const codegen::Compiler& compiler,
                             const fs::path& folder, Optimised optimised) {
  std::vector<Loaded> loaded(jobs.size());
  Programs programs(jobs.size());
  in_parallel(jobs.size(), [&](std::size_t i) {
    try {
      programs[i] = codegen::make_program(jobs[i].plan);
    } catch (const yaml::Error& error) {
      loaded[i].refused = error.what();
    }
  });
  const std::vector<Group> groups = groups_of(jobs, programs, optimised);
  in_parallel(groups.size(), [&](std::size_t g) {
    load(groups[g], programs, compiler, (folder / std::to_string(g)).string(), loaded);
  });
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

/// Compares the runs of sweeps with plans of their own.
void compare_sweeps(const std::vector<run::Job>& jobs) {
  const bool has_compiler = codegen::Compiler().found();
  if (!has_compiler) WARN("there is no C++ compiler here; compiled runs are not compared");
  in_parallel(jobs.size(), [&](std::size_t i) {
    const run::Job& job = jobs[i];
    codegen::GeneratedCode source{run::code_trial()};
    std::map<std::size_t, std::optional<plan::CompiledPlan>> code;
    static std::mutex mutex;  // of the checks
    for (std::size_t point : {std::size_t{0}, job.points.size() - 1}) {
      const std::size_t member = job.points[point].member;
      if (has_compiler && !code.contains(member))
        code[member] = source.compile(job.family->plan(member), job.family->variable(member), {});
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

bool can_be_generated(const run::Job& job) {
  try {
    codegen::make_program(job.plan);
    return true;
  } catch (const yaml::Error&) {
    return false;
  }
}

/// Compares the programs of diagrams with the interpreter.
void compare_programs(const std::vector<run::Job>& jobs, Optimised optimised) {
  const codegen::Compiler compiler;
  if (!compiler.found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const fs::path folder = fs::temp_directory_path() / ("stepwire-generated-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::vector<Loaded> loaded = load_all(jobs, compiler, folder, optimised);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    INFO(jobs[i].plan.diagram.file);
    if (!loaded[i].refused.empty()) {
      WARN("cannot be generated: " << loaded[i].refused);
      continue;
    }
    CHECK(loaded[i].problem == "");
    CHECK(loaded[i].reset != nullptr);
    if (loaded[i].reset) CHECK(difference(jobs[i].plan, loaded[i]) == "");
  }
  fs::remove_all(folder);
}

}  // namespace

TEST_CASE("programs of diagrams with all blocks give the interpreter's bits and ask for no memory") {
  compare_programs(jobs_of_all_blocks(can_be_generated), Optimised::quickly);
}

TEST_CASE(
    "every diagram that can be generated gives the interpreter's bits in code that is optimised as that of "
    "runs",
    "[long]") {
  compare_programs(distinct_jobs(), Optimised::as_runs);
}

TEST_CASE("the runs of sweeps over all blocks are those of plans of their own, compiled or not") {
  compare_sweeps(jobs_of_all_blocks([](const run::Job& job) { return !job.points.empty(); }));
}

TEST_CASE("the runs of each sweep are those of plans of their own, compiled or not", "[long]") {
  std::vector<run::Job> jobs = distinct_jobs();
  std::erase_if(jobs, [](const run::Job& job) { return job.points.empty(); });
  compare_sweeps(jobs);
}
