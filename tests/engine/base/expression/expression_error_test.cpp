#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

namespace {

struct Wrong {
  std::string message;
  std::size_t position;
  bool operator==(const Wrong&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Wrong& wrong) {
  return out << wrong.position << ": " << wrong.message;
}

Wrong wrong(const std::string& text) {
  try {
    const Expression expression(text, [](std::string_view name) { return name == "tau" || name == "x"; });
  } catch (const ExpressionError& error) {
    return {error.what(), error.position};
  }
  return {"no error", 0};
}

std::string repeated(int count, const std::string& piece) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

}  // namespace

TEST_CASE("an error says what is wrong and where") {
  CHECK(wrong("2*taw") == Wrong{"unknown name 'taw'", 2});
  CHECK(wrong("x + sine(x)") == Wrong{"unknown function 'sine'; did you mean 'sin'?", 4});
  CHECK(wrong("") == Wrong{"the expression is empty", 0});
  CHECK(wrong("   ") == Wrong{"the expression is empty", 0});
  CHECK(wrong("x +") == Wrong{"a value is missing at the end", 3});
  CHECK(wrong("x * / tau") == Wrong{"a value is missing before '/'", 4});
  CHECK(wrong("x ** 2") == Wrong{"a value is missing before '*'; a power is x^y", 3});
  CHECK(wrong("()") == Wrong{"a value is missing before ')'", 1});
  CHECK(wrong("x tau") == Wrong{"an operator is missing before 'tau'", 2});
  CHECK(wrong("2 e-3") ==
        Wrong{"an operator is missing before 'e'; a power of ten has no blanks, as in 2e-3", 2});
  CHECK(wrong("3 tau") == Wrong{"an operator is missing before 'tau'", 2});
  CHECK(wrong("2 (x)") == Wrong{"an operator is missing before '('", 2});
  CHECK(wrong("(x + 1") == Wrong{"'(' without ')'", 0});
  CHECK(wrong("x + 1)") == Wrong{"')' without '('", 5});
  CHECK(wrong("x ? 1") == Wrong{"'?' without ':'", 2});
  CHECK(wrong("(x ? 1) : 2") == Wrong{"'?' without ':'", 3});
  CHECK(wrong("x : 1") == Wrong{"':' without '?'", 2});
  CHECK(
      wrong("1 + max(x)") ==
      Wrong{"'max' of one value is that value; max(a, b) compares several, and the largest of a recording is "
            "the reduction of a claim, 'max: ...'",
            4});
  CHECK(wrong("min(x)").message.starts_with("'min' of one value is that value; min(a, b) compares several"));
  CHECK(wrong("atan2(x)") == Wrong{"'atan2' takes 2 values, not 1", 0});
  CHECK(wrong("sin(x, x)") == Wrong{"'sin' takes 1 value, not 2", 0});
  CHECK(wrong("sin()") == Wrong{"a value is missing before ')'", 4});
  CHECK(wrong("sin + 1") == Wrong{"'sin' is a function; write sin(...)", 0});
  CHECK(wrong("x = 3") == Wrong{"unexpected =; an expression assigns nothing; to compare write '=='", 2});
  CHECK(wrong("x & 3") == Wrong{"unexpected &; write '&&'", 2});
  CHECK(wrong("x % 3") == Wrong{"unexpected %; the remainder is mod(x, y)", 2});
  CHECK(wrong("x, tau") == Wrong{"',' only separates the values of a function or a list", 1});
  CHECK(wrong("(x, tau)") == Wrong{"',' only separates the values of a function or a list", 2});
  CHECK(wrong("x == \"a\"") == Wrong{"unexpected \"; an expression has no text", 5});
  CHECK(wrong("x · tau") == Wrong{"unexpected '·'", 2});
  CHECK(wrong("x; tau") == Wrong{"unexpected ';'", 1});
  CHECK(wrong("1e-400 + x") == Wrong{"'1e-400' is out of range", 0});
  CHECK(wrong("1e999 + x") == Wrong{"'1e999' is out of range", 0});
  CHECK(wrong("x + 1e308 km") == Wrong{"'1e308 km' is out of range", 4});
  CHECK(wrong("0x10") == Wrong{"an operator is missing before 'x10'", 1});
  CHECK(wrong("5 min(x, tau)") == Wrong{"an operator is missing before 'min'", 2});
  CHECK(wrong(std::string("x\0", 2)) == Wrong{"unexpected character 0x00", 1});
}

TEST_CASE("texts that are too long or too deep are refused and never overflow") {
  CHECK(wrong(repeated(10'000, "(") + "x" + repeated(10'000, ")")).message ==
        "an expression has at most 5000 characters");
  CHECK(wrong(repeated(300, "(") + "x" + repeated(300, ")")) ==
        Wrong{"more than 200 parentheses are open", 200});
  CHECK(wrong(repeated(200, "(") + "x" + repeated(200, ")")).message == "no error");
  CHECK(wrong(repeated(4999, "-") + "x").message == "no error");
  CHECK(wrong(repeated(4999, "!") + "x").message == "no error");
  CHECK(wrong(repeated(1249, "x?x:") + "x").message == "no error");
  CHECK(wrong(repeated(2499, "x^") + "x").message == "no error");
  CHECK(wrong(repeated(2499, "1+") + "x").message == "no error");
}

TEST_CASE("many different names fit into the longest text") {
  std::string text = "aaa";
  for (int i = 1; i < 1200; ++i) {
    text += std::string("+") + char('a' + i % 26) + char('a' + i / 26 % 26) + char('a' + i / 676 % 26);
  }
  const Expression expression(text);
  CHECK(expression.variables().size() > 1000);
  CHECK(expression(std::vector<double>(expression.variables().size(), 1.0)) == 1200.0);
}

TEST_CASE("no text at all makes anything but a value or an error") {
  const std::vector<std::string> pieces{"x",  "tau", "1", "2.5", " ",    "(",  ")",  "+",    "-",
                                        "*",  "/",   "^", "<",   "<=",   "==", "!=", "&&",   "!",
                                        "||", "? ",  ":", ",",   "sin(", "e",  "mm", "max(", "N",
                                        ".",  "%",   "=", "[",   "]",    "1e", "µ",  "\t",   "min"};
  std::mt19937 random(7);
  int accepted = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (unsigned length = random() % 9; length > 0; --length) text += pieces[random() % pieces.size()];
    INFO(text);
    const Wrong answer = wrong(text);
    accepted += answer.message == "no error" ? 1 : 0;
    REQUIRE_FALSE(answer.message.empty());
  }
  CHECK(accepted > 100);
}

TEST_CASE("comparisons in a row are refused, since the second would compare 0 or 1") {
  const std::string cure = " follows on a comparison; write a < b && b < c, or parentheses";
  CHECK(wrong("1 < x < 3") == Wrong{"'<'" + cure, 6});
  CHECK(wrong("x + 1 == tau == 3") == Wrong{"'=='" + cure, 13});
  CHECK(wrong("tau < x && x < 3").message == "no error");
  CHECK(wrong("(tau < x) == (x < 3)").message == "no error");
  CHECK(wrong("tau < x ? x < 3 : x > 4").message == "no error");
}

}  // namespace stepwire::expression
