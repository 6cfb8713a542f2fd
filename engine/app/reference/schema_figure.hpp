#pragma once

#include "engine/base/json/json.hpp"

namespace stepwire {

/// Adds the definitions that figures use: series, plot, panel, panels, figure and one for each kind of plot.
void add_figure_definitions(Json& definitions);

}  // namespace stepwire
