#include "blocks/register.hpp"
#include "engine/app/cli/command_line.hpp"

int main(int argc, char** argv) {
  return stepwire::cli::run_command_line(argc, argv, stepwire::blocks);
}
