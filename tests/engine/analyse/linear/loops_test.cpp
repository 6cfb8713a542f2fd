// Margins of drawn loops against loops.csv, which loops.py has written with mpmath and scipy.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

#include "engine/analyse/linear/margins.hpp"

namespace stepwire::linear {

namespace {

std::vector<std::string> cells_of(const std::string& text, char separator) {
  std::vector<std::string> cells;
  std::istringstream in(text);
  for (std::string cell; std::getline(in, cell, separator);) cells.push_back(cell);
  return cells;
}

std::vector<double> row_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : cells_of(text, ' ')) numbers.push_back(std::stod(part));
  return numbers;
}

std::vector<Crossing> crossings_of(const std::string& text) {
  std::vector<Crossing> all;
  for (const std::string& pair : cells_of(text, ';')) all.push_back({row_of(pair).at(0), row_of(pair).at(1)});
  return all;
}

/// Controllable canonical form; a delay follows it.
StateSpace loop_of(std::vector<double> numerator, const std::vector<double>& denominator, double delay,
                   double sample_time) {
  const auto n = static_cast<Eigen::Index>(denominator.size()) - 1;
  numerator.insert(numerator.begin(), denominator.size() - numerator.size(), 0.0);
  const double lead = denominator[0], direct = numerator[0] / lead;
  const Eigen::Index d = delay > 0.0 ? 1 : 0;
  StateSpace system{Eigen::MatrixXd::Zero(n, n),
                    Eigen::MatrixXd::Zero(n, 1 + d),
                    Eigen::MatrixXd::Zero(1 + d, n),
                    Eigen::MatrixXd::Zero(1 + d, 1 + d),
                    {},
                    {{"u", ""}},
                    {{"y", ""}},
                    sample_time};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i) + 1;
    system.A(0, i) = -denominator[k] / lead;
    system.C(d, i) = numerator[k] / lead - direct * denominator[k] / lead;
    if (i > 0) system.A(i, i - 1) = 1.0;
    system.states.push_back({"x" + std::to_string(i), ""});
  }
  if (n > 0) system.B(0, 0) = 1.0;
  system.D(d, 0) = direct;
  if (d > 0) {
    system.D(0, 1) = 1.0;
    system.delays = {{delay, {"d.u", ""}, {"d.y", ""}}};
  }
  return system;
}

/// Checks that each of the known crossings is found, and no other. Crossings beyond `last`, and factors of 50
/// and more, at which a search may end, do not count.
void check_same(std::vector<Crossing> found, std::vector<Crossing> known, double last) {
  for (std::vector<Crossing>* all : {&found, &known})
    std::erase_if(*all, [&](const Crossing& crossing) {
      return !std::isinf(last) && (crossing.frequency > last || crossing.margin > 50.0);
    });
  CHECK(found.size() == known.size());
  for (const Crossing& wanted : known) {
    INFO("at " << wanted.frequency << " " << wanted.margin);
    CHECK(std::ranges::any_of(found, [&](const Crossing& crossing) {
      const bool same_place = crossing.frequency == wanted.frequency ||
                              std::abs(crossing.frequency - wanted.frequency) < 1e-6 * wanted.frequency;
      const double turn = std::remainder(crossing.margin - wanted.margin, 2.0 * M_PI);
      return same_place && std::min(std::abs(turn), std::abs(crossing.margin - wanted.margin)) <
                               1e-5 * std::max(1.0, std::abs(wanted.margin));
    }));
  }
}

}  // namespace

TEST_CASE("margins of drawn loops agree with roots of polynomials and with a dense search") {
  std::ifstream file(STEPWIRE_SOURCE_DIR "/tests/engine/analyse/linear/loops.csv");
  std::string line;
  std::getline(file, line);
  int loops = 0;
  for (; std::getline(file, line); ++loops) {
    INFO(line);
    std::vector<std::string> cells = cells_of(line, ',');
    const double delay = std::stod(cells.at(2)), sample_time = std::stod(cells.at(3));
    const Margins margins = margins_of(loop_of(row_of(cells[0]), row_of(cells[1]), delay, sample_time), -1.0);
    CHECK(margins.stable == (cells.at(8) == "1"));
    CHECK(margins.notes.empty());
    // The search of loops with a delay ends at 400 rad of phase.
    const double last = delay > 0.0 ? 390.0 / delay : std::numeric_limits<double>::infinity();
    check_same(margins.gain, crossings_of(cells.at(4)), last);
    check_same(margins.phase, crossings_of(cells.at(5)), last);
    CHECK(margins.modulus == Approx(std::stod(cells.at(6))).epsilon(1e-7).margin(1e-9));
  }
  CHECK(loops == 67);
}

}  // namespace stepwire::linear
