#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// Returns a sentence for each panel, motion and rose whose `where` selects no row. The sentence lists the
/// available values: "figure 2, 'Decay': 'k == 9' selects none of 303 rows (3 runs), in which k is 1, 2 or
/// 4".
std::vector<std::string> empty_selections(const std::vector<Figure>& figures,
                                          std::span<const record::Recording> recordings);

}  // namespace stepwire::plot
