#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include "engine/analyse/linear/poles.hpp"

namespace stepwire::linear {

namespace {

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : parts_of(text, ' ')) numbers.push_back(std::stod(part));
  return numbers;
}

Eigen::MatrixXd matrix_of(const std::string& text) {
  const std::vector<std::string> rows = parts_of(text, ';');
  Eigen::MatrixXd matrix;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double> row = numbers_of(rows[i]);
    matrix.conservativeResize(static_cast<Eigen::Index>(i + 1), static_cast<Eigen::Index>(row.size()));
    matrix.bottomRows(1) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), matrix.cols());
  }
  return matrix;
}

struct Known {
  StateSpace system;
  std::vector<Complex> zeros;  ///< by octave-control
};

/// The systems of zeros.csv, which zeros.py has written.
std::vector<Known> known_systems() {
  std::ifstream file(STEPWIRE_SOURCE_DIR "/tests/engine/analyse/linear/zeros.csv");
  std::vector<Known> all;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    const std::vector<std::string> cells = parts_of(line, ',');
    Known known;
    known.system.sample_time = std::stod(cells.at(0));
    known.system.A = matrix_of(cells.at(1));
    known.system.B = matrix_of(cells.at(2));
    known.system.C = matrix_of(cells.at(3));
    known.system.D = matrix_of(cells.at(4));
    if (cells.size() > 5)
      for (const std::string& zero : parts_of(cells[5], ';'))
        known.zeros.emplace_back(numbers_of(zero).at(0), numbers_of(zero).at(1));
    all.push_back(known);
  }
  return all;
}

/// Each zero has a partner of its own.
void check_same(std::vector<Complex> found, const std::vector<Complex>& expected, double tolerance) {
  REQUIRE(found.size() == expected.size());
  for (const Complex& zero : expected) {
    const auto nearest =
        std::ranges::min_element(found, {}, [&](const Complex& one) { return std::abs(one - zero); });
    CHECK(std::abs(*nearest - zero) <= tolerance * (1e-6 + std::abs(zero)));
    found.erase(nearest);
  }
}

/// Powers of ten from 1e-4 to 1e4.
Eigen::VectorXd drawn_units(std::mt19937& generator, Eigen::Index count) {
  Eigen::VectorXd units(count);
  for (double& unit : units) unit = std::pow(10.0, static_cast<int>(generator() % 9) - 4);
  return units;
}

/// The same system in other units of states, inputs, outputs and, by `rate`, of time.
StateSpace in_other_units(const StateSpace& in, double rate, std::mt19937& generator) {
  const Eigen::VectorXd x = drawn_units(generator, in.A.rows()), u = drawn_units(generator, in.B.cols()),
                        y = drawn_units(generator, in.C.rows()), back = x.cwiseInverse();
  StateSpace out = in;
  out.A = rate * (x.asDiagonal() * in.A * back.asDiagonal());
  out.B = rate * (x.asDiagonal() * in.B * u.asDiagonal());
  out.C = y.asDiagonal() * in.C * back.asDiagonal();
  out.D = y.asDiagonal() * in.D * u.asDiagonal();
  return out;
}

/// One state: D + C B / (s - A).
StateSpace first_order(double A, double B, double C, double D) {
  const auto number = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
  StateSpace system;
  system.A = number(A);
  system.B = number(B);
  system.C = number(C);
  system.D = number(D);
  return system;
}

}  // namespace

TEST_CASE("the zeros of 200 systems, of one and several channels, are those of octave-control and scipy") {
  const std::vector<Known> all = known_systems();
  REQUIRE(all.size() == 200);
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO("line " << i + 2 << " of zeros.csv");
    check_same(zeros_of(all[i].system), all[i].zeros, 5e-8);
  }
}

TEST_CASE("the zeros of a system do not depend on the units of its states, inputs and outputs") {
  std::mt19937 generator(3);
  const std::vector<Known> all = known_systems();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double rate = drawn_units(generator, 1)[0];
    std::vector<Complex> zeros = zeros_of(in_other_units(all[i].system, rate, generator));
    for (Complex& zero : zeros) zero /= rate;
    INFO("line " << i + 2 << " of zeros.csv");
    check_same(zeros, all[i].zeros, 5e-8);
  }
}

TEST_CASE("a zero of one state beside a direct path is where both cancel") {
  const auto zero_of = [](double A, double B, double C, double D) {
    const auto zeros = zeros_of(first_order(A, B, C, D));
    REQUIRE(zeros.size() == 1);
    return zeros[0].real();
  };
  CHECK(zero_of(-10, -9, 1, 1) == Approx(-1.0).epsilon(1e-14));  // (s + 1) / (s + 10)
  CHECK(zero_of(0, 1e6, 1, 2) == Approx(-5e5).epsilon(1e-14));   // a controller of 2 + 1e6 / s
  CHECK(zero_of(0, 1e-9, 1, 2) == Approx(-5e-10).epsilon(1e-14));
  CHECK(zero_of(-1e4, -1e4, 1e3, 1e3) == Approx(0.0).margin(1e-9));  // s / (s + 1e4)
  CHECK(zeros_of(first_order(-3, 1, 1, 0)).empty());
}

}  // namespace stepwire::linear
