#include "engine/analyse/query/run_rows.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::query {

RunRows rows_of_run(const std::optional<Formula>& where, const record::Recording& recording) {
  RunRows rows{0, recording.table.rows(), 0};
  if (where) {
    const std::vector<double> holds = evaluate(*where, recording);
    const auto first =
        std::ranges::find_if(holds, [](double value) { return value != 0.0 && !std::isnan(value); });
    rows.first = static_cast<std::size_t>(first - holds.begin());
  }
  for (const std::size_t start : recording.starts) {
    if (start <= rows.first) rows.begin = start;
    if (start > rows.first) rows.end = std::min(rows.end, start);
  }
  return rows;
}

}  // namespace stepwire::query
