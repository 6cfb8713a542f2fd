#include "engine/analyse/linear/slopes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stepwire::linear {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double none_yet = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Difference quotients of one size.
struct Difference {
  Eigen::VectorXd central, left, right;
  Eigen::ArrayXd rounding;  ///< Bound of their rounding error.
};

/// Returns a power of two not below |at| and 1; sums with it have little rounding error.
double scale_of(double at) {
  return std::exp2(std::ceil(std::log2(std::max(1.0, std::abs(at)))));
}

class Differences {
 public:
  Differences(const std::function<Eigen::VectorXd(double)>& function, double at)
      : function_(function), at_(at), here_(function(at)) {}

  Eigen::Index size() const { return here_.size(); }

  /// Returns the quotients of a size; they may be non-finite.
  Difference of(double size) const {
    const volatile double above = at_ + size, below = at_ - size;
    const Eigen::VectorXd up = function_(above), down = function_(below);
    const double right = above - at_, left = at_ - below;
    return {(up - down) / (right + left), (here_ - down) / left, (up - here_) / right,
            epsilon * (up.array().abs() + down.array().abs() + here_.array().abs()) / right};
  }

 private:
  const std::function<Eigen::VectorXd(double)>& function_;
  double at_;
  Eigen::VectorXd here_;
};

Slopes no_slopes(Eigen::Index size) {
  const Eigen::VectorXd none = Eigen::VectorXd::Constant(size, nothing);
  return {none,
          Eigen::VectorXd::Constant(size, none_yet),
          none,
          none,
          std::vector<bool>(static_cast<std::size_t>(size), false),
          none,
          none};
}

/// Extrapolates one element; the entry of the tableau with the least error is the result.
void extrapolate(const std::vector<Difference>& sizes, double ratio, Eigen::Index i, Slopes& slopes) {
  std::vector<double> before, row;
  for (const Difference& size : sizes) {
    if (!std::isfinite(size.central[i])) {
      before.clear();
      continue;
    }
    row = {size.central[i]};
    double factor = 1.0;
    const double rounding = size.rounding[i];
    for (std::size_t k = 0; k < before.size() && k < 8; ++k) {
      factor *= ratio * ratio;
      row.push_back((factor * row[k] - before[k]) / (factor - 1.0));
      const double error =
          rounding + std::max(std::abs(row[k + 1] - row[k]), std::abs(row[k + 1] - before[k]));
      if (error >= slopes.error[i]) continue;
      slopes.error[i] = error;
      slopes.value[i] = row[k + 1];
    }
    before = row;
  }
  if (std::abs(slopes.value[i]) <= slopes.error[i]) slopes.value[i] = 0.0;
}

double gap_of(const Difference& sizes, Eigen::Index i) {
  return std::abs(sizes.right[i] - sizes.left[i]);
}

/// True at a kink or jump: both sides differ, and the gap does not shrink with a 16-fold smaller difference.
bool is_rough(const Difference& larger, const Difference& smaller, Eigen::Index i) {
  const double gap = gap_of(smaller, i), before = gap_of(larger, i);
  const double size = std::max(std::abs(smaller.right[i]), std::abs(smaller.left[i]));
  return gap > 1e-3 * size && gap > 100.0 * smaller.rounding[i] && gap > 0.5 * before;
}

bool disagrees(const Difference& small, const Slopes& slopes, Eigen::Index i) {
  const double size = std::max(std::abs(small.central[i]), std::abs(slopes.value[i]));
  return std::abs(small.central[i] - slopes.value[i]) > 1e-3 * size + 1000.0 * small.rounding[i];
}

/// True if large differences agree on a derivative where small ones give 0: a staircase, or backlash.
bool is_flat_here(const std::vector<Difference>& sizes, const Slopes& slopes, Eigen::Index i) {
  const double first = sizes[0].central[i], second = sizes[1].central[i];
  return slopes.value[i] == 0.0 && first != 0.0 && std::abs(first - second) <= 0.05 * std::abs(first);
}

/// Sets the numbers on non-smooth behaviour.
void judge(const std::vector<Difference>& sizes, const Difference& large, const Difference& small,
           Eigen::Index i, Slopes& slopes) {
  if (is_rough(large, small, i)) {
    slopes.left[i] = small.left[i];
    slopes.right[i] = small.right[i];
    slopes.jumps[static_cast<std::size_t>(i)] = gap_of(small, i) > 8.0 * gap_of(large, i);
  }
  if (disagrees(small, slopes, i)) slopes.nearer[i] = small.central[i];
  if (is_flat_here(sizes, slopes, i)) slopes.farther[i] = sizes[0].central[i];
}

}  // namespace

void Slopes::erase(Eigen::Index row) {
  for (Eigen::VectorXd* numbers : {&value, &error, &left, &right, &farther, &nearer}) {
    if (numbers->size() == 0) continue;
    const Eigen::Index behind = numbers->size() - row - 1;
    numbers->segment(row, behind) = numbers->tail(behind).eval();
    numbers->conservativeResize(numbers->size() - 1);
  }
  jumps.erase(jumps.begin() + row);
}

Slopes slopes_of(const std::function<Eigen::VectorXd(double)>& function, double at,
                 const DifferenceSizes& wanted) {
  constexpr double first = 0.0625;
  const double scale = std::min(scale_of(at), wanted.largest / wanted.only.value_or(first));
  const Differences differences(function, at);
  Slopes slopes = no_slopes(differences.size());
  if (wanted.only) {
    const Difference wide = differences.of(*wanted.only * scale),
                     half = differences.of(0.5 * *wanted.only * scale);
    slopes.value = wide.central;
    slopes.error = (wide.central - half.central).cwiseAbs();
    return slopes;
  }
  constexpr int halvings = 26, rough = 12, finer = 16;
  std::vector<Difference> sizes;
  for (int k = 0; k <= halvings; k += wanted.stride)
    sizes.push_back(differences.of(first * scale * std::exp2(-k)));
  const Difference &large = sizes[static_cast<std::size_t>(rough / wanted.stride)],
                   &small = sizes[static_cast<std::size_t>(finer / wanted.stride)];
  for (Eigen::Index i = 0; i < differences.size(); ++i) {
    extrapolate(sizes, std::exp2(wanted.stride), i, slopes);
    judge(sizes, large, small, i, slopes);
  }
  return slopes;
}

}  // namespace stepwire::linear
