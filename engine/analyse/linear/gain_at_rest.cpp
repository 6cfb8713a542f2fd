#include "engine/analyse/linear/gain_at_rest.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/analyse/linear/poles.hpp"

namespace stepwire::linear {

namespace {

constexpr double undecided = std::numeric_limits<double>::quiet_NaN();

using Sparse = Eigen::SparseMatrix<Complex>;

/// Response as C T(s)^-1 B + D. The unknowns of T are the states and the outputs of the delays.
class Resolvent {
 public:
  explicit Resolvent(const StateSpace& system)
      : system_(system), n_(system.A.rows()), d_(std::ssize(system.delays)) {
    for (Eigen::Index i = 0; i < n_; ++i)
      for (Eigen::Index j = 0; j < n_; ++j) put(i, j, system.A(i, j));
    for (Eigen::Index k = 0; k < d_; ++k) {
      for (Eigen::Index i = 0; i < n_; ++i) put(i, n_ + k, system.B(i, k + 1));
      for (Eigen::Index j = 0; j < n_; ++j) put(n_ + k, j, system.C(k + 1, j));
      for (Eigen::Index j = 0; j < d_; ++j) put(n_ + k, n_ + j, system.D(k + 1, j + 1));
    }
    into_.resize(n_ + d_);
    into_ << system.B.col(0), system.D.col(0).tail(d_);
    out_of_.resize(n_ + d_);
    out_of_ << system.C.row(0).transpose(), system.D.row(0).tail(d_).transpose();
  }

  Eigen::Index size() const { return n_ + d_; }
  const Eigen::VectorXd& into() const { return into_; }      ///< B.
  const Eigen::VectorXd& out_of() const { return out_of_; }  ///< C.
  double direct() const { return system_.D(0, 0); }

  /// True where rounding of T may move a pole to the point, or away from it.
  bool is_near_pole(const Complex& point) const {
    constexpr double most = 1e10;
    const Sparse T = matrix(point);
    Eigen::SparseLU<Sparse> solver(T);
    if (solver.info() != Eigen::Success) return true;
    Eigen::VectorXcd uneven(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      uneven[i] = (i % 2 == 0 ? 1.0 : -1.0) * (1.0 + static_cast<double>(i) / static_cast<double>(size()));
    const double inverse = solver.solve(uneven).cwiseAbs().maxCoeff();
    return !(inverse * T.coeffs().abs().maxCoeff() < most);
  }

  /// Returns T^-1 B and T^-T C; std::nullopt at a pole.
  std::optional<std::array<Eigen::VectorXcd, 2>> at(const Complex& point) const {
    Eigen::SparseLU<Sparse> solver(matrix(point));
    if (solver.info() != Eigen::Success) return std::nullopt;
    std::array<Eigen::VectorXcd, 2> both{solver.solve(into_.cast<Complex>()),
                                         solver.transpose().solve(out_of_.cast<Complex>())};
    if (!both[0].allFinite() || !both[1].allFinite()) return std::nullopt;
    return both;
  }

  struct Gain {
    double value;
    bool sure;  ///< Rounding of the numbers of T changes it little.
  };
  /// Returns the response at a real point; std::nullopt if rounding of the numbers of T may change it much.
  std::optional<Gain> gain_at(double point) const {
    constexpr double rounding = 1e-15, least = 1e-6;
    const auto solved = at(point);
    if (!solved) return std::nullopt;
    const Eigen::VectorXd x = (*solved)[0].real(), y = (*solved)[1].real();
    double change = 0.0;
    for (const auto& part : constant_)
      change += std::abs(part.value()) * std::abs(x[part.col()]) * std::abs(y[part.row()]);
    for (Eigen::Index i = 0; i < size(); ++i)
      change += (i < n_ ? std::abs(point) : 1.0) * std::abs(x[i]) * std::abs(y[i]);
    change *= rounding;
    const double size = out_of_.cwiseAbs().dot(x.cwiseAbs()) + std::abs(direct());
    if (!(change <= least * size)) return std::nullopt;
    const double gain = out_of_.dot(x) + direct();
    return Gain{std::abs(gain) > change ? gain : 0.0, change <= 1e-4 * std::abs(gain)};
  }

 private:
  Sparse matrix(const Complex& point) const {
    std::vector<Eigen::Triplet<Complex>> all = constant_;
    for (Eigen::Index i = 0; i < size(); ++i)
      all.emplace_back(i, i, i < n_ ? point : std::exp(point * delay(i - n_)));
    Sparse T(size(), size());
    T.setFromTriplets(all.begin(), all.end());
    return T;
  }
  void put(Eigen::Index row, Eigen::Index column, double number) {
    if (number != 0.0) constant_.emplace_back(row, column, -number);
  }
  double delay(Eigen::Index k) const { return system_.delays[static_cast<std::size_t>(k)].time; }

  const StateSpace& system_;
  Eigen::Index n_, d_;
  std::vector<Eigen::Triplet<Complex>> constant_;
  Eigen::VectorXd into_, out_of_;
};

/// Powers of the distance from the point at rest in the Laurent series of the response there.
struct Expansion {
  int order = 0;         ///< Of the pole; 0 for none.
  double leading = 0.0;  ///< Coefficient of the power -order.
  double most = 0.0;     ///< Largest size of the response on the circle.
};

/// Takes the coefficients of the series from values on a circle, by the trapezoidal rule, which converges
/// geometrically (L. N. Trefethen, J. A. C. Weideman, "The exponentially convergent trapezoidal rule", SIAM
/// Review 56, 2014).
class CircleAboutRest {
 public:
  CircleAboutRest(const Resolvent& resolvent, double centre, double radius)
      : resolvent_(resolvent), centre_(centre), radius_(radius) {}

