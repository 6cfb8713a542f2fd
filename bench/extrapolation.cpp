#include "bench/extrapolation.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::bench {

namespace {

using Number = long double;
using Vector = std::vector<Number>;

class Extrapolation {
 public:
  explicit Extrapolation(const ivp::Problem& problem)
      : problem_(problem), x_(problem.start.begin(), problem.start.end()) {
    for (Vector* vector : {&slope_, &first_, &before_, &now_, &next_}) vector->resize(x_.size());
    for (Vector& row : rows_) row.resize(x_.size());
  }

  std::vector<double> run() {
    Number time = 0.0L, step = 1e-6L * problem_.end;
    while (time < problem_.end) {
      step = std::min(step, problem_.end - time);
      problem_.long_derivative(time, x_.data(), slope_.data());
      const Number error = attempt(time, step);
      if (error <= 1.0L) {
        time += step;
        x_ = rows_[0];
      }
      const Number factor = 0.8L * std::pow(std::max(error, 1e-12L), -1.0L / (2 * columns - 1));
      step *= std::isfinite(factor) ? std::clamp(factor, 0.1L, 4.0L) : 0.1L;
    }
    return {x_.begin(), x_.end()};
  }

 private:
  static constexpr int columns = 6;

  /// Integrates a step by the midpoint rule in `count` parts.
  void midpoint(Number time, Number step, int count, Vector& result) {
    const Number part = step / count;
    before_ = x_;
    for (std::size_t i = 0; i < x_.size(); ++i) now_[i] = x_[i] + part * slope_[i];
    for (int k = 1; k < count; ++k) {
      problem_.long_derivative(time + k * part, now_.data(), first_.data());
      for (std::size_t i = 0; i < x_.size(); ++i) next_[i] = before_[i] + 2.0L * part * first_[i];
      before_.swap(now_);
      now_.swap(next_);
    }
    result = now_;
  }

  /// Stores the new states in rows_[0]; returns the error over the tolerance.
  Number attempt(Number time, Number step) {
    Vector last(x_.size());
    for (int k = 0; k < columns; ++k) {
      midpoint(time, step, 2 * (k + 1), rows_[k]);
      for (int j = k - 1; j >= 0; --j) {
        const Number ratio = Number(k + 1) / (j + 1);
        const Number weight = 1.0L / (ratio * ratio - 1.0L);
        for (std::size_t i = 0; i < x_.size(); ++i)
          rows_[j][i] = rows_[j + 1][i] + weight * (rows_[j + 1][i] - rows_[j][i]);
      }
      if (k == columns - 2) last = rows_[0];
    }
    Number worst = 0.0L;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const Number size = std::max(std::abs(x_[i]), std::abs(rows_[0][i])) + 0.1L * problem_.absolute;
      const Number error = std::abs(rows_[0][i] - last[i]) / (1e-16L * size);
      if (!(error <= worst)) worst = error;
    }
    return worst;
  }

  const ivp::Problem& problem_;
  Vector x_, slope_, first_, before_, now_, next_;
  Vector rows_[columns];
};

}  // namespace

std::vector<double> extrapolate(const ivp::Problem& problem) {
  return Extrapolation(problem).run();
}

}  // namespace stepwire::bench
