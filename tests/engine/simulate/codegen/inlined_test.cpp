#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <tuple>

#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/model/plan/variable_blocks.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/library.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::codegen {

TEST_CASE("the loops over a block's elements are part of the step in compiled code") {
  const Compiler compiler;
  if (!compiler.found() || !compiler.is_gcc()) {
    WARN("there is no GCC here; nothing was compiled");
    return;
  }
  const Scratch scratch;
  const std::string w1 = io::read_file(STEPWIRE_SOURCE_DIR "/bench/w1.yaml"), library = scratch.path("w1.so");
  const GeneratedProgram program = make_steps(plan_text(w1), {});
  REQUIRE(compiler.compile(scratch.file("w1.cpp", library_source(program)), library, flags_of(program), {}) ==
          "");
  const auto symbols = subprocess::run_process({.command = {"nm", "-C", library}});
  REQUIRE(symbols.output.find("stepwire_advance") != std::string::npos);
  CHECK(symbols.output.find("::each<") == std::string::npos);
}

TEST_CASE("formulas are part of the loop over lanes, with functions for the lanes of a register") {
  const Compiler compiler;
  if (!compiler.found() || !compiler.is_gcc()) {
    WARN("there is no GCC here; nothing was compiled");
    return;
  }
  const plan::Plan plan = plan_text(R"yaml(step: 1 ms
stop: 1 s
solver: rk4
parameters: {mu: 1}
blocks:
  x: {block: Integrator, u: v, initial: 1}
  v: {block: Integrator, u: force, initial: 0}
  force: {block: Expression, expression: "mu*(1 - x*x)*v - sin(x) + max(x, v, 0)", variables: [mu, x, v], u: [$mu, x, v]}
record: [x]
)yaml");
  const diagram::Variation variation(plan.diagram, {"mu"});
  const GeneratedProgram program =
      make_lanes(plan, {plan::variable_blocks(plan, variation), variation.targets()}, 8);
  const Scratch scratch;
  const std::string library = scratch.path("lanes.so");
  std::vector<std::string> flags = flags_of(program);
  std::erase(flags, Compiler::native);
  flags.push_back("-mavx512f");
  REQUIRE(compiler.compile(scratch.file("lanes.cpp", library_source(program)), library, flags, {}) == "");
  const auto code = subprocess::run_process({.command = {"objdump", "-dC", "--no-show-raw-insn", library}});
  CHECK(code.output.find("Sleef_cinz_sind8") != std::string::npos);
  CHECK(code.output.find("Sleef_cinz_sind2") == std::string::npos);
  CHECK(code.output.find("formula::force::operator") == std::string::npos);
}

TEST_CASE("a loop over lanes calls elementary functions once for the lanes of a register") {
  const Compiler compiler;
  if (!compiler.found() || !compiler.is_gcc()) {
    WARN("there is no GCC here; nothing was compiled");
    return;
  }
  // The forms for 8 lanes are compiled, too, whatever processor compiles them.
  const auto [lanes, target, form] =
      GENERATE(std::tuple{4, "-mavx2", "d4_"}, std::tuple{8, "-mavx512f", "d8_"});
  const Scratch scratch;
  const std::string text =
      "#include \"engine/base/math/elementary.hpp\"\n"
      "extern \"C\" void loop(double* __restrict w, const double* __restrict v) {\n"
      "#pragma GCC ivdep\n"
      "  for (int lane = 0; lane < STEPWIRE_LANES; ++lane)\n"
      "    w[lane] = stepwire::fn::sin(v[lane]) + stepwire::fn::atan2(w[lane], v[lane]) +\n"
      "              stepwire::fn::pow(v[lane], w[lane]) + stepwire::fn::pow(w[lane], 2.0);\n}\n";
  const std::string library = scratch.path("lanes.so");
  REQUIRE(compiler.compile(scratch.file("lanes.cpp", text), library,
                           {fmt::format("-DSTEPWIRE_LANES={}", lanes), "-DSTEPWIRE_SLEEF", target,
                            "-fopenmp-simd", fmt::format("-mprefer-vector-width={}", 64 * lanes)},
                           {}) == "");
  const auto code = subprocess::run_process({.command = {"objdump", "-d", "--no-show-raw-insn", library}});
  const std::size_t begin = code.output.find("<loop>:"), end = code.output.find("\n\n", begin);
  REQUIRE(begin != std::string::npos);
  const std::string loop = code.output.substr(begin, end - begin);
  INFO(loop);
  for (const char* function : {"sin", "atan2", "pow"})
    CHECK(loop.find(fmt::format("Sleef_cinz_{}{}", function, form)) != std::string::npos);
  CHECK(loop.find("d2_u10") == std::string::npos);
}

}  // namespace stepwire::codegen
