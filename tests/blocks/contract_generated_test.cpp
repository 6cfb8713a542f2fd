// Generated code computes each block as the interpreter does, whether or not a diagram file uses it.
#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>

#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t ticks = 20;

struct Made {
  std::string yaml;
  plan::Plan plan;
  codegen::GeneratedProgram program;
};

/// A program for each way to use each block. A block that no program can have says so by having no header.
std::vector<Made> all_made() {
  std::vector<Made> all;
  for (const BlockType* type : library().types()) {
    std::vector<Wiring> wirings = wirings_of(*type);
    wirings.push_back(guarded(wirings.front(), "gate"));
    wirings.push_back(guarded(wirings.front(), "{when: gate, states: reset, outputs: reset}"));
    for (const Wiring& wiring : wirings) {
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
  std::string source =
      "#define STEPWIRE_GENERATED\n#include <cmath>\n#include <cstdint>\n#include <limits>\n";
  for (const std::string& header : headers) source += fmt::format("#include \"{}\"\n", header);
  for (std::size_t i = 0; i < all.size(); ++i) {
    source += fmt::format("namespace made_{} {{\nnamespace {{\nusing namespace stepwire;\n{}\n}}\n}}\n", i,
                          all[i].program.text);
    source += fmt::format("extern \"C\" void reset_{0}(double* w) {{ made_{0}::reset(w, nullptr); }}\n", i);
    for (const char* function : {"evaluate", "advance"})
      source += fmt::format(
          "extern \"C\" void {0}_{1}(double* w, std::int64_t tick) {{ made_{1}::{0}(w, nullptr, tick); }}\n",
          function, i);
  }
  return source;
}

/// The library with all of them; null where it cannot be compiled.
void* compiled(const codegen::Compiler& compiler, const std::string& source) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("stepwire-blocks-{}", ::getpid());
  fs::create_directories(folder);
  const std::string stem = (folder / "all").string();
  std::ofstream(stem + ".cpp") << source;
  const std::string problem = compiler.compile(stem + ".cpp", stem + ".so", {"-O1"}, {});
  INFO(problem.substr(0, 2000));
  CHECK(problem.empty());
  void* library = problem.empty() ? ::dlopen((stem + ".so").c_str(), RTLD_NOW | RTLD_LOCAL) : nullptr;
  fs::remove_all(folder);
  return library;
}

/// The tick from which on the two differ; nothing where they never do.
std::optional<std::int64_t> first_difference(const plan::Plan& plan, void* library, std::size_t index) {
  const auto find = [&]<class Function>(const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(::dlsym(library, fmt::format("{}_{}", name, index).c_str()));
  };
  void (*reset)(double*) = nullptr;
  void (*evaluate)(double*, std::int64_t) = nullptr;
  void (*advance)(double*, std::int64_t) = nullptr;
  find("reset", reset);
  find("evaluate", evaluate);
  find("advance", advance);
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
  return std::nullopt;
}

}  // namespace

TEST_CASE("every block gives the interpreter's bits in generated code, however it is used") {
  const codegen::Compiler compiler;
  if (!compiler.found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const std::vector<Made> all = all_made();
  CHECK(all.size() > library().types().size());
  void* library = compiled(compiler, source_of(all));
  REQUIRE(library);
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(all[i].yaml);
    const auto tick = first_difference(all[i].plan, library, i);
    CHECK_FALSE(tick);
  }
  ::dlclose(library);
}
