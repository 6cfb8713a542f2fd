#include "engine/analyse/estimation/fitted_curve.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::estimation {

namespace {

constexpr int intervals = 120;
constexpr double difference = 1e-6;  // as a share of a parameter's size

class Evaluation {
 public:
  Evaluation(const FitCurve& curve, const std::vector<std::string>& names)
      : curve_(curve), formula_(curve.y.formula), names_(names) {}

  double at(double variable, const Eigen::VectorXd& x) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < formula_.columns.size(); ++i) values.push_back(value_of(i, variable, x));
    return formula_.expression(values);
  }

  Eigen::VectorXd slopes(double variable, const Eigen::VectorXd& x) const {
    Eigen::VectorXd slopes(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double step = difference * (x[i] == 0.0 ? 1.0 : std::abs(x[i]));
      Eigen::VectorXd above = x, below = x;
      above[i] += step;
      below[i] -= step;
      slopes[i] = (at(variable, above) - at(variable, below)) / (2.0 * step);
    }
    return slopes;
  }

 private:
  double value_of(std::size_t i, double variable, const Eigen::VectorXd& x) const {
    const std::string& column = formula_.columns[i];
    if (column == curve_.variable) return variable;
    const auto found = std::find(names_.begin(), names_.end(), column);
    return found == names_.end() ? curve_.otherwise[i] : x[static_cast<Eigen::Index>(found - names_.begin())];
  }

  const FitCurve& curve_;
  const query::Formula& formula_;
  const std::vector<std::string>& names_;
};

}  // namespace

FittedCurve fitted_curve(const FitCurve& curve, const std::vector<std::string>& names,
                         const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance, double quantile) {
  FittedCurve fitted{curve.y.label, curve.y.unit_text, curve.label, curve.y.formula.dimension};
  const Evaluation evaluation(curve, names);
  for (int k = 0; k <= intervals; ++k) {
    const double at = curve.from + (curve.to - curve.from) * k / intervals;
    const double value = evaluation.at(at, x);
    const Eigen::VectorXd slopes = evaluation.slopes(at, x);
    const double half = quantile * std::sqrt(std::max(0.0, slopes.dot(covariance * slopes)));
    fitted.at.push_back(at);
    fitted.value.push_back(value);
    fitted.low.push_back(value - half);
    fitted.high.push_back(value + half);
  }
  return fitted;
}

void add_data(const FitCurve& curve, std::span<const record::Recording> recordings, FittedCurve& fitted) {
  if (!curve.data) return;
  for (const double value : query::evaluate(*curve.data, recordings[curve.recording])) {
    if (!std::isfinite(value)) continue;
    if (fitted.data_range.empty()) fitted.data_range = {value, value};
    fitted.data_range = {std::min(fitted.data_range[0], value), std::max(fitted.data_range[1], value)};
  }
}

}  // namespace stepwire::estimation
