// Generated code computes each block as the interpreter does, whether or not a diagram file uses it.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <set>

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

/// The ways to use a block: also on condition, and with events that are located beside it.
std::vector<Wiring> ways_of(const BlockType& type) {
  std::vector<Wiring> wirings = wirings_of(type);
  for (const Wiring& wiring : wirings_of(type))
    if (!wiring.may_be_refused) wirings.push_back(located(wiring));
  const Wiring plain = wirings.front();
  for (const char* enable : {"gate", "{when: gate, states: reset, outputs: reset}"})
    wirings.insert(wirings.end(), {guarded(plain, enable), located(guarded(plain, enable))});
  return wirings;
}

/// A program for each way to use each block. A block that no program can have says so by having no header.
std::vector<Made> all_made() {
  std::vector<Made> all;
  for (const BlockType* type : library().types()) {
    for (const Wiring& wiring : ways_of(*type)) {
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
std::string source_of(const std::vector<Made>& all) {
  std::set<std::string> headers;
  for (const Made& made : all) headers.insert(made.program.headers.begin(), made.program.headers.end());
  std::string source = codegen::library_head({headers.begin(), headers.end()}, 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    source += fmt::format("namespace made_{} {{\nnamespace {{\nusing namespace stepwire;\n{}\n}}\n}}\n", i,
                          all[i].program.text);
    source += fmt::format("{1}reset_{0}(double* w) {{ made_{0}::reset(w, nullptr); }}\n", i, exported);
    for (const char* function : {"evaluate", "advance"})
      source += fmt::format(
          "{2}{0}_{1}(double* w, std::int64_t tick) {{ made_{1}::{0}(w, nullptr, tick); }}\n", function, i,
          exported);
  }
  return source;
}

/// The tick from which on the two differ; nothing where they never do.
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

}  // namespace

TEST_CASE("every block gives the interpreter's bits in generated code, however it is used") {
  if (!has_compiler()) return;
  const std::vector<Made> all = all_made();
  CHECK(all.size() > library().types().size());
  const ContractLibrary library(source_of(all), "-O1");
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(all[i].yaml);
    const auto tick = first_difference(all[i].plan, library, i);
    CHECK_FALSE(tick);
  }
  // The program exports functions of its blocks, which are not those of generated code.
  CHECK(with("stepwire", library.undefined()) == std::vector<std::string>());
  CHECK(library.exported().size() == 3 * all.size());
}
