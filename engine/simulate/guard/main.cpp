// Program of the guard, and of surveys of drivers. The program `stepwire` starts it with open descriptors;
// people do not call it.
#include <cstdio>
#include <cstdlib>

#include "engine/simulate/guard/guard_process.hpp"
#include "engine/simulate/guard/survey.hpp"

int main(int count, char** arguments) {
  if (count == 2) return stepwire::guard::run_survey(std::atoi(arguments[1]));
  if (count == 3) return stepwire::guard::run_guard(std::atoi(arguments[1]), std::atoi(arguments[2]));
  std::fputs("stepwire_guard is started by 'stepwire loop --io'\n", stderr);
  return 2;
}
