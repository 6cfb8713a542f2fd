#include "blocks/register.hpp"
#include "engine/app/cli/command_line.hpp"
#include "engine/app/cli/interrupt.hpp"

/// Precedes the constructors of all static objects, which take milliseconds.
__attribute__((constructor(101))) static void begin() {
  stepwire::cli::end_at_signals();
}

int main(int argc, char** argv) {
  return stepwire::cli::run_command_line(argc, argv, stepwire::blocks);
}
