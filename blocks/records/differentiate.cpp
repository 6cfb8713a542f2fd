#include "blocks/records/steps.hpp"

namespace stepwire {

namespace {

std::vector<double> slopes(const std::vector<double>& y, double h) {
  const std::size_t last = y.size() - 1;
  std::vector<double> result(y.size());
  for (std::size_t i = 1; i < last; ++i) result[i] = (y[i + 1] - y[i - 1]) / (2.0 * h);
  result[0] = (-3.0 * y[0] + 4.0 * y[1] - y[2]) / (2.0 * h);
  result[last] = (3.0 * y[last] - 4.0 * y[last - 1] + y[last - 2]) / (2.0 * h);
  return result;
}

std::vector<double> bends(const std::vector<double>& y, double h) {
  const std::size_t last = y.size() - 1;
  std::vector<double> result(y.size());
  for (std::size_t i = 1; i < last; ++i) result[i] = (y[i + 1] - 2.0 * y[i] + y[i - 1]) / (h * h);
  result[0] = (2.0 * y[0] - 5.0 * y[1] + 4.0 * y[2] - y[3]) / (h * h);
  result[last] = (2.0 * y[last] - 5.0 * y[last - 1] + 4.0 * y[last - 2] - y[last - 3]) / (h * h);
  return result;
}

}  // namespace

void differentiate(Record& record, const StepOptions& given) {
  const Index times = given.whole("differentiate", 1, 2);
  given.require_rows(record, times + 2, "a derivative of second order at the ends");
  given.require_even(record);
  for (RecordColumn& column : record.columns) {
    column.values = (times == 1 ? slopes : bends)(column.values, record.interval());
    if (column.dimension)
      column.dimension = *column.dimension / unit::power(time_dimension, static_cast<double>(times));
  }
}

}  // namespace stepwire
