#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks/records/band_limited.hpp"
#include "blocks/records/steps.hpp"

namespace stepwire {

namespace {

constexpr double max_rows = 1e8;

std::vector<double> straight(const std::vector<double>& time, const std::vector<double>& y,
                             const std::vector<double>& at) {
  std::vector<double> result;
  std::size_t row = 0;
  for (const double t : at) {
    while (row + 2 < time.size() && time[row + 1] <= t) ++row;
    const double length = time[row + 1] - time[row];  // 0 at a jump in the last row
    const double share = length > 0.0 ? std::min((t - time[row]) / length, 1.0) : 1.0;
    result.push_back(y[row] + share * (y[row + 1] - y[row]));
  }
  return result;
}

/// Resamples as a periodic signal without a jump or a kink, for any record. The line through its ends is
/// subtracted, and the rest is extended by point reflection until the period closes. Afterwards the line is
/// added.
std::vector<double> band_limited(const std::vector<double>& time, const std::vector<double>& y,
                                 const std::vector<double>& at) {
  const std::size_t last = y.size() - 1;
  const double length = time.back() - time.front();
  const auto line = [&](double t) {
    return y.front() + (y.back() - y.front()) * (t - time.front()) / length;
  };
  std::vector<double> period(2 * last);
  for (std::size_t i = 1; i < last; ++i) {
    const double even = time.front() + length * static_cast<double>(i) / static_cast<double>(last);
    period[i] = y[i] - line(even);
    period[2 * last - i] = -period[i];
  }
  const BandLimited signal = BandLimited::through(Matrix(1, static_cast<Index>(2 * last), Numbers(period)));
  std::vector<double> result;
  for (const double t : at) result.push_back(line(t) + signal(0, (t - time.front()) / (2.0 * length)));
  return result;
}

}  // namespace

void resample(Record& record, const StepOptions& given) {
  const double interval = given.positive("resample", time_dimension);
  const bool straight_lines = !given.has("method") || given.word("method", {"linear", "band_limited"}) == 0;
  const double length = record.time.back() - record.time.front();
  const double intervals = std::floor(length / interval * (1.0 + 1e-12) + 1e-9);
  if (!(intervals >= 1.0 && intervals < max_rows))
    given.refuse("resample",
                 fmt::format("{} is {} rows of {}, which lasts {} s; it must be 2 to {}",
                             given.text("resample"), intervals + 1.0, record.file, length, max_rows));
  if (!straight_lines) given.require_even(record);
  std::vector<double> at;
  for (std::size_t row = 0; row <= static_cast<std::size_t>(intervals); ++row)
    at.push_back(record.time.front() + interval * static_cast<double>(row));
  for (RecordColumn& column : record.columns)
    column.values = (straight_lines ? straight : band_limited)(record.time, column.values, at);
  record.time = at;
}

}  // namespace stepwire