  /// Returns the expansion with a pole of at most `highest` order; std::nullopt if the circle meets a pole.
  std::optional<Expansion> expand(int highest) {
    if (!look()) return std::nullopt;
    for (int order = highest; order > 0; --order)
      if (const double leading = coefficient(-order); std::abs(leading) > rounding(-order))
        return Expansion{order, leading, most_};
    const double rest = coefficient(0);
    return Expansion{0, std::abs(rest) > 1e-13 * most_ ? rest : 0.0, most_};
  }

 private:
  static constexpr int points = 48;  ///< On the whole circle; the lower half is conjugate.

  Complex turned(int k) const { return std::polar(1.0, 2.0 * std::numbers::pi * k / points); }

  bool look() {
    for (int k = 0; k <= points / 2; ++k) {
      const auto here = resolvent_.at(centre_ + radius_ * turned(k));
      if (!here) return false;
      states_.push_back((*here)[0]);
      costates_.push_back((*here)[1]);
      values_.push_back((resolvent_.out_of().transpose() * states_.back())(0) + resolvent_.direct());
      most_ = std::max(most_, std::abs(values_.back()));
    }
    return true;
  }

  /// Returns the mean over the circle of a list times the turn to a power, by conjugate symmetry real.
  template <class Value>
  auto mean(const std::vector<Value>& list, int power) const {
    auto sum = ((list[0] + list[points / 2] * (power % 2 == 0 ? 1.0 : -1.0)) * Complex(0.5)).eval();
    for (int k = 1; k < points / 2; ++k)
      sum += list[static_cast<std::size_t>(k)] * turned(-k * power % points);
    return (sum.real() * (2.0 / points)).eval();
  }

  double coefficient(int power) const {
    std::vector<Eigen::Matrix<Complex, 1, 1>> list;
    for (const Complex& value : values_) list.emplace_back(value);
    return mean(list, power)(0) * std::pow(radius_, -power);
  }

  /// Returns the size of a coefficient that rounding makes where states cancel.
  double rounding(int power) const {
    constexpr double of_states = 1e-10;
    const double of_values = 1e-12 + 1e-14 * centre_ / radius_;  // points about 1 are rounded themselves
    const double left = resolvent_.out_of().cwiseAbs().dot(mean(states_, power).cwiseAbs()),
                 right = resolvent_.into().cwiseAbs().dot(mean(costates_, power).cwiseAbs());
    return (of_states * std::max(left, right) + of_values * most_) * std::pow(radius_, -power);
  }

