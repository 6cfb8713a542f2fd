#include "engine/analyse/statistics/power.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/distributions.hpp"
#include "engine/base/math/random.hpp"

namespace stepwire::statistics {
namespace {

constexpr std::size_t fewest_subjects = 3;
constexpr double alike = 1e-12;  // rounding error of the squares of identical subjects

using Scores = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor>;

/// Returns one column per subject: the scores about their mean, scaled to the estimated variance.
Scores population(const Eigen::MatrixXd& scores) {
  const auto count = static_cast<double>(scores.rows());
  const Eigen::RowVectorXd mean = scores.colwise().mean();
  return (((scores.rowwise() - mean) * std::sqrt(count / (count - 1.0))).rowwise() + mean).transpose();
}

/// Returns for each number n of subjects the critical ratio of n |mean|^2 to the squares about the mean.
std::vector<double> critical_ratios(const PowerSimulation& simulation, double contrasts) {
  std::vector<double> ratios(simulation.most_subjects + 1, 0.0);
  for (std::size_t n = 2; n < ratios.size(); ++n) {
    const double error = static_cast<double>(n) - 1.0;
    ratios[n] =
        fisher_critical(0.05, contrasts * simulation.epsilon, contrasts * error * simulation.epsilon) / error;
  }
  return ratios;
}

/// Simulates experiments by adding one subject after another. The sums are updated with each subject, so one
/// draw of the largest experiment tests all smaller ones, too. The cost is one vector addition per subject.
class Experimenter {
 public:
  Experimenter(const Scores& subjects, std::vector<double> critical)
      : subjects_(subjects),
        critical_(std::move(critical)),
        sum_(subjects.rows()),
        significant_(critical_.size(), 0) {
    squares_of_ = subjects.colwise().squaredNorm();
  }

  void draw(std::uint64_t stream) {
    sum_.setZero();
    double squares = 0.0;
    for (std::size_t n = 1; n < critical_.size(); ++n) {
      const Eigen::Index subject = drawn_subject(random_bits(stream, n));
      sum_ += subjects_.col(subject);
      squares += squares_of_[subject];
      const double between = sum_.squaredNorm() / static_cast<double>(n), within = squares - between;
      if (n > 1 && within > alike * squares && between > critical_[n] * within) ++significant_[n];
    }
  }

  const std::vector<std::size_t>& significant() const { return significant_; }

 private:
  Eigen::Index drawn_subject(std::uint64_t bits) const {
    return static_cast<Eigen::Index>(to_unit_interval(bits) * static_cast<double>(subjects_.cols()));
  }

  const Scores& subjects_;
  std::vector<double> critical_;
  Eigen::VectorXd sum_;
  Eigen::RowVectorXd squares_of_;
  std::vector<std::size_t> significant_;
};

}  // namespace

double paired_power(double d_z, std::size_t subjects) {
  if (std::isnan(d_z)) return d_z;
  const auto count = static_cast<double>(subjects);
  const double critical = student_quantile(0.975, count - 1.0), noncentrality = std::sqrt(count) * d_z;
  const double power = noncentral_student_tail(critical, count - 1.0, noncentrality) +
                       noncentral_student_tail(critical, count - 1.0, -noncentrality);
  return std::clamp(power, 0.0, 1.0);
}

std::optional<std::size_t> subjects_needed(double d_z, double power, std::size_t most) {
  if (!(paired_power(d_z, most) >= power)) return std::nullopt;
  std::size_t few = 1, enough = 2;
  for (; enough < most && paired_power(d_z, enough) < power; enough = std::min(most, 2 * enough))
    few = enough;
  while (enough - few > 1) {
    const std::size_t middle = few + (enough - few) / 2;
    (paired_power(d_z, middle) < power ? few : enough) = middle;
  }
  return enough;
}

std::vector<double> simulated_power(const Eigen::MatrixXd& scores, const PowerSimulation& simulation) {
  if (scores.rows() < static_cast<Eigen::Index>(fewest_subjects)) return {};
  const Eigen::MatrixXd centred = scores.rowwise() - scores.colwise().mean();
  if (centred.squaredNorm() <= alike * alike * scores.squaredNorm()) return {};
  const Scores subjects = population(scores);
  Experimenter experimenter(subjects, critical_ratios(simulation, static_cast<double>(scores.cols())));
  for (std::size_t i = 0; i < simulation.experiments; ++i) experimenter.draw(random_bits(simulation.seed, i));
  std::vector<double> power;
  for (const std::size_t count : experimenter.significant())
    power.push_back(static_cast<double>(count) / static_cast<double>(simulation.experiments));
  return power;
}

std::optional<std::size_t> subjects_needed(const std::vector<double>& by_subjects, double power) {
  std::size_t needed = by_subjects.size();
  while (needed > 0 && by_subjects[needed - 1] >= power) --needed;
  if (needed == by_subjects.size()) return std::nullopt;
  return needed;
}

}  // namespace stepwire::statistics
