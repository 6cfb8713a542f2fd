#include "engine/simulate/codegen/program.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "engine/model/block/declare.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/program_files.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::codegen {
using Catch::Contains;

namespace {

/// A block that is not of the library, as those of plugins will be.
struct Foreign {
  Input<> u{};
  Output<> y{};
  void outputs() { y = u; }
  static void declare(Declare<Foreign>& is) {
    is.block("Foreign", {.doc = "a test"});
    is.input<&Foreign::u>({.doc = "signal"});
    is.output<&Foreign::y>({.doc = "the same"});
  }
};

std::string program_of(const std::string& yaml) {
  return make_program(plan_text(yaml)).text;
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

/// A chain of gains behind a sine, each fed by the one before.
std::string gains(int count) {
  std::string yaml = "blocks:\n  s: {block: Sine}\n";
  for (int i = 0; i < count; ++i)
    yaml += "  g" + std::to_string(i) + ": {block: Gain, gain: " + std::to_string(i + 2) +
            ", u: " + (i == 0 ? "s" : "g" + std::to_string(i - 1)) + "}\n";
  return yaml;
}

}  // namespace

TEST_CASE("numbers are written so that they read back to the same bits, and are never whole") {
  for (double number : {0.1, -0.0, 3.0, 1e300, 5e-324, 1.0 / 3.0, 123456789012345680.0}) {
    const std::string text = number_text(number);
    INFO(text);
    const double read = std::strtod(text.c_str(), nullptr);
    CHECK(std::memcmp(&read, &number, sizeof number) == 0);
    CHECK(text.find_first_of(".e") != std::string::npos);
  }
  CHECK(number_text(std::numeric_limits<double>::infinity()) == "unlimited");
  CHECK(number_text(-std::numeric_limits<double>::infinity()) == "-unlimited");
}

TEST_CASE("each call names its block and the line of the file") {
  const std::string text =
      program_of("blocks:\n  half: {block: Gain, gain: 0.5, u: wave}\n  wave: {block: Sine}\n");
  CHECK_THAT(text, Contains("{  // half: Gain, test.yaml:2\n    Gain b;\n    b.gain = 0.5;\n"));
  CHECK_THAT(text, Contains("half_y = ") && Contains("// half.y, Gain, test.yaml:2"));
}

TEST_CASE("a program has the elementary functions that its diagram names") {
  const auto files_of = [](const std::string& end) {
    const plan::Plan plan = plan_text("blocks: {wave: {block: Sine}}\n" + end);
    return program_files(plan, tuning_of(plan), {"wave", "a test"});
  };
  const auto portable = files_of(""), same = files_of("functions: portable\n"),
             libm = files_of("functions: libm\n");
  CHECK(portable == same);
  CHECK_THAT(portable.at("wave.cpp"), Contains("#ifndef STEPWIRE_SLEEF\n#define STEPWIRE_LIBM\n#endif\n"));
  CHECK_THAT(portable.at("CMakeLists.txt"), Contains("find_library(STEPWIRE_SLEEF NAMES sleef)"));
  CHECK_THAT(libm.at("wave.cpp"), Contains("as the diagram says.\n#define STEPWIRE_LIBM\n"));
  CHECK_THAT(libm.at("CMakeLists.txt"), !Contains("SLEEF"));
}

TEST_CASE("a block without a header is refused with its name and its line") {
  Registry registry;
  registry.add<Foreign>("test");
  const plan::Plan plan = plan_text("blocks:\n  odd: {block: Foreign, u: 1}\n", {}, registry);
  try {
    make_program(plan);
    FAIL("it is not refused");
  } catch (const yaml::Error& error) {
    CHECK(std::string(error.what()) ==
          "test.yaml:2:8: odd: Foreign cannot be generated: no header declares its struct");
  }
}

TEST_CASE("a small program is written out, and a large one of like blocks becomes loops") {
  CHECK(count_of(program_of(gains(20)), "Gain b;") == 20);
  CHECK(count_of(program_of(gains(500)), "Gain b;") == 1);
}

TEST_CASE("numbers that a parameter changes are read from the run, all others are written") {
  const plan::Plan plan = plan_text(
      "parameters: {k: 0.5}\nblocks:\n  half: {block: Gain, gain: $k, u: 1}\n"
      "  third: {block: Gain, gain: 0.25, u: half}\n");
  const auto variable = plan::variable_blocks(plan, diagram::Variation(plan.diagram, {"k"}));
  const std::string text = make_steps(plan, variable).text;
  CHECK(text.find("b.gain = numbers[") == std::string::npos);  // what is constant is computed once, elsewhere
  const plan::Plan moving = plan_text(
      "parameters: {k: 0.5}\nblocks:\n  wave: {block: Sine}\n  half: {block: Gain, gain: $k, u: wave}\n"
      "  third: {block: Gain, gain: 0.25, u: half}\n");
  const std::string moved =
      make_steps(moving, plan::variable_blocks(moving, diagram::Variation(moving.diagram, {"k"}))).text;
  CHECK_THAT(moved, Contains("b.gain = numbers[0];"));
  CHECK_THAT(moved, Contains("b.gain = 0.25;"));
  const plan::NumberTable numbers(moving,
                                  plan::variable_blocks(moving, diagram::Variation(moving.diagram, {"k"})),
                                  [&](std::size_t b) { return moving.diagram.blocks[b].block.get(); });
  REQUIRE(numbers.size() == 1);
  CHECK(numbers.data()[0] == 0.5);
}

TEST_CASE("lists of any length share a program where they vary") {
  const auto plan_of = [](int rows) {
    std::string points, values;
    for (int i = 0; i < rows; ++i) {
      points += (i == 0 ? "" : ", ") + std::to_string(i);
      values += (i == 0 ? "" : ", ") + std::to_string(i * i);
    }
    return plan_text("parameters: {x: [" + points + "], y: [" + values +
                     "]}\nblocks:\n  wave: {block: Sine}\n"
                     "  curve: {block: LookupTable, u: wave, points: $x, values: $y}\n");
  };
  const plan::Plan one = plan_of(100), other = plan_of(300);
  auto variable = plan::variable_blocks(one, diagram::Variation(one.diagram, {"x", "y"}));
  CHECK(make_steps(one, variable).text != make_steps(other, variable).text);  // the length is a constant
  plan::widen(variable, one, [&](std::size_t b) { return other.diagram.blocks[b].block.get(); });
  const auto size_of = [&](const plan::Plan& plan) {
    return plan::NumberTable(plan, variable,
                             [&](std::size_t b) { return plan.diagram.blocks[b].block.get(); })
        .size();
  };
  CHECK(size_of(other) == size_of(one) + 400);
  CHECK(make_steps(one, variable).text == make_steps(other, variable).text);
  CHECK(make_steps(one, variable).text.find("constexpr double curve") == std::string::npos);
}

TEST_CASE(
    "where a parameter varies, what its block computes is read from the run, other parameters are not") {
  const plan::Plan plan = plan_text(
      "step: 1 ms\nsolver: rk4\nparameters: {beta: 3, high: 20}\nblocks:\n  wave: {block: Sine}\n"
      "  damper: {block: RotaryMRDamper, velocity: wave, current: 0.5 A, beta: $beta, alpha: [$high, 5]}\n");
  const auto text = [&](const std::string& name) {
    return make_steps(plan, plan::variable_blocks(plan, diagram::Variation(plan.diagram, {name}))).text;
  };
  CHECK_THAT(text("beta"), Contains("b.beta = numbers[0];"));
  CHECK_THAT(text("beta"), Contains("b.factors = {numbers[1], numbers[2], numbers[3]};"));
  CHECK(text("beta").find("b.n = ") == std::string::npos);
  CHECK_THAT(text("beta"), Contains("b.alpha = Numbers::view(table::damper_alpha, 2);"));
  CHECK_THAT(text("high"),
             Contains("b.scaled_alpha = Numbers::view(numbers + static_cast<Index>(numbers[4]), 2);"));
}

TEST_CASE("formulas have one type for equal ones, whose name is no word of C++ or of the library") {
  const std::string program = program_of(R"yaml(blocks:
  t: {block: Clock}
  new: {block: Expression, expression: "2*u1 + 1", u: t}
  std: {block: Expression, expression: "sin(u1)", u: t}
  twin: {block: Expression, expression: "u1*2 + 1", u: t}
  same: {block: Expression, expression: "2*u1 + 1", u: t}
)yaml");
  for (const char* type : {"struct new_code {", "struct std_code {", "struct twin_code {"})
    CHECK_THAT(program, Contains(type));
  CHECK_THAT(program, Contains("return 2.0 * v[0] + 1.0;") && !Contains("same_code"));
  CHECK(count_of(program, "using Code = formula::new_code;") == 2);
}

TEST_CASE("the same diagram gives the same text") {
  CHECK(program_of(gains(3)) == program_of(gains(3)));
}

}  // namespace stepwire::codegen
