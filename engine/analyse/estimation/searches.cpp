#include "engine/analyse/estimation/searches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "engine/analyse/estimation/certainty.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"

namespace stepwire::estimation {
namespace {

using messages::ByteReader;
using messages::ByteWriter;

void put(ByteWriter& writer, const Eigen::VectorXd& x) {
  plain_list(writer, x);
}

Eigen::VectorXd vector_of(ByteReader& reader) {
  std::vector<double> numbers;
  plain_list(reader, numbers);
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

std::string bytes_of(const SearchStart& start) {
  ByteWriter writer;
  put(writer, start.from);
  all(writer, start.iterations);
  return writer.take();
}

std::string bytes_of(const Minimum& minimum) {
  ByteWriter writer;
  put(writer, minimum.x);
  all(writer, minimum.cost, minimum.converged, minimum.stalled, minimum.iterations, minimum.refusal);
  return writer.take();
}

Minimum minimum_of(std::string_view bytes) {
  ByteReader reader(bytes);
  Minimum minimum{.x = vector_of(reader)};
  all(reader, minimum.cost, minimum.converged, minimum.stalled, minimum.iterations, minimum.refusal);
  if (!reader.whole()) throw io::EnvironmentError("a search of another process is not as it was sent");
  return minimum;
}

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

constexpr std::size_t first_look = 6;  // steps after which the starts are compared

constexpr int most_steps = 20;
constexpr double cost_rounding = 1e-12;  // relative, from one run to the next

/// A Gauss-Newton step within the bounds, and its size.
struct Step {
  Eigen::VectorXd to;
  double change = 0.0;  ///< Largest change relative to a value or its standard error.
};

class Refinement {
 public:
  Refinement(const Residuals& residuals, const FitRequest& request, Minimum found)
      : residuals_(residuals), request_(request), result_{std::move(found), {}, 0.0} {}

  Refined run(const std::atomic<bool>* interrupt) {
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_steps && !(interrupt && *interrupt); ++k) {
      if (!differentiate()) break;
      const Step step = next();
      result_.change = step.change;
      if (step.change <= request_.tolerance || !take(step, before)) break;
      before = step.change;
    }
    return std::move(result_);
  }

 private:
  /// Computes derivatives at the minimum. On failure returns false and keeps the last point with derivatives.
  bool differentiate() {
    KnownPoint at{result_.minimum.x, {}, {}};
    if (!residuals_.evaluate(at.x, at.residuals, at.slopes, Residuals::Differences::central)) return false;
    result_.at = std::move(at);
    return true;
  }

  /// Clears the columns of unknowns at a bound towards which the cost falls.
  void hold(const Eigen::VectorXd& r, Jacobian& slopes) const {
    const Eigen::VectorXd gradient = slopes.transpose() * r;
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
      const FitParameter& of = residuals_.parameter(static_cast<std::size_t>(i));
      const double x = result_.minimum.x[i];
      if ((x <= of.lower && gradient[i] > 0.0) || (x >= of.upper && gradient[i] < 0.0))
        slopes.col(i).setZero();
    }
  }

  Step next() const {
    Eigen::VectorXd r = result_.at.residuals;
    Jacobian slopes = result_.at.slopes;
    count(request_, r, slopes);
    hold(r, slopes);
    const Resolution resolved = Resolution::of(slopes);
    const Eigen::VectorXd along = -(resolved.inverse * (resolved.scaled.transpose() * r));
    const double s =
        r.norm() / std::sqrt(static_cast<double>(std::max<Eigen::Index>(1, r.size() - slopes.cols())));
    Step step{result_.minimum.x};
    for (Eigen::Index i = 0; i < along.size(); ++i) {
      const FitParameter& of = residuals_.parameter(static_cast<std::size_t>(i));
      const double x = result_.minimum.x[i];
      step.to[i] = std::clamp(x + along[i] / resolved.lengths[i], of.lower, of.upper);
      const double error = s * std::sqrt(std::max(0.0, resolved.inverse(i, i))) / resolved.lengths[i];
      const double size = std::max(std::abs(x), error);
      if (step.to[i] != x) step.change = std::max(step.change, std::abs(step.to[i] - x) / size);
    }
    return step;
  }

