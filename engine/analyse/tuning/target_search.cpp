#include "engine/analyse/tuning/target_search.hpp"

#include <algorithm>

#include "engine/analyse/estimation/bounded_squares.hpp"

namespace stepwire::tuning {

namespace {

constexpr double step = 0.1;  // share of the way between the bounds, on each side

}  // namespace

std::optional<std::vector<std::vector<double>>> target_jacobian(const LookAt& look,
                                                                const TuneRequest& request, const Shares& at,
                                                                std::size_t& without) {
  std::vector<std::vector<double>> rows(request.targets.size());
  for (without = 0; without < at.size(); ++without) {
    Shares low = at, high = at;
    low[without] = std::max(0.0, at[without] - step);
    high[without] = std::min(1.0, at[without] + step);
    const Evaluation below = look(low), above = look(high);  // copies: look() may move the first one
    if (below.is_bad() || above.is_bad()) return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i].push_back((above.offs[i] - below.offs[i]) / (high[without] - low[without]));
  }
  return rows;
}

bool search_targets(const LookAt& look, const TuneRequest& request, const Shares& from) {
  estimation::BoundedSquares squares{
      .residuals = request.targets.size(), .iterations = request.evaluations, .tolerance = request.tolerance};
  squares.evaluate = [&](const Shares& at, double* residuals, double* jacobian) {
    const Evaluation& one = look(at);
    if (one.is_bad()) return false;
    std::ranges::copy(one.offs, residuals);
    if (!jacobian) return true;
    std::size_t without = 0;
    const auto rows = target_jacobian(look, request, at, without);
    if (!rows) return false;
    for (const std::vector<double>& row : *rows) jacobian = std::ranges::copy(row, jacobian).out;
    return true;
  };
  return estimation::minimise_squares(squares, from);
}

}  // namespace stepwire::tuning
