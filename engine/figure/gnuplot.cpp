#include "engine/figure/gnuplot.hpp"

#include "engine/process/filter.hpp"
#include "engine/table/surroundings.hpp"

namespace stepwire {

bool has_gnuplot() {
  return !find_program("gnuplot").empty();
}

GnuplotAnswer run_gnuplot(const std::string& script) {
  const std::string program = find_program("gnuplot");
  if (program.empty())
    throw SurroundingsError("gnuplot is not installed; on Debian it is the package gnuplot-nox");
  FilterAnswer answer = run_filter(program, {"-d", "-"}, script);
  if (answer.status != 0) throw SurroundingsError("gnuplot failed: " + answer.complaints);
  return {std::move(answer.output), std::move(answer.complaints)};
}

}  // namespace stepwire
