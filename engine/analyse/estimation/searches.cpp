#include "engine/analyse/estimation/searches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stepwire::estimation {

namespace {

constexpr std::size_t first_look = 6;  // steps after which the starts are compared

}  // namespace

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

}  // namespace stepwire::estimation
