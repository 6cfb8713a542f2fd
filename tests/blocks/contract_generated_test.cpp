// Generated code computes each block as the interpreter does, whether or not a diagram file uses it.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <set>
#include <span>

#include "engine/simulate/codegen/library.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "tests/blocks/contract_library.hpp"
#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

namespace {

constexpr std::int64_t ticks = 20;

constexpr const char* exported = "extern \"C\" [[gnu::visibility(\"default\")]] void ";

struct Made {
  std::string yaml;
  plan::Plan plan;
  codegen::GeneratedProgram program;
};

using Ways = std::vector<Wiring> (*)(const BlockType& type);

/// The ways to use a block: also on condition.
std::vector<Wiring> ways_of(const BlockType& type) {
  std::vector<Wiring> wirings = wirings_of(type);
  for (const char* enable : {"gate", "{when: gate, states: reset, outputs: reset}"})
    wirings.push_back(guarded(wirings.front(), enable));
  return wirings;
}

/// Those beside events: as it is used least, and most.
std::vector<Wiring> located_ways_of(const BlockType& type) {
  std::vector<Wiring> wirings;
  for (const Wiring& wiring : wirings_of(type))
    if (!wiring.may_be_refused) wirings.push_back(located(wiring));
  wirings.push_back(
      located(guarded(wirings_of(type).front(), "{when: gate, states: reset, outputs: reset}")));
  return wirings;
}

/// Makes a program for each wiring of each block. A block that cannot be generated must have no header.
std::vector<Made> all_made(Ways ways) {
  std::vector<Made> all;
  for (const BlockType* type : library().types()) {
    for (const Wiring& wiring : ways(*type)) {
      auto plan = plan_of(wiring);
      if (!plan) continue;
      try {
        codegen::GeneratedProgram program = codegen::make_program(*plan);
        all.push_back({wiring.text, std::move(*plan), std::move(program)});
      } catch (const yaml::Error& error) {
        INFO(error.what());
        CHECK(type->header.empty());
      }
    }
  }
  return all;
}

/// All programs as one source, which is compiled in a tenth of the time that they take one by one.
std::string source_of(std::span<const Made> all) {
  std::set<std::string> headers;
  for (const Made& made : all) headers.insert(made.program.headers.begin(), made.program.headers.end());
  std::string source = codegen::library_head({headers.begin(), headers.end()}, 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    source += fmt::format("namespace made_{} {{\nnamespace {{\nusing namespace stepwire;\n{}\n}}\n}}\n", i,
                          all[i].program.text);
    source += fmt::format("{1}reset_{0}(double* w) {{ made_{0}::reset(w, nullptr); }}\n", i, exported);
    for (const char* function : {"evaluate", "advance"})
      source +=
          fmt::format("{2}{0}_{1}(double* w, std::int64_t tick) {{ made_{1}::{0}(w, nullptr, tick); }}\n",
                      function, i, exported);
  }
  return source;
}

/// Returns the first tick at which interpreter and generated code differ; std::nullopt if they never do.
std::optional<std::int64_t> first_difference(const plan::Plan& plan, const ContractLibrary& library,
                                             std::size_t index) {
  void (*reset)(double*) = nullptr;
  void (*evaluate)(double*, std::int64_t) = nullptr;
  void (*advance)(double*, std::int64_t) = nullptr;
  library.find(fmt::format("reset_{}", index), reset);
  library.find(fmt::format("evaluate_{}", index), evaluate);
  library.find(fmt::format("advance_{}", index), advance);
  run::Executor interpreted(plan);
  std::vector<double> w(plan.layout.size, -1.0);
  reset(w.data());
  for (std::int64_t tick = 0; tick < ticks && interpreted.healthy(); ++tick) {
    interpreted.evaluate();
    evaluate(w.data(), tick);
    if (!same_numbers(plan, interpreted.values(), w.data())) return tick;
    interpreted.advance();
    advance(w.data(), tick);
  }
  CHECK((plan.crossing_count == 0 || !interpreted.healthy() || interpreted.event_count().located > 0));
  return std::nullopt;
}

/// Names with this in them.
std::vector<std::string> with(const std::string& part, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : names)
    if (name.find(part) != std::string::npos) found.push_back(name);
  return found;
}

/// The program exports functions of its blocks, which are not those of generated code.
void check_symbols(const ContractLibrary& library) {
  CHECK(with("stepwire", library.undefined()) == std::vector<std::string>());
  CHECK(with("stepwire", library.exported()) == std::vector<std::string>());
}

void compare(std::span<const Made> programs, const char* optimisation) {
  const ContractLibrary library(source_of(programs), optimisation);
  check_symbols(library);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    INFO(programs[i].yaml);
    const auto tick = first_difference(programs[i].plan, library, i);
    CHECK_FALSE(tick);
  }
}

}  // namespace

TEST_CASE("every block gives the interpreter's bits in generated code, however it is used", "[full]") {
  if (!has_compiler()) return;
  const std::vector<Made> all = all_made(ways_of);
  CHECK(all.size() > library().types().size());
  compare(all, "-O1");
}

TEST_CASE("every block gives the interpreter's bits in generated code beside events that are located",
          "[full]") {
  if (!has_compiler()) return;
  const std::vector<Made> all = all_made(located_ways_of);
  CHECK(all.size() > library().types().size());
  compare(all, "-O0");  // -O1 has been compared above, and takes two minutes here
}
