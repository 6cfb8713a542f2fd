// The example of a block's page can be taken over: nothing that the block needs is left out of it.
#include <catch2/catch.hpp>

#include "engine/app/reference/example.hpp"
#include "tests/blocks/contract_rig.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A diagram of the example, and of what it names as sources.
std::string diagram_of(const BlockType& type) {
  std::string text = "step: 1 ms\nstop: 2 ms\nsolver: rk4\nblocks:\n";
  for (const char* name : {"source", "first", "second"})
    text += std::string("  ") + name + ": {block: Constant, value: 1}\n";
  for (const InputSpec& input : type.inputs)
    if (!input.list && input.name != "u") text += "  " + input.name + ": {block: Constant, value: 1}\n";
  std::string example = reference::block_example(type);
  for (std::size_t at = example.find('\n'); at != std::string::npos; at = example.find('\n', at + 3))
    example.insert(at + 1, "  ");
  return text + "  " + example + "\nrecord: source\n";
}

}  // namespace

TEST_CASE("no example of a block leaves out an input or a parameter that it needs") {
  for (const BlockType* type : library().types()) {
    INFO(diagram_of(*type));
    const std::string error = error_of(diagram_of(*type));
    CHECK(error.find("is missing") == std::string::npos);
    CHECK(error.find("there is no block") == std::string::npos);
  }
}
