#include <catch2/catch.hpp>

#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/library.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::codegen {

TEST_CASE("the loops over a block's elements are part of the step in compiled code") {
  const Compiler compiler;
  if (!compiler.found() || !compiler.is_gcc()) {
    WARN("there is no GCC here; nothing was compiled");
    return;
  }
  const Scratch scratch;
  const std::string w1 = io::read_file(STEPWIRE_SOURCE_DIR "/bench/w1.yaml"), library = scratch.path("w1.so");
  const GeneratedProgram program = make_steps(plan_text(w1), {});
  std::vector<std::string> flags = flags_for_this_machine(program.headers);
  for (const std::string& flag : library_flags()) flags.push_back(flag);
  REQUIRE(compiler.compile(scratch.file("w1.cpp", library_source(program)), library, flags, {}) == "");
  const auto symbols = subprocess::run_process({.command = {"nm", "-C", library}});
  REQUIRE(symbols.output.find("stepwire_advance") != std::string::npos);
  CHECK(symbols.output.find("::each<") == std::string::npos);
}

}  // namespace stepwire::codegen
