#include <catch2/catch.hpp>
#include <ctime>
#include <random>
#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::yaml {
using Catch::Contains;

namespace {

std::string error_of(const std::string& text) {
  const std::clock_t start = std::clock();  // what it costs, however busy the machine is
  std::string error = "none";
  try {
    parse_document(text, "a.yaml");
  } catch (const Error& wrong) {
    error = wrong.what();
  }
#ifdef NDEBUG                                         // a build with sanitizers is slower by far
  CHECK(std::clock() - start < 60 * CLOCKS_PER_SEC);  // what is read without limits takes hours
#else
  (void)start;
#endif
  return error;
}

std::string repeat(const std::string& piece, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += piece;
  return text;
}

}  // namespace

TEST_CASE("ten thousand levels are an error of every kind of nesting") {
  const std::string deep = "nested deeper than 64 levels";
  CHECK_THAT(error_of(repeat("[", 10'000) + repeat("]", 10'000)), Contains("a.yaml:1:65: " + deep));
  CHECK_THAT(error_of("a: " + repeat("[", 10'000)),
             Contains("a.yaml:1:5: ") && Contains("close the bracket"));
  CHECK_THAT(error_of("a: " + repeat("{a: ", 10'000) + repeat("}", 10'000)), Contains(deep));
  CHECK_THAT(error_of(repeat("- ", 10'000) + "x"), Contains("a.yaml:1:129: " + deep));
  for (const std::string sign : {"[", "{a: ", "{", "? ", ": ", "- ? ", "[?", "{? ", "- : "})
    CHECK(error_of(repeat(sign, 10'000)) != "none");
}

TEST_CASE("ten thousand levels by indentation are an error at the first level too deep") {
  std::string text;
  for (int i = 0; i < 3'900; ++i) text += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  CHECK_THAT(error_of(text), Contains("a.yaml:65:65: nested deeper than 64 levels"));
}

TEST_CASE("64 levels are read") {
  CHECK(error_of(repeat("[", 64) + repeat("]", 64)) == "none");
  CHECK(error_of(repeat("- ", 64) + "x") == "none");
}

TEST_CASE("aliases of aliases end at the cap on values") {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 20; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    const std::string name = "a" + std::to_string(i);
    text += name + ": &" + name + " [" + repeat(alias + ", ", 8) + alias + "]\n";
  }
  CHECK_THAT(error_of(text), Contains("more than 1000000 values (aliases expanded)"));
}

TEST_CASE("aliases of one long text end at the cap, too") {
  const std::string text =
      "a: &a " + std::string(1'000'000, 'x') + "\nb: [" + repeat("*a, ", 50'000) + "1]\n";
  CHECK_THAT(error_of(text), Contains("aliases expanded"));
}

TEST_CASE("aliases do not reach deeper than values that are written out") {
  std::string text = "a0: &a0 1\n";
  for (int i = 1; i < 100; ++i)
    text += "b" + std::to_string(i) + ": &a" + std::to_string(i) + " {x: *a" + std::to_string(i - 1) + "}\n";
  CHECK_THAT(error_of(text), Contains("nested deeper than 64 levels"));
}

TEST_CASE("lists in brackets without end are refused before they fill the memory") {
  CHECK_THAT(error_of("v: [" + repeat("1,", 4'000'000) + "1]"), Contains("more than 1000000 values"));
  CHECK_THAT(error_of("[" + repeat("1,", 4'000'000) + "1]"),
             Contains("a.yaml:1:1: ") && Contains("too long"));
  CHECK(error_of("v: [" + repeat("0.1, ", 200'000) + "1]") == "none");
}

TEST_CASE("faults without end are cut off") {
  try {
    parse_document(repeat("a: 1\n", 100'000), "a.yaml");
    FAIL("must be refused");
  } catch (const Error& error) {
    REQUIRE(error.faults().size() == 101);
    CHECK(error.faults().back().text() == "there may be more than these 100 faults");
  }
}

TEST_CASE("a text beyond the limit is refused by its size") {
  DocumentLimits limits;
  limits.bytes = 1 << 20;
  CHECK_THROWS_WITH(parse_document(std::string(3 << 20, ' '), "a.yaml", limits),
                    "a.yaml: the file has 3.0 MB, and at most 1.0 MB are read");
}

TEST_CASE("what is no text is refused at its first such byte") {
  CHECK_THAT(error_of(std::string("a: 1\nb: \0 2\n", 12)), Contains("a.yaml:2:4: a NUL byte"));
  CHECK_THAT(error_of("a: 5 \xb5m"), Contains("a.yaml:1:6: the byte 0xb5 is no UTF-8"));
  CHECK_THAT(error_of("ä: \x07"), Contains("a.yaml:1:4: the control character 0x07"));
  CHECK_THAT(error_of("\xff\xfe"
                      "a"),
             Contains("a.yaml:1:1: the byte 0xff is no UTF-8"));
  for (const std::string bad :
       {"\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82", "\x80"})
    CHECK_THAT(error_of("a: " + bad), Contains("a.yaml:1:4: "));
  CHECK(error_of("a: \xe2\x82\xac \xf0\x9f\x98\x80 \xc2\xb5m") == "none");
}

TEST_CASE("noise is an error or a tree, never an end of the program") {
  std::mt19937 random(1);
  const std::string signs = "ab:,[]{}&*!|>'\"%@`#-? \n\t~<.=1";
  for (int round = 0; round < 3'000; ++round) {
    std::string text;
    for (unsigned i = 0; i < 1 + random() % 60; ++i) text += signs[random() % signs.size()];
    error_of(text);
  }
  for (int round = 0; round < 300; ++round) {
    std::string bytes(1 + random() % 300, ' ');
    for (char& byte : bytes) byte = static_cast<char>(random());
    error_of(bytes);
  }
}

}  // namespace stepwire::yaml
