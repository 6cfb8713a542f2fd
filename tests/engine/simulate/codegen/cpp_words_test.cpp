#include "engine/simulate/codegen/names.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "tests/engine/app/cli/hostile.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::codegen {

TEST_CASE("Whatever a text holds, its comment is one line that ends nothing and goes on nowhere") {
  for (const std::string& text : hostile_texts()) {
    const std::string comment = cpp_comment(text);
    INFO(comment);
    CHECK(comment.find_first_of("\n\r") == std::string::npos);
    CHECK(comment.find("*/") == std::string::npos);
    CHECK(comment.find("?\?/") == std::string::npos);
    CHECK((comment.empty() || comment.back() != '\\'));
  }
}

TEST_CASE("An identifier has letters, digits and underscores and begins with no digit") {
  for (const std::string name : {"", "1abc", "a b", "a.b", "größe", "int", "\n", "a-b"}) {
    const std::string identifier = cpp_identifier(name);
    INFO(identifier);
    REQUIRE_FALSE(identifier.empty());
    CHECK(identifier.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
          std::string::npos);
    CHECK(std::string("0123456789").find(identifier.front()) == std::string::npos);
  }
  CHECK(cpp_identifier("rig.carriage") == "rig_carriage");
}

TEST_CASE("A compiler takes comments for comments and reads string literals back to the same bytes") {
  if (!Compiler().found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const Scratch folder;
  std::string source = "#include <cstdio>\n#include <cstdlib>\nint main() {\n", wanted;
  for (const std::string& text : hostile_texts()) {
    source += "  // " + cpp_comment(text) + "\n";
    source += "  /* " + cpp_comment(text) + " */\n";
    source += "  { const char text[] = " + cpp_string(text) +
              "; std::fwrite(text, 1, sizeof text - 1, stdout); }\n";
    wanted += text;
  }
  source += "}\n";
  std::ofstream(folder.path("words.cpp"), std::ios::binary) << source;
  for (const std::string flag : {"-std=c++20", "-trigraphs"}) {
    const subprocess::ProcessResult built =
        subprocess::run_process({.command = {"c++", "-Wall", "-Wextra", "-Werror", "-Wno-trigraphs", flag,
                                             "-o", folder.path("words"), folder.path("words.cpp")}});
    INFO(built.errors);
    REQUIRE(built.succeeded());
    CHECK(subprocess::run_process({.command = {folder.path("words")}}).output == wanted);
  }
}

}  // namespace stepwire::codegen
