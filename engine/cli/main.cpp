#include "blocks/register.hpp"
#include "engine/cli/command_line.hpp"

int main(int argc, char** argv) {
  const stepwire::Registry registry = stepwire::all_blocks();
  return stepwire::run_command_line(argc, argv, registry);
}
