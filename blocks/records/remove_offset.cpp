#include <algorithm>
#include <numeric>

#include "blocks/records/steps.hpp"

namespace stepwire {

void remove_offset(Record& record, const StepOptions& given) {
  const std::string what = given.text("remove");
  for (RecordColumn& column : record.columns) {
    std::vector<double>& y = column.values;
    const double offset = what == "mean"
                              ? std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size())
                          : what == "first" ? y.front()
                                            : given.number("remove", column.dimension);
    std::transform(y.begin(), y.end(), y.begin(), [&](double value) { return value - offset; });
  }
}

}  // namespace stepwire
