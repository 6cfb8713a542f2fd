#include "engine/analyse/linear/loop_gain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/analyse/linear/gain_at_rest.hpp"

namespace stepwire::linear {
namespace {

constexpr double rounding_of_gain = 1e-8;  // also the error of derivatives by differences

double log_gain(const Complex& value) {
  return std::log(std::abs(value));
}
/// Returns the sine of the angle to the real axis.
double bend_from_real(const Complex& value) {
  return value.imag() / std::abs(value);
}
bool has_gain_one(const Complex& value) {
  return std::abs(log_gain(value)) < rounding_of_gain;
}
bool is_negative_real(const Complex& value) {
  return value.real() < 0.0 && std::abs(value.imag()) <= 1e-9 * std::abs(value.real());
}

/// Returns a lower bound of the least size near the second of three points, by straight lines through it from
/// either neighbour to the other side.
double least_near(const std::array<CurvePoint, 3>& points) {
  const auto [before, here, after] = points;
  const double left = here.x - before.x, right = after.x - here.x;
  if (!(left > 0.0 && right > 0.0)) return -1.0;
  return here.y - std::max((before.y - here.y) / left * right, (after.y - here.y) / right * left);
}

bool within(const std::vector<FrequencyBand>& bands, double low, double high) {
  return std::ranges::any_of(bands,
                             [&](const FrequencyBand& band) { return low >= band.from && high <= band.to; });
}

}  // namespace

LoopGain::LoopGain(const StateSpace& system, double sign, const std::vector<Mode>& closed)
    : response_(system), sign_(sign), at_rest_(sign * gain_at_rest(system)) {
  for (const double w : response_.search_frequencies(closed)) rows_.push_back({w, at(w)});
  std::erase_if(rows_, [](const Row& row) { return !std::isfinite(std::abs(row.value)); });
  add_touches(log_gain);
  add_touches([](const Complex& value) {
    return value.real() < 0.0 ? bend_from_real(value) : std::copysign(1.0, value.imag());
  });
}

/// Adds a row at the least |size| between two rows if its sign may change twice there.
template <class Size>
void LoopGain::add_touches(Size size) {
  constexpr double noise = 1e-9;
  std::vector<Row> found;
  for (std::size_t k = 1; k + 1 < rows_.size(); ++k) {
    const double before = size(rows_[k - 1].value), here = size(rows_[k].value),
                 after = size(rows_[k + 1].value);
    if ((before < 0.0) != (here < 0.0) || (after < 0.0) != (here < 0.0)) continue;
    const double a = std::abs(before), b = std::abs(here), c = std::abs(after);
    if (b < noise || !(b <= a && b <= c)) continue;
    if (least_near({{{rows_[k - 1].frequency, a}, {rows_[k].frequency, b}, {rows_[k + 1].frequency, c}}}) >
        0.0)
      continue;
    const double side = here < 0.0 ? -1.0 : 1.0;
    const double w = find_minimum([&](double f) { return side * size(at(f)); }, rows_[k - 1].frequency,
                                  rows_[k + 1].frequency)
                         .x;
    found.push_back({w, at(w)});
  }
  rows_.insert(rows_.end(), found.begin(), found.end());
  std::ranges::sort(rows_, {}, &Row::frequency);
}

/// Returns the bands of at least 2 %, and of 3 rows, in which all rows have a property.
std::vector<FrequencyBand> LoopGain::bands(bool (*belongs)(const Complex& value)) const {
  constexpr std::size_t fewest = 3;
  std::vector<FrequencyBand> found;
  for (std::size_t first = 0; first < rows_.size();) {
    std::size_t end = first;
    while (end < rows_.size() && belongs(rows_[end].value)) ++end;
    if (end - first >= fewest && rows_[end - 1].frequency > 1.02 * rows_[first].frequency)
      found.push_back({rows_[first].frequency, rows_[end - 1].frequency});
    first = std::max(end, first + 1);
  }
  return found;
}

std::optional<FrequencyBand> LoopGain::band_of_one() const {
  const auto found = bands(has_gain_one);
  const auto widest =
      std::ranges::max_element(found, {}, [](const FrequencyBand& band) { return band.to / band.from; });
  return widest == found.end() ? std::nullopt : std::optional(*widest);
}

std::vector<Crossover> LoopGain::crossovers() const {
  const auto flat = bands(has_gain_one);
  std::vector<Crossover> found;
  for (std::size_t k = 0; k + 1 < rows_.size(); ++k) {
    const Row &row = rows_[k], &next = rows_[k + 1];
    const bool above = std::abs(row.value) >= 1.0;
    if (above == (std::abs(next.value) >= 1.0) || within(flat, row.frequency, next.frequency)) continue;
    found.push_back(
        {find_zero([&](double f) { return log_gain(at(f)); }, row.frequency, next.frequency), above});
  }
  return found;
}

/// True far from all corners if the loop is so nearly real that its imaginary part is rounding error.
bool LoopGain::is_rounding(const Row& row) const {
  const auto [first, last] = response_.range();
  return (row.frequency < first || row.frequency > last) &&
         std::abs(row.value.imag()) <= 1e-7 * std::abs(row.value.real());
}

/// True where a chain of delays may turn by more than 0.5 rad from a row to the next one.
bool LoopGain::turns_unseen(std::size_t row) const {
  return (rows_[row + 1].frequency - rows_[row].frequency) * response_.delay_of_chain() > 0.5;
}

/// Returns the angle of L at a frequency beyond a row, followed through the turns of the delays between.
double LoopGain::angle_after(const Row& row, double frequency) const {
  const double turned = (frequency - row.frequency) * response_.delay_of_chain();
  const Complex rest = at(frequency) / row.value * std::polar(1.0, turned);
  return std::arg(row.value) + std::arg(rest) - turned;
}

/// Returns how often L is real and negative between a row and the next one.
double LoopGain::half_turns(std::size_t row) const {
  constexpr double pi = std::numbers::pi;
  const double to = angle_after(rows_[row], rows_[row + 1].frequency);
  if (to > pi) return 1.0;
  return to < -pi ? std::floor((-pi - to) / (2.0 * pi)) + 1.0 : 0.0;
}

/// Returns the row of the `index`-th time, from 0.
LoopGain::Row LoopGain::half_turn(std::size_t row, double index) const {
  constexpr double pi = std::numbers::pi;
  const Row &first = rows_[row], &next = rows_[row + 1];
  const double angle = angle_after(first, next.frequency) > pi ? pi : -pi - 2.0 * pi * index;
  const double w =
      find_zero([&](double f) { return angle - angle_after(first, f); }, first.frequency, next.frequency);
  return {w, at(w)};
}

/// Adds the rows in intervals that the grid does not resolve, up to the last one that it does.
void LoopGain::add_half_turns(Negative& found) const {
  constexpr double most = 1000.0;
  std::size_t end = rows_.size() - 1;
  while (end > 0 && turns_unseen(end - 1)) --end;
  if (end + 1 == rows_.size()) return;
  found.last = rows_[end].frequency;
  double all = 0.0;
  for (std::size_t k = 0; k < end; ++k)
    if (turns_unseen(k)) all += half_turns(k);
  if (all > most) found.left_out = static_cast<std::size_t>(std::min(all, 1e18));
  for (std::size_t k = 0; k < end && all <= most; ++k)
    for (double i = 0.0; turns_unseen(k) && i < half_turns(k); i += 1.0)
      found.rows.push_back(half_turn(k, i));
}

LoopGain::Negative LoopGain::negative() const {
  const auto real = bands(is_negative_real);
  Negative found;
  for (const FrequencyBand& band : real) {
    const Row* nearest = nullptr;
    for (const Row& row : rows_)
      if (row.frequency >= band.from && row.frequency <= band.to)
        if (nearest == nullptr || std::abs(log_gain(row.value)) < std::abs(log_gain(nearest->value)))
          nearest = &row;
    found.rows.push_back(*nearest);
  }
  add_half_turns(found);
  for (std::size_t k = 0; k + 1 < rows_.size(); ++k) {
    const Row &row = rows_[k], &next = rows_[k + 1];
    if ((row.value.imag() < 0.0) == (next.value.imag() < 0.0) || turns_unseen(k)) continue;
    if (within(real, row.frequency, next.frequency) || is_rounding(row) || is_rounding(next)) continue;
    const double w = find_zero([&](double f) { return at(f).imag(); }, row.frequency, next.frequency);
    found.rows.push_back({w, at(w)});
  }
  std::ranges::sort(found.rows, {}, &Row::frequency);
  return found;
}

LoopGain::Row LoopGain::nearest_to_minus_one() const {
  const auto distance = [](const Row& row) { return std::abs(1.0 + row.value); };
  Row best = *std::ranges::min_element(rows_, {}, distance);
  for (std::size_t k = 1; k + 1 < rows_.size(); ++k) {
    const double a = distance(rows_[k - 1]), b = distance(rows_[k]), c = distance(rows_[k + 1]);
    if (b > a || b > c) continue;
    if (least_near({{{rows_[k - 1].frequency, a}, {rows_[k].frequency, b}, {rows_[k + 1].frequency, c}}}) >
        distance(best))
      continue;
    const double w = find_minimum([&](double f) { return std::abs(1.0 + at(f)); }, rows_[k - 1].frequency,
                                  rows_[k + 1].frequency)
                         .x;
    if (const Row row{w, at(w)}; distance(row) < distance(best)) best = row;
  }
  return best;
}

}  // namespace stepwire::linear
