// Build tool that precompiles the standard headers for generated code into the given folder. Without them
// code compiles too, but more slowly.

#include <fmt/core.h>

#include "engine/simulate/codegen/compiler.hpp"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const stepwire::codegen::Compiler compiler;
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{stepwire::codegen::Compiler::native}, {}})
    if (const std::string problem = compiler.precompile(arguments[1], more); !problem.empty())
      fmt::print(stderr, "headers for generated code are not precompiled: {}\n", problem);
}
