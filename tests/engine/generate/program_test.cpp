#include "engine/generate/program.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "engine/block/declare.hpp"
#include "tests/support/plan_text.hpp"

using namespace stepwire;
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

TEST_CASE("a block that is not of the library is refused with its name and its line") {
  Registry registry;
  registry.add<Foreign>("test");
  const Plan plan = plan_text("blocks:\n  odd: {block: Foreign, u: 1}\n", {}, registry);
  try {
    make_program(plan);
    FAIL("it is not refused");
  } catch (const Error& error) {
    CHECK(std::string(error.what()) ==
          "test.yaml:2:8: odd: Foreign cannot be generated: its type is not one of the library");
  }
}

TEST_CASE("a small program is written out, and a large one of like blocks becomes loops") {
  CHECK(count_of(program_of(gains(20)), "Gain b;") == 20);
  CHECK(count_of(program_of(gains(500)), "Gain b;") == 1);
}

TEST_CASE("numbers that vary become parameters, those of blocks first and then those that feed inputs") {
  const Plan plan = plan_text("blocks:\n  half: {block: Gain, gain: 0.5, u: 1}\n");
  const GeneratedProgram plain = make_program(plan);
  REQUIRE(plain.parameters.numbers == std::vector<double>{0.5, 1.0});  // the gain, and what feeds it
  const Varying varying{true, true};
  const std::string text = make_program(plan, &varying).text;
  CHECK_THAT(text, Contains("b.gain = parameters[0];"));
  CHECK_THAT(text, Contains("] = parameters[1];"));
}

TEST_CASE("lists of any length share a program where they vary") {
  const auto plan_of = [](int rows) {
    std::string points, values;
    for (int i = 0; i < rows; ++i) {
      points += (i == 0 ? "" : ", ") + std::to_string(i);
      values += (i == 0 ? "" : ", ") + std::to_string(i * i);
    }
    return plan_text("blocks:\n  curve: {block: LookupTable, u: 1, points: [" + points + "], values: [" +
                     values + "]}\n");
  };
  const Plan one = plan_of(100), other = plan_of(300);
  const ProgramNumbers first = make_program(one).parameters, second = make_program(other).parameters;
  REQUIRE(first.singles() == second.singles());
  CHECK(first.numbers.size() == first.singles() + 200);
  CHECK(second.numbers.size() == second.singles() + 600);
  const Varying varying(first.singles(), true);
  CHECK(make_program(one, &varying).text == make_program(other, &varying).text);
  CHECK(make_program(one, &varying).text.find("constexpr double curve") == std::string::npos);
}

TEST_CASE("the same diagram gives the same text") {
  CHECK(program_of(gains(3)) == program_of(gains(3)));
}
