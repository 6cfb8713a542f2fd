#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::codegen {

TEST_CASE("precompiled headers are taken by a compilation with the same flags, and by no other", "[full]") {
  const Compiler compiler;
  if (!compiler.found() || compiler.version().find("clang") != std::string::npos) {
    WARN("there is no g++ here; nothing was compared");
    return;
  }
  const Scratch scratch;
  REQUIRE(compiler.precompile(scratch.path("headers"), {Compiler::native}) == "");
  const std::string source = scratch.file("empty.cpp", "int main() {}\n");
  const auto takes = [&](const std::string& flag) {
    std::vector<std::string> command{"g++"};
    for (const std::string& one : Compiler::flags()) command.push_back(one);
    for (const char* one : Compiler::gcc_flags) command.push_back(one);
    command.insert(command.end(), {flag, "-fPIC", "-H", "-fsyntax-only", "-include",
                                   scratch.path("headers/standard.hpp"), source});
    // GCC's manual: -H marks a precompiled header that is used with "!".
    return subprocess::run_process({.command = command}).errors.find("! ") != std::string::npos;
  };
  CHECK(takes(Compiler::native));
  CHECK_FALSE(takes("-fno-exceptions"));
}

TEST_CASE("what a compiler says of flags that it does not know is told") {
  const Compiler compiler;
  if (!compiler.found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const Scratch scratch;
  CHECK(compiler.precompile(scratch.path("headers"), {"-fno-such-flag"}).find("no-such-flag") !=
        std::string::npos);
}

}  // namespace stepwire::codegen