  const Resolvent& resolvent_;
  double centre_, radius_;
  std::vector<Eigen::VectorXcd> states_, costates_;
  std::vector<Complex> values_;
  double most_ = 0.0;
};

/// Poles by their distance from the point at rest.
struct Surroundings {
  std::vector<double> distances;
  std::size_t fewest = 0, most = 0;  ///< Numbers of poles that can be one pole at rest, but for rounding.
  std::size_t close = 0;             ///< Number of poles that a zero may cancel there.

  /// Returns the radius of a circle about the first poles, on which the others change the response little.
  double radius(std::size_t inside, const std::vector<InnerDelay>& delays) const {
    double crowd = 0.0;
    for (std::size_t k = inside; k < distances.size(); ++k) crowd += 1.0 / distances[k];
    for (const InnerDelay& delay : delays) crowd += delay.time;
    return crowd > 0.0 ? 0.25 / crowd : 0.25;
  }
  /// Returns the largest distance of the first poles.
  double spread(std::size_t inside) const { return inside > 0 ? distances[inside - 1] : 0.0; }
};

/// Rounding of the largest pole spreads a pole of order m over a radius of eps^(1/m), but its mean moves by
/// eps only.
Surroundings surroundings_of(std::vector<Complex> poles, double centre) {
  constexpr double rounding = 1e-14;
  for (Complex& pole : poles) pole -= centre;
  std::ranges::sort(poles, {}, [](const Complex& pole) { return std::abs(pole); });
  const double size = centre > 0.0 ? 1.0 : poles.empty() ? 0.0 : std::abs(poles.back());
  Surroundings found;
  Complex sum = 0.0;
  for (const Complex& pole : poles) {
    sum += pole;
    found.distances.push_back(std::abs(pole));
    if (std::abs(pole) <= 1e-8 * size) found.close = found.distances.size();
    const double order = static_cast<double>(found.distances.size());
    if (std::abs(sum) > order * rounding * size ||
        std::abs(pole) > 3.0 * std::pow(rounding, 1.0 / order) * size)
      continue;
    found.most = found.distances.size();
    if (found.fewest == 0 || std::abs(pole) <= rounding * size) found.fewest = found.most;
  }
  return found;
}

double limit_of(const Expansion& expansion) {
  if (expansion.order == 0) return expansion.leading;
  return std::copysign(std::numeric_limits<double>::infinity(), expansion.leading);
}

/// Returns the limit by two circles about poles at rest; NaN if they disagree.
double limit_by_circles(const StateSpace& system, double centre, const Surroundings& near,
                        std::size_t inside) {
  const double radius = near.radius(inside, system.delays);
  const double inner = std::max(1e-2 * radius, std::sqrt(radius * near.spread(inside)));
  const Resolvent resolvent(system);
  const int highest = static_cast<int>(std::min<Eigen::Index>(8, resolvent.size()));
  const auto far = CircleAboutRest(resolvent, centre, radius).expand(highest),
             close = CircleAboutRest(resolvent, centre, inner).expand(highest);
  if (!far || !close) return undecided;
  const double limit = limit_of(*close), other = limit_of(*far);
  if (close->order > 0) return far->order > 0 && limit != other ? undecided : limit;
  return far->order == 0 && std::abs(limit - other) <= 1e-6 * far->most ? limit : undecided;
}

}  // namespace

double gain_at_rest(const StateSpace& system) {
  const double centre = system.is_sampled() ? 1.0 : 0.0;
  if (!system.A.allFinite()) return undecided;
  if (system.A.size() == 0 && system.delays.empty()) return system.D(0, 0);
  const Resolvent resolvent(system);
  const auto direct = resolvent.gain_at(centre);
  if (direct && (direct->sure || !resolvent.is_near_pole(centre))) return direct->value;
  const Surroundings near = surroundings_of(poles_of(system), centre);
  if (direct && near.most == 0 && near.close == 0) return direct->value;
  const bool cancels = direct && near.most == 0;
  const double limit = limit_by_circles(system, centre, near, cancels ? near.close : near.fewest);
  if (near.most == near.fewest) return limit;
  const double other = limit_by_circles(system, centre, near, near.most);
  return limit == other || std::abs(limit - other) <= 1e-6 * std::abs(limit) ? limit : undecided;
}

}  // namespace stepwire::linear
