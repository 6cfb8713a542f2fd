#include "engine/figure/plot_kind.hpp"

namespace stepwire {

const std::vector<PlotKind>& plot_kinds() {
  static const std::vector<PlotKind> kinds{lines_plot(), xy_plot(),        loop_plot(),    path_plot(),
                                           strip_plot(), map_plot(),       field_plot(),   space_plot(),
                                           box_plot(),   histogram_plot(), diagram_plot(), rig_plot()};
  return kinds;
}

}  // namespace stepwire
