#include <catch2/catch.hpp>
#include <cmath>

#include "blocks/math/expression.hpp"
#include "engine/model/block/declare.hpp"
#include "tests/support/literal_text.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

std::string diagram_text(const std::string& keys) {
  return "step: 0.25 s\nstop: 1 s\nblocks:\n  t: {block: Clock}\n  y: {block: Expression, " + keys +
         "}\nrecord: [y]\n";
}

}  // namespace

TEST_CASE("a formula sees its inputs as u1, u2 and one alone as u") {
  const auto two =
      column(run_text(diagram_text("expression: 'sin(u1)*u2 - (u2 > 2 ? 1 : 0)', u: [t, 3]")), "y");
  const auto one = column(run_text(diagram_text("expression: u^2 + 1, u: [t]")), "y");
  for (std::size_t i = 0; i < two.size(); ++i) {
    const double t = 0.25 * static_cast<double>(i);
    REQUIRE(two[i] == Approx(3.0 * std::sin(t) - 1.0).margin(1e-15));
    REQUIRE(one[i] == Approx(t * t + 1.0));
  }
}

TEST_CASE("a formula goes element by element") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  a: {block: Constant, value: [1, 2, 3]}
  squares: {block: Expression, expression: u1 * u1 + u2, u: [a, 10]}
  total: {block: MatrixGain, gain: [[1, 1, 1]], u: squares}
record: [total]
)");
  REQUIRE(column(run, "total").back() == 44.0);
}

TEST_CASE("a formula that cannot be read is refused with the place in it") {
  REQUIRE_THAT(error_of(diagram_text("expression: u1 + * 2, u: [t]")),
               Catch::Contains("y.expression") && Catch::Contains("character 6"));
  REQUIRE_THAT(error_of(diagram_text("expression: u1 + u2, u: [t]")),
               Catch::Contains("y.expression") && Catch::Contains("character 6"));
  REQUIRE_THAT(error_of(diagram_text("expression: u1 + t, u: [t]")), Catch::Contains("Clock"));
}

TEST_CASE("inputs of a formula may have names of their own, one for each") {
  CHECK(column(run_text(diagram_text("expression: radius*cos(t), variables: [t, radius], u: [t, 3]")), "y")
            .back() == Approx(3.0 * std::cos(1.0)));
  CHECK_THAT(error_of(diagram_text("expression: u1, variables: [t, radius], u: [t, 3]")),
             Catch::Contains("it may use t, radius"));
  CHECK_THAT(error_of(diagram_text("expression: t, variables: [t, radius], u: [t]")),
             Catch::Contains("y.variables: there are 2 names for 1 input; each needs one"));
}

TEST_CASE("a formula has at most 64 inputs") {
  const auto with_inputs = [](int count) {
    std::string list = "t";
    for (int i = 1; i < count; ++i) list += ", t";
    return diagram_text("expression: u1 + u64 + u, u: [" + list + "]");
  };
  CHECK(column(run_text(with_inputs(64)), "y").back() == 3.0);
  CHECK_THAT(error_of(with_inputs(65)), Catch::Contains("y.expression: 65 inputs are more than 64"));
}

TEST_CASE("a formula reads as C++ over its inputs, and its block runs with that in its place") {
  Declare<ExpressionBlock> declaration;
  ExpressionBlock::declare(declaration);
  const BlockType type = declaration.take();
  ExpressionBlock block;
  block.expression = "u3 > 4 mm ? u1 : 2";
  Configure is({}, 0.0, {{"u", 3}});
  block.configure(is);
  CHECK(literal_text(type, &block, "formula") ==
        "Function([](const double* v) -> double { return v[2] > 0.004 ? v[0] : 2.0; })");
  block.expression = "1 + 1";
  block.configure(is);
  CHECK(literal_text(type, &block, "formula") ==
        "Function([](const double*) -> double { return 1.0 + 1.0; })");

  const double numbers[] = {7.0, 8.0, 0.005, 0.003};
  double y[2] = {};
  const Inputs::Element inputs[] = {{numbers, 1}, {numbers, 1}, {numbers + 2, 2}};
  block.u.bind(inputs, 3);
  block.y.bind(y, 2);
  block.formula = Function([](const double* v) -> double { return v[2] > 0.004 ? v[0] : 2.0; });
  block.outputs();
  CHECK((y[0] == 7.0 && y[1] == 2.0));
}
