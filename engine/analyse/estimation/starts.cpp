#include "engine/analyse/estimation/starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "engine/analyse/estimation/loss.hpp"

namespace stepwire::estimation {

namespace {

/// Random numbers that are the same on any machine, unlike those of std::uniform_real_distribution.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between_0_and_1() { return static_cast<double>(engine_() >> 11u) * 0x1p-53; }
  Eigen::Index below(Eigen::Index count) {
    return static_cast<Eigen::Index>(between_0_and_1() * static_cast<double>(count));
  }

 private:
  std::mt19937_64 engine_;
};

double draw(const FitParameter& parameter, Random& random) {
  const double share = random.between_0_and_1(), low = parameter.lower, high = parameter.upper;
  if (!parameter.bounded()) {
    const double start = parameter.start == 0.0 ? parameter.scale * (2.0 * share - 1.0)
                                                : parameter.start * std::exp2(2.0 * share - 1.0);
    return std::clamp(start, low, high);
  }
  const bool wide = low * high > 0.0 && std::max(low / high, high / low) > 10.0;
  return wide ? low * std::pow(high / low, share) : low + (high - low) * share;
}

/// Draws a point that the diagram accepts; after 50 refused points the last one is returned.
Eigen::VectorXd draw(const Residuals& residuals, Random& random) {
  constexpr int tries = 50;
  Eigen::VectorXd x = residuals.start();
  for (int k = 0; k < tries; ++k) {
    for (Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = draw(residuals.parameter(static_cast<std::size_t>(i)), random);
    if (residuals.refusal(x).empty()) break;
  }
  return x;
}

double cost_at(const Residuals& residuals, const FitRequest& request, const Eigen::VectorXd& x) {
  Eigen::VectorXd r;
  return residuals.evaluate(x, r) ? cost_of(r, request) : std::numeric_limits<double>::infinity();
}

/// A member of a population and its cost.
struct Member {
  Eigen::VectorXd x;
  double cost;
};

Eigen::VectorXd child_of(const std::vector<Member>& population, std::size_t parent,
                         const Residuals& residuals, Random& random) {
  constexpr double factor = 0.7, crossover = 0.9;
  const auto other = [&] {
    return population[static_cast<std::size_t>(random.below(static_cast<Eigen::Index>(population.size())))].x;
  };
  const Eigen::VectorXd mutant = other() + factor * (other() - other());
  Eigen::VectorXd child = population[parent].x;
  const Eigen::Index always = random.below(child.size());
  for (Eigen::Index i = 0; i < child.size(); ++i) {
    if (i != always && random.between_0_and_1() > crossover) continue;
    const FitParameter& parameter = residuals.parameter(static_cast<std::size_t>(i));
    // A value beyond a bound is replaced by the middle between parent and bound.
    child[i] = mutant[i] < parameter.lower   ? 0.5 * (child[i] + parameter.lower)
               : mutant[i] > parameter.upper ? 0.5 * (child[i] + parameter.upper)
                                             : mutant[i];
  }
  return child;
}

}  // namespace

std::vector<Eigen::VectorXd> make_starts(const Residuals& residuals, const FitRequest& request) {
  Random random(request.seed);
  std::vector<Eigen::VectorXd> starts{residuals.start()};
  while (starts.size() < request.starts) starts.push_back(draw(residuals, random));
  return starts;
}

Eigen::VectorXd evolve(const Residuals& residuals, const FitRequest& request,
                       const std::atomic<bool>* interrupt, const GenerationWatcher& watch) {
  Random random(request.seed + 1);
  std::vector<Member> population;
  const auto stopped = [&] { return interrupt && *interrupt; };
  for (std::size_t i = 0; i < request.global->population && !stopped(); ++i) {
    Eigen::VectorXd x = i == 0 ? residuals.start() : draw(residuals, random);
    const double cost = cost_at(residuals, request, x);
    population.push_back({std::move(x), cost});
  }
  const auto best = [&] {
    return std::min_element(population.begin(), population.end(),
                            [](const Member& a, const Member& b) { return a.cost < b.cost; });
  };
  for (std::size_t g = 0; g < request.global->generations && !stopped(); ++g) {
    for (std::size_t i = 0; i < population.size() && !stopped(); ++i) {
      Eigen::VectorXd x = child_of(population, i, residuals, random);
      const double cost = cost_at(residuals, request, x);
      if (cost <= population[i].cost && residuals.refusal(x).empty()) population[i] = {std::move(x), cost};
    }
    if (watch) watch(g + 1, best()->cost);
  }
  return population.empty() ? residuals.start() : best()->x;
}

}  // namespace stepwire::estimation
