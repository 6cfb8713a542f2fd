#include "engine/app/simulink/matlab.hpp"

#include <catch2/catch.hpp>
#include <limits>

namespace stepwire::simulink {

namespace {

using Catch::Contains;

Value of(const std::string& text) {
  return evaluated(text, [](const std::string& name, bool is_function) -> Value {
    if (name == "K") return Value::of(Cell{3.0, "K"});
    if (is_function) return Value::missing();
    throw ValueError("reads '" + name + "'");
  });
}

std::vector<double> numbers(const std::string& text) {
  return of(text).numbers();
}

}  // namespace

TEST_CASE("MATLAB's operators have its precedence") {
  CHECK(numbers("2*pi*50")[0] == Approx(314.159265358979));
  CHECK(numbers("-2^2")[0] == -4.0);
  CHECK(numbers("2^3^2")[0] == 64.0);
  CHECK(numbers("2^-1")[0] == 0.5);
  CHECK(numbers("2^--1")[0] == 2.0);
  CHECK(numbers("2^-1^2")[0] == 0.25);
  CHECK(numbers("1./[1 2]") == std::vector{1.0, 0.5});
  CHECK(numbers("1 - 2 - 3")[0] == -4.0);
  CHECK(numbers("8/2/2")[0] == 2.0);
  CHECK(numbers("-(1 + 2)*3")[0] == -9.0);
  CHECK(numbers("inf")[0] == std::numeric_limits<double>::infinity());
  CHECK(numbers("1e-3")[0] == 0.001);
}

TEST_CASE("brackets make vectors and matrices, and blanks part elements") {
  CHECK(numbers("[1 -2]") == std::vector{1.0, -2.0});
  CHECK(numbers("[1 - 2]") == std::vector{-1.0});
  CHECK(numbers("[1, 2, 3]") == std::vector{1.0, 2.0, 3.0});
  CHECK(numbers("[1 (2) -3*2]") == std::vector{1.0, 2.0, -6.0});
  CHECK(numbers("[[1 2] 3]") == std::vector{1.0, 2.0, 3.0});
  CHECK(numbers("0:0.1:0.3").size() == 4);
  CHECK(numbers("3:-1:1") == std::vector{3.0, 2.0, 1.0});
  const Value matrix = of("[1 2; 3 4]*[0 1; 1 0]");
  CHECK(matrix.rows == 2);
  CHECK(matrix.numbers() == std::vector{2.0, 1.0, 4.0, 3.0});
  CHECK(of("[1 2]'").rows == 2);
  CHECK(numbers("[1 2].*[3 4]") == std::vector{3.0, 8.0});
  CHECK(numbers("[1 2]*[3; 4]") == std::vector{11.0});
  CHECK(of("[]").cells.empty());
  CHECK(numbers("eye(2)") == std::vector{1.0, 0.0, 0.0, 1.0});
  CHECK(numbers("conv([1 1], [1 2])") == std::vector{1.0, 3.0, 2.0});
  CHECK(numbers("max([1 5 2])") == std::vector{5.0});
  CHECK(numbers("linspace(0, 1, 3)") == std::vector{0.0, 0.5, 1.0});
}

TEST_CASE("variables stay in formulas, with brackets where they are needed") {
  CHECK(of("2*K").cells[0].formula() == "2*K");
  CHECK(of("2*(K + 1)").cells[0].formula() == "2*(K + 1)");
  CHECK(of("1/(2*K)").cells[0].formula() == "1/(2*K)");
  CHECK(of("1 - (K - 2)").cells[0].formula() == "1 - (K - 2)");
  CHECK(of("-K^2").cells[0].formula() == "-K^2");
  CHECK(of("(-K)^2").cells[0].formula() == "(-K)^2");
  CHECK(of("K^(2*K)").cells[0].formula() == "K^(2*K)");
  CHECK(of("sqrt(K)*-1").cells[0].formula() == "sqrt(K)*(-1)");
  CHECK(of("[0 1; -K 0]").at(1, 0).formula() == "-K");
  CHECK(of("-K^2").cells[0].number == -9.0);
}

TEST_CASE("texts without a value here are refused with the reason") {
  CHECK_THROWS_WITH(of(""), "is empty or ends too early");
  CHECK_THROWS_WITH(of("1 +"), "is empty or ends too early");
  CHECK_THROWS_WITH(of("2i"), "is complex");
  CHECK_THROWS_WITH(of("'abc'"), "is a text, and numbers are expected");
  CHECK_THROWS_WITH(of("[1 2"), "has '[' without ']'");
  CHECK_THROWS_WITH(of("[1 2; 3]"), "has rows of different lengths");
  CHECK_THROWS_WITH(of("[1 2] + [1 2 3]"), "joins 1 x 2 and 1 x 3");
  CHECK_THROWS_WITH(of("1:1e9"), "has more than 1,000,000 numbers");
  CHECK_THROWS_WITH(of(std::string(10'000, '(')), "is nested too deeply");
  CHECK_THROWS_WITH(of("zeros(1e5)"), Contains("1,000,000"));
}

TEST_CASE("scripts are assignments and other statements") {
  std::vector<std::string> others;
  const std::vector<Assignment> found =
      assignments_of("a = 1; b=[1, 2; ...\n 3 4] % note\nclear\nload x.mat\nif a == 1", others);
  REQUIRE(found.size() == 2);
  CHECK(found[1].name == "b");
  CHECK(others == std::vector<std::string>{"load x.mat", "if a == 1"});
}

}  // namespace stepwire::simulink
