#include "engine/view/plot/plot_kind.hpp"

#include <algorithm>

namespace stepwire::plot {

const std::vector<PlotKind>& plot_kinds() {
  static const std::vector<PlotKind> kinds{
      lines_plot(),       xy_plot(),      loop_plot(),       path_plot(),         strip_plot(),   map_plot(),
      field_plot(),       space_plot(),   box_plot(),        histogram_plot(),    tornado_plot(), band_plot(),
      sensitivity_plot(), diagram_plot(), rig_plot(),        scene_plot(),        table_plot(),   bode_plot(),
      nyquist_plot(),     poles_plot(),   root_locus_plot(), step_response_plot()};
  return kinds;
}

const Channel* PlotKind::channel(std::string_view key) const {
  const auto found = std::ranges::find(channels, key, &Channel::key);
  return found == channels.end() ? nullptr : &*found;
}

bool PlotKind::takes(KeyNeeds needs) const {
  if (needs == KeyNeeds::plane) return plane;
  if (needs == KeyNeeds::both) return plane && channel("x") && channel("y");
  if (needs == KeyNeeds::depth) return channel("z") != nullptr;
  if (needs == KeyNeeds::outlines) return plane || channel("z");
  return std::ranges::find(lacks, needs) == lacks.end();
}

}  // namespace stepwire::plot
