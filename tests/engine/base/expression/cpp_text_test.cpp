#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Texts over the whole grammar, of the variables x, y and z.
class Maker {
 public:
  std::string formula(int depth) {
    std::string text = terms(depth);
    if (one_in(5)) text += " ? " + terms(depth) + " : " + (one_in(2) ? formula(depth) : terms(depth));
    return text;
  }

 private:
  bool one_in(unsigned n) { return random_() % n == 0; }

  template <std::size_t n>
  std::string any(const std::array<const char*, n>& of) {
    return of[random_() % n];
  }

  std::string terms(int depth) {
    std::string text = term(depth);
    bool compares = false;  // comparisons cannot be chained
    for (unsigned more = random_() % 4; more > 0; --more) {
      std::string sign = any(operators_);
      const bool comparison = sign.find_first_of("<>=") != sign.npos;
      if (comparison && compares) sign = " + ";
      compares = comparison || (compares && sign.find_first_of("&|") == sign.npos);
      text += sign + term(depth);
    }
    return text;
  }

  std::string term(int depth) {
    std::string text;
    for (unsigned signs = one_in(3) ? random_() % 4 : 0; signs > 0; --signs) text += any(signs_);
    if (depth == 0 || one_in(3)) return text + any(leaves_);
    return text + (one_in(3) ? "(" + formula(depth - 1) + ")" : call(depth - 1));
  }

  std::string call(int depth) {
    const unsigned kind = random_() % 4;
    if (kind < 2) return any(ones_) + "(" + formula(depth) + ")";
    std::string values = formula(depth);
    const unsigned count = kind == 2 ? 2 : 2 + random_() % 3;
    for (unsigned i = 1; i < count; ++i) values += ", " + formula(depth);
    return (kind == 2 ? any(twos_) : any(lists_)) + "(" + values + ")";
  }

  static constexpr std::array operators_{
      " + ", " - ", " * ", " / ", "^", " < ", " <= ", " > ", "-", " >= ", " == ", " != ", " && ", " || "};
  static constexpr std::array signs_{"-", "!", "+"};
  static constexpr std::array leaves_{"x", "y",   "z",     "x",      "y",  "z",        "0",
                                      "2", "0.1", "1e300", "(3 mm)", "pi", "(20 degC)"};
  static constexpr std::array ones_{"sin",  "cos",  "tan",  "asin",  "acos", "atan",  "sinh",
                                    "cosh", "tanh", "exp",  "log",   "log2", "log10", "sqrt",
                                    "cbrt", "abs",  "sign", "floor", "ceil", "round"};
  static constexpr std::array twos_{"atan2", "mod", "hypot"};
  static constexpr std::array lists_{"min", "max"};

  std::mt19937 random_{5};
};

std::string repeated(int count, const std::string& piece) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

std::vector<std::string> texts() {
  std::vector<std::string> all{"-2^2",
                               "2^3^2",
                               "2^-x^2",
                               "-x^y",
                               "x - -y",
                               "--x",
                               "-!x / !y",
                               "(x < y) / (y < z)",
                               "-(x < y)",
                               "!x == (y < z)",
                               "x - y - z",
                               "x - (y - z)",
                               "x / y / z",
                               "x / (y / z)",
                               "x*y/z",
                               "x*(y/z)",
                               "x + y + z",
                               "x + (y + z)",
                               "x^2 + x^0.5 + x^-1",
                               "x ? y : z ? 1 : 2",
                               "x ? y ? 1 : 2 : z",
                               "(x ? y : z) ? 1 : 2",
                               "1 + x ? y : z",
                               "x || y && z",
                               "(x || y) && z",
                               "1 || x / 0",
                               "sin(1) + exp(2)*cbrt(3) + hypot(1, 3) + 2^0.1",
                               "x > 4 mm",
                               "min(x, 1)",
                               "max(x, y, z, 0)",
                               "min(x, y)",
                               "mod(x, y)",
                               "sign(x)",
                               "round(x)",
                               "uniform(x, y)",
                               "uniform(12, 3)",
                               "lognormal(x, y, z)",
                               "lognormal(12, 3, 0.3)",
                               "x == x",
                               "0.30000000000000004*x",
                               "x - 123456789012345678",
                               "1/0 - 1/0",
                               repeated(150, "-") + "x",
                               repeated(100, "x?y:") + "z",
                               repeated(100, "(y - ") + "x" + repeated(100, ")"),
                               repeated(100, "x^") + "y",
                               repeated(500, "x - ") + "y"};
  Maker maker;
  for (int i = 0; i < 300; ++i) all.push_back(maker.formula(i % 3));
  return all;
}