  /// Takes the step, or the first half, quarter, ... of it that lowers the cost. Near the minimum rounding
  /// error hides the gain; a full step is accepted there while steps become smaller.
  bool take(const Step& step, double before) {
    Eigen::VectorXd r;
    Minimum& best = result_.minimum;
    for (double part = 1.0; part > 1e-3; part *= 0.5) {
      const Eigen::VectorXd x = best.x + part * (step.to - best.x);
      if (!residuals_.evaluate(x, r)) continue;
      const double cost = cost_of(r, request_);
      const bool within_rounding =
          part == 1.0 && step.change < 0.5 * before && cost <= best.cost * (1.0 + cost_rounding);
      if (!(cost < best.cost) && !within_rounding) continue;
      best.cost = cost;
      best.x = x;
      return true;
    }
    return false;
  }

  const Residuals& residuals_;
  const FitRequest& request_;
  Refined result_;
};

/// Distributes the searches from these starts to other processes.
std::vector<Minimum> search_by(messages::ItemWorkers& workers, const std::vector<SearchStart>& starts) {
  std::vector<messages::Item> items;
  for (const SearchStart& start : starts) items.push_back({start.number, bytes_of(start)});
  std::vector<Minimum> minima;
  for (const std::string& bytes : workers.run(items)) minima.push_back(minimum_of(bytes));
  return minima;
}

}  // namespace

SearchWork::SearchWork(const ModelSource& source, const run::Job& job, const FitRequest& request,
                       unsigned threads)
    : request_(request),
      interrupt_(source.interrupt),
      runs_(source, job, request),
      residuals_(runs_, request, threads) {}

std::string SearchWork::work(const messages::Item& item) const {
  ByteReader reader(item.bytes);
  const Eigen::VectorXd from = vector_of(reader);
  std::size_t iterations = 0;
  all(reader, iterations);
  return bytes_of(minimise(residuals_, request_, from, {iterations, interrupt_}));
}

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

std::vector<std::size_t> ranking(const std::vector<Minimum>& minima) {
  std::vector<std::size_t> order(minima.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return minima[a].cost < minima[b].cost; });
  return order;
}

std::vector<Minimum> Searches::from(const std::vector<Eigen::VectorXd>& starts) const {
  std::vector<Minimum> minima = first_looks(starts);
  follow(minima);
  return minima;
}

std::vector<Minimum> Searches::first_looks(const std::vector<Eigen::VectorXd>& starts) const {
  const std::size_t count = starts.size();
  const std::size_t steps = count == 1 ? request_.iterations : std::min(first_look, request_.iterations);
  std::vector<SearchStart> searches;
  for (std::size_t k = 0; k < count; ++k) searches.push_back({k, starts[k], steps});
  return search(searches, 0.0, 0.6,
                [&](const SearchStart& one) { return fmt::format("start {} of {}", one.number + 1, count); });
}

void Searches::follow(std::vector<Minimum>& minima) const {
  const std::vector<std::size_t> order = ranking(minima);
  const std::size_t kept = std::min(order.size(), request_.follow.value_or((order.size() + 3) / 4));
  std::vector<SearchStart> searches;
  for (std::size_t k = 0; k < kept; ++k)
    if (const Minimum& one = minima[order[k]]; !one.converged && !one.stalled && std::isfinite(one.cost))
      searches.push_back({minima.size() + order[k], one.x, request_.iterations});
  std::vector<Minimum> found = search(searches, 0.6, 0.4, [&](const SearchStart& one) {
    return fmt::format("start {}", one.number - minima.size() + 1);
  });
  for (std::size_t k = 0; k < found.size(); ++k) {
    Minimum& one = minima[searches[k].number - minima.size()];
    found[k].iterations += one.iterations;
    one = std::move(found[k]);
  }
}

/// Makes all searches, or after an interruption those begun so far, at least the first.
template <class NameOf>
std::vector<Minimum> Searches::search(const std::vector<SearchStart>& starts, double done, double share,
                                      const NameOf& name_of) const {
  if (workers_ && !starts.empty()) return search_by(*workers_, starts);
  const double part = share / static_cast<double>(starts.size());
  std::vector<Minimum> minima;
  for (const SearchStart& start : starts) {
    if (interrupt_ && *interrupt_ && start.number > 0) break;
    minima.push_back(descend_(start, done + part * static_cast<double>(minima.size()), part, name_of(start)));
  }
  return minima;
}

Refined refine(const Residuals& residuals, const FitRequest& request, Minimum found,
               const std::atomic<bool>* interrupt) {
  return Refinement(residuals, request, std::move(found)).run(interrupt);
}

}  // namespace stepwire::estimation
