#include <catch2/catch.hpp>
#include <regex>
#include <string>

#include "tests/house/source_tree.hpp"

namespace {

/// Folders whose sources compute numbers of a run.
const std::vector<std::string> of_runs{"blocks",           "engine/base/control",  "engine/base/expression",
                                       "engine/base/math", "engine/base/sampling", "engine/model",
                                       "engine/simulate"};

/// The one header that chooses between SLEEF and the C library.
const std::string chooses = "engine/base/math/elementary.hpp";

/// True for a line with a function of the C library whose bits depend on the machine.
bool uses_c_library(const std::string& line) {
  static const std::regex function(
      R"(std::(a?(sin|cos|tan)h?|atan2|exp2?|expm1|log(1p|2|10)?|pow|cbrt|hypot|erfc?|[lt]gamma|polar)\()");
  return std::regex_search(line, function);
}

}  // namespace

TEST_CASE("numbers of a run come from the elementary functions that have the same bits on every machine") {
  std::size_t count = 0;
  for (const std::string& file : sources_under(of_runs)) {
    if (file == chooses) continue;
    for (const Line& line : lines_of(file)) {
      INFO(line.place() << ": " << line.text << "; fn::sin(x) of " << chooses << " replaces std::sin(x)");
      CHECK_FALSE(uses_c_library(line.text));
      count += line.text.find("fn::") != std::string::npos ? 1 : 0;
    }
  }
  CHECK(count > 80);
}

TEST_CASE("functions of the C library are found by their names") {
  for (const char* line :
       {"std::sin(x)", "y = 2.0 * std::atan2(y, x);", "std::log1p(x)", "std::exp2(x)", "std::erfc(x)"})
    CHECK(uses_c_library(line));
  for (const char* line :
       {"fn::sin(x)", "std::sqrt(x)", "std::fmod(x, y)", "std::ldexp(x, 1)", "std::exponential(x)"})
    CHECK_FALSE(uses_c_library(line));
}