/// A shared library, compiled from the formulas and opened.
class Compiled {
 public:
  explicit Compiled(const std::vector<Expression>& expressions) {
    std::filesystem::create_directories(folder_);
    std::ofstream out(folder_ / "formulas.cpp");
    out << "#include \"engine/base/expression/language.hpp\"\nnamespace stepwire {\n"
           "extern \"C\" double (*const formulas[])(const double*) = {\n";
    for (const Expression& expression : expressions)
      out << "[](const double* v) -> double { return " << expression.cpp() << "; },\n";
    out << "[](const double*) -> double { return 0.0; }};\n}\n";
    out.close();
    if (std::system(command().c_str()) == 0) library_ = dlopen((folder_ / "formulas.so").c_str(), RTLD_NOW);
  }
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;
  ~Compiled() {
    if (library_) dlclose(library_);
    std::filesystem::remove_all(folder_);
  }

  using Function = double (*)(const double*);
  const Function* functions() const {
    return library_ ? static_cast<const Function*>(dlsym(library_, "formulas")) : nullptr;
  }

 private:
  std::string command() const {
    std::string text =
        "c++ -std=c++20 -O2 -ffp-contract=off -DSTEPWIRE_SLEEF -shared -fPIC -I'" STEPWIRE_SOURCE_DIR "'";
    for (const char* function : {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh",
                                 "exp", "log", "log1p", "log2", "log10", "cbrt", "hypot", "pow"})
      text += std::string(" -fno-builtin-") + function;
    return text + " -o '" + (folder_ / "formulas.so").string() + "' '" + (folder_ / "formulas.cpp").string() +
           "'";
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("stepwire-formulas-" + std::to_string(std::random_device()()));
  void* library_ = nullptr;
};

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

/// Returns a point at which the two values differ in bits, as text; empty if there is none.
std::string difference(const Expression& expression, Compiled::Function function) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr std::array grid{0.0,       -0.0,      1.0,      -1.0,      0.7, -2.3,
                            1.0 / 3.0, 4e9 / 7.0, infinity, -infinity, nan, 5e-324};
  constexpr std::size_t size = grid.size();
  for (std::size_t i = 0; i < size * size * size; ++i) {
    const std::array v{grid[i % size], grid[i / size % size], grid[i / size / size]};
    const double interpreted = expression(v), compiled = function(v.data());
    if (!same_bits(interpreted, compiled))
      return fmt::format("at {}: {} interpreted, {} compiled", fmt::join(v, ", "), interpreted, compiled);
  }
  return "";
}

}  // namespace

TEST_CASE("an expression reads as C++ does, with the parentheses that C++ needs") {
  const auto cpp = [](const std::string& text) { return Expression(text).cpp(); };
  CHECK(cpp("u1 > 5 mm && after >= 2 s") == "v[0] > 0.005 && v[1] >= 2.0");
  CHECK(cpp("-2^2 + x*(y - 1)") == "-fn::pow(2.0, 2.0) + v[0] * (v[1] - 1.0)");
  CHECK(cpp("(x < y) < 1") == "language::number(v[0] < v[1]) < 1.0");
  CHECK(cpp("x && y || z") == "(v[0] != 0.0 && v[1] != 0.0) || v[2] != 0.0");
  CHECK(cpp("- -x - !-y") == "v[0] - language::number(v[1] == 0.0)");
  CHECK(cpp("!!x + !(x < y)") == "language::number(!(v[0] == 0.0)) + language::number(!(v[0] < v[1]))");
  CHECK(cpp("-(-x)") == "-(-v[0])");
  CHECK(cpp("x ? y ? 1 : x < 2 : max(x, mod(y, pi))") ==
        "v[0] != 0.0 ? (v[1] != 0.0 ? 1.0 : language::number(v[0] < 2.0)) : "
        "language::max({v[0], language::mod(v[1], 3.141592653589793)})");
  CHECK(Expression("x * y").cpp_condition() == "v[0] * v[1] != 0.0");
  CHECK(Expression("x < y").cpp_condition() == "v[0] < v[1]");
  CHECK(Expression("a + b").cpp([](std::size_t i) { return i == 0 ? "force" : "load"; }) == "force + load");
}

TEST_CASE("no text is too long or too deep to be written as C++") {
  for (const std::string& text : {repeated(200, "(") + "x" + repeated(200, ")"), repeated(4999, "-") + "x",
                                  repeated(1249, "x?x:") + "x", repeated(2499, "x^") + "x",
                                  repeated(2499, "1+") + "x", "min(" + repeated(2497, "1,") + "x)"})
    CHECK_THAT(Expression(text).cpp(), Catch::Contains("v[0]"));
}

TEST_CASE("compiled as C++, expressions have the bits that an evaluation gives them", "[full]") {
  if (std::system("c++ --version > /dev/null 2>&1") != 0) {
    WARN("skipped: there is no compiler called c++");
    return;
  }
  std::vector<Expression> expressions;
  for (const std::string& text : texts()) expressions.emplace_back(text);
  const Compiled compiled(expressions);
  REQUIRE(compiled.functions());
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    INFO(expressions[i].text() << " is " << expressions[i].cpp());
    CHECK(difference(expressions[i], compiled.functions()[i]) == "");
  }
}

}  // namespace stepwire::expression
