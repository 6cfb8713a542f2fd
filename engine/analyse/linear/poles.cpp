#include "engine/analyse/linear/poles.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/linear/balance.hpp"
#include "engine/analyse/linear/delay_system.hpp"

namespace stepwire::linear {

namespace {

/// Returns the groups of states that depend on each other in both directions, directly or through others.
std::vector<std::vector<Eigen::Index>> groups_of(const Eigen::MatrixXd& A) {
  const Eigen::Index n = A.rows();
  Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> reaches = (A.array() != 0.0).matrix();
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index i = 0; i < n; ++i)
      if (reaches(i, k)) reaches.row(i) = reaches.row(i).array() || reaches.row(k).array();
  std::vector<char> done(static_cast<std::size_t>(n), 0);
  std::vector<std::vector<Eigen::Index>> groups;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (done[static_cast<std::size_t>(i)]) continue;
    groups.push_back({i});
    for (Eigen::Index j = i + 1; j < n; ++j)
      if (reaches(i, j) && reaches(j, i)) groups.back().push_back(j), done[static_cast<std::size_t>(j)] = 1;
  }
  return groups;
}

Eigen::MatrixXd balanced(const Eigen::MatrixXd& A) {
  const Eigen::VectorXd scale = balancing(A);
  return scale.cwiseInverse().asDiagonal() * A * scale.asDiagonal();
}

}  // namespace

void sort_by_size(std::vector<Complex>& values) {
  std::ranges::sort(values, [](const Complex& a, const Complex& b) {
    const double size_a = std::abs(a), size_b = std::abs(b);
    if (std::abs(size_a - size_b) > 1e-12 * std::max(size_a, size_b)) return size_a < size_b;
    return a.real() != b.real() ? a.real() < b.real() : a.imag() > b.imag();
  });
}

std::vector<Complex> eigenvalues(const Eigen::MatrixXd& A) {
  std::vector<Complex> values;
  for (const auto& group : groups_of(A)) {
    if (group.size() == 1) {
      values.emplace_back(A(group[0], group[0]));
      continue;
    }
    const Eigen::MatrixXd block = A(group, group);
    const Eigen::VectorXcd found = balanced(block).eigenvalues();
    values.insert(values.end(), found.begin(), found.end());
  }
  sort_by_size(values);
  return values;
}

std::vector<Complex> poles_of(const StateSpace& system) {
  return system.delays.empty() ? eigenvalues(system.A) : delay_poles(system);
}

std::vector<Mode> modes_of(const StateSpace& system) {
  std::vector<Mode> modes;
  for (const Complex& pole : poles_of(system)) {
    const Complex s = system.is_sampled() ? std::log(pole) / system.sample_time : pole;
    const double frequency = std::abs(s);
    if (!std::isfinite(frequency))  // z = 0: decays within a sample
      modes.push_back({pole, std::numeric_limits<double>::infinity(), 1.0});
    else
      modes.push_back({pole, frequency, frequency > 0.0 ? -s.real() / frequency : 0.0});
  }
  return modes;
}

bool is_stable(const StateSpace& system) {
  if (!system.A.allFinite()) return false;
  if (!system.delays.empty()) return count_unstable(system) == 0;
  const std::vector<Complex> poles = eigenvalues(system.A);
  double largest = 0.0;
  for (const Complex& pole : poles) largest = std::max(largest, std::abs(pole));
  return std::ranges::all_of(poles, [&](const Complex& pole) {
    if (!std::isfinite(std::abs(pole))) return false;
    return system.is_sampled() ? std::abs(pole) < 1.0 - 1e-12 : pole.real() < -1e-12 * largest;
  });
}

}  // namespace stepwire::linear
