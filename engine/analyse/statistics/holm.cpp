#include "engine/analyse/statistics/holm.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::statistics {

std::vector<double> holm_corrected(const std::vector<double>& probabilities) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    if (!std::isnan(probabilities[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return probabilities[a] < probabilities[b]; });
  std::vector<double> corrected = probabilities;
  double before = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double raised = static_cast<double>(order.size() - i) * probabilities[order[i]];
    corrected[order[i]] = before = std::min(1.0, std::max(before, raised));
  }
  return corrected;
}

}  // namespace stepwire::statistics
