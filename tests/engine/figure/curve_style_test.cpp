#include "engine/figure/plot_kind.hpp"
#include "engine/figure/script.hpp"
#include "tests/engine/figure/samples.hpp"

using namespace stepwire;
using namespace stepwire::testing;
using Catch::Contains;

namespace {

/// What gnuplot is told for a panel over one period of x = sin(2 pi t) mm.
std::string drawn(const std::string& yaml) {
  const Panel panel = panel_of(yaml);
  const std::vector<Recording> recordings{sample_recording({0.0}, 40)};
  Script script(panel, "p");
  panel.kind->draw(panel, recordings, script);
  return script.text();
}

}  // namespace

TEST_CASE(
    "curves are dotted, solid and dashed in the order of the legend, and those without a style as before") {
  const std::string text =
      drawn("{plot: lines, x: time, y: [rig.x, rig.x/2, rig.x/3, rig.x/4], style: [dots, line, dashes]}");
  const auto dots = text.find("dt (0.5,3.5)"), line = text.find("with lines lw 1.6 lc"),
             dashes = text.find("dt (8,5)");
  CHECK(dots < line);
  CHECK(line < dashes);
  CHECK(dashes < text.rfind("with lines lw 1.6 lc"));
  CHECK_THAT(drawn("{plot: lines, x: time, y: rig.x}"), !Contains("dt ("));
}

TEST_CASE("another style is refused with those that there are") {
  CHECK_THAT(figures_of("{plot: xy, x: rig.x, y: rig.x, style: [wavy]}").faults,
             Contains("figure.style: 'wavy' is not allowed; it is one of line, dashes, dots"));
}

TEST_CASE("each y of a plane has its own x where there are as many, else all have the one") {
  const std::string text =
      drawn("{plot: xy, x: [rig.x in mm, 2*rig.x in mm], y: [rig.v in mm/s, rig.v in mm/s]}");
  const auto widest = [&](const std::string& block) {
    double most = 0.0;
    std::istringstream rows(text.substr(text.find(block + " << EOD\n") + block.size() + 8));
    for (std::string row; std::getline(rows, row) && row != "EOD";) most = std::max(most, std::stod(row));
    return most;
  };
  CHECK(widest("$p0") == Approx(1.0).epsilon(0.01));
  CHECK(widest("$p1") == Approx(2.0).epsilon(0.01));
  CHECK_THAT(figures_of("{plot: xy, x: [rig.x, rig.x], y: [rig.v, rig.v, rig.v]}").faults,
             Contains("figure.x: there are 2 in 'x' and 3 in 'y'; x is one, or one for each y"));
  CHECK_THAT(figures_of("{plot: xy, x: [rig.x, rig.v], y: [rig.v, rig.v]}").faults,
             Contains("figure.x: ") && Contains("one axis has one unit"));
}
