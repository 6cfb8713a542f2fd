#include "blocks/records/butterworth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/math/elementary.hpp"

namespace stepwire {

namespace {

FilterSection pair_section(double damping, double k) {
  const double scale = 1.0 / (1.0 + 2.0 * damping * k + k * k);
  return {k * k * scale, 2.0 * k * k * scale, k * k * scale, 2.0 * (k * k - 1.0) * scale,
          (1.0 - 2.0 * damping * k + k * k) * scale};
}

FilterSection single_section(double k) {
  return {k / (1.0 + k), k / (1.0 + k), 0.0, (k - 1.0) / (k + 1.0), 0.0};
}

/// Filters the rows by a section (transposed direct form II). The initial state is the steady state of the
/// first row; its static gain is 1.
void run(const FilterSection& s, std::vector<double>& rows) {
  double second = (s.b2 - s.a2) * rows.front(), first = (s.b1 - s.a1) * rows.front() + second;
  for (double& row : rows) {
    const double u = row;
    row = s.b0 * u + first;
    first = s.b1 * u - s.a1 * row + second;
    second = s.b2 * u - s.a2 * row;
  }
}

/// Returns the rows with `count` more at either end, point-reflected about the first and the last one.
std::vector<double> extended(const std::vector<double>& rows, std::size_t count) {
  std::vector<double> result;
  for (std::size_t i = count; i > 0; --i) result.push_back(2.0 * rows.front() - rows[i]);
  result.insert(result.end(), rows.begin(), rows.end());
  for (std::size_t i = 1; i <= count; ++i) result.push_back(2.0 * rows.back() - rows[rows.size() - 1 - i]);
  return result;
}

}  // namespace

std::vector<FilterSection> butterworth(int order, double cutoff) {
  const double k = fn::tan(std::numbers::pi * cutoff);
  std::vector<FilterSection> sections;
  for (int i = 0; i < order / 2; ++i)
    sections.push_back(pair_section(fn::sin(std::numbers::pi * (2 * i + 1) / (2 * order)), k));
  if (order % 2 == 1) sections.push_back(single_section(k));
  return sections;
}

int rows_beyond_ends(int order) {
  return 3 * (order + 1);
}

std::vector<double> forward_and_backward(const std::vector<FilterSection>& sections, int order,
                                         const std::vector<double>& rows) {
  const auto beyond = static_cast<std::size_t>(rows_beyond_ends(order));
  std::vector<double> all = extended(rows, beyond);
  for (int pass = 0; pass < 2; ++pass) {
    for (const FilterSection& section : sections) run(section, all);
    std::reverse(all.begin(), all.end());
  }
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(beyond);
  return {begin, begin + static_cast<std::ptrdiff_t>(rows.size())};
}

}  // namespace stepwire
