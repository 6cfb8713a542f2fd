#include "engine/analyse/linear/gain_at_rest.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/analyse/linear/point_response.hpp"
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

  /// Returns T^-1 B and T^-T C; std::nullopt at a pole.
  std::optional<std::array<Eigen::VectorXcd, 2>> at(const Complex& point) const {
    std::vector<Eigen::Triplet<Complex>> all = constant_;
    for (Eigen::Index i = 0; i < size(); ++i)
      all.emplace_back(i, i, i < n_ ? point : std::exp(point * delay(i - n_)));
    Sparse T(size(), size());
    T.setFromTriplets(all.begin(), all.end());
    Eigen::SparseLU<Sparse> solver(T);
    if (solver.info() != Eigen::Success) return std::nullopt;
    return std::array<Eigen::VectorXcd, 2>{solver.solve(into_.cast<Complex>()),
                                           solver.transpose().solve(out_of_.cast<Complex>())};
  }

 private:
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
      if (!here || !(*here)[0].allFinite() || !(*here)[1].allFinite()) return false;
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
    constexpr double of_states = 1e-10, of_values = 1e-12;
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
  std::size_t at_rest = 0;  ///< Number of poles there, within rounding.
  double spread = 0.0;      ///< Largest distance of these.
  double crowd = 0.0;       ///< Sum of the inverse distances of all others.
};

/// Takes the largest cluster that can be one pole. Rounding by `eps` of the largest pole spreads a pole of
/// order m over a radius of eps^(1/m), but its mean moves by eps only.
Surroundings surroundings_of(std::vector<Complex> poles, double centre) {
  constexpr double rounding = 1e-15;
  for (Complex& pole : poles) pole -= centre;
  std::ranges::sort(poles, {}, [](const Complex& pole) { return std::abs(pole); });
  const double size = centre > 0.0 ? 1.0 : poles.empty() ? 0.0 : std::abs(poles.back());
  Surroundings found;
  Complex sum = 0.0;
  for (std::size_t m = 1; m <= poles.size(); ++m) {
    sum += poles[m - 1];
    const double count = static_cast<double>(m), distance = std::abs(poles[m - 1]);
    const bool is_one = std::abs(sum) <= 10.0 * count * rounding * size &&
                        distance <= 10.0 * std::pow(rounding, 1.0 / count) * size;
    if (distance == 0.0 || is_one) found.at_rest = m, found.spread = distance;
  }
  for (std::size_t k = found.at_rest; k < poles.size(); ++k) found.crowd += 1.0 / std::abs(poles[k]);
  return found;
}

double limit_of(const Expansion& expansion) {
  return expansion.order == 0 ? expansion.leading
                              : std::copysign(std::numeric_limits<double>::infinity(), expansion.leading);
}

/// Returns the limit by two circles about the point at rest, on which other poles change the response little.
double limit_by_circles(const StateSpace& system, double centre, const Surroundings& near) {
  double crowd = near.crowd;
  for (const InnerDelay& delay : system.delays) crowd += delay.time;
  const double radius = crowd > 0.0 ? 0.25 / crowd : 0.25;
  const double inner = std::max(1e-2 * radius, std::sqrt(radius * near.spread));
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
  const Surroundings plain = surroundings_of(eigenvalues(system.A), centre);
  const Surroundings whole = system.delays.empty() ? plain : surroundings_of(poles_of(system), centre);
  if (plain.at_rest == 0 && whole.at_rest == 0) {
    const double limit = PointResponse(system).at(centre).real();
    if (std::isfinite(limit)) return limit;
  }
  return limit_by_circles(system, centre, whole);
}

}  // namespace stepwire::linear
