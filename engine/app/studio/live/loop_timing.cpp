#include "engine/app/studio/live/loop_timing.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::live {

namespace {

using json::Json;
using realtime::Histogram;

constexpr double per_octave = 4.0, ns = 1e-9;
constexpr double shortest = 64.0;  // [ns] upper edge of the first bin
constexpr std::size_t bins = 145;  // up to 73 min

double edge(std::size_t bin) {
  return bin == 0 ? 0.0 : shortest * std::exp2(static_cast<double>(bin - 1) / per_octave);
}

std::size_t bin_of(double time) {
  if (time < shortest) return 0;
  return std::min(bins - 1, 1 + static_cast<std::size_t>(per_octave * std::log2(time / shortest)));
}

/// Returns the histogram without empty bins at both ends.
Json bins_json(const Histogram& times) {
  std::vector<std::int64_t> counts(bins, 0);
  for (std::size_t fine = 0; fine < Histogram::bins(); ++fine)
    counts[bin_of(static_cast<double>(Histogram::begin_of(fine)))] += times.count_in(fine);
  const auto is_full = [](std::int64_t count) { return count > 0; };
  const auto first = std::ranges::find_if(counts, is_full);
  const auto end = std::find_if(counts.rbegin(), counts.rend(), is_full).base();
  Json edges = Json::list(), full = Json::list();
  for (auto count = first; count < end; ++count) {
    if (count == first) edges.push(ns * edge(static_cast<std::size_t>(first - counts.begin())));
    edges.push(ns * edge(static_cast<std::size_t>(count - counts.begin()) + 1));
    full.push(*count);
  }
  return Json::object().set("edges", std::move(edges)).set("counts", std::move(full));
}

Json times_json(const Histogram& times) {
  const auto quantile = [&](double share) { return ns * static_cast<double>(times.quantile(share)); };
  return bins_json(times)
      .set("count", times.count())
      .set("p50", quantile(0.5))
      .set("p99", quantile(0.99))
      .set("p999", quantile(0.999))
      .set("max", ns * static_cast<double>(times.max()));
}

Json costs_json(const realtime::Loop& loop) {
  Json costs = Json::list();
  for (const realtime::GroupCost& cost : loop.group_costs())
    if (cost.samples > 0)
      costs.push(
          Json::object().set("type", cost.type).set("blocks", cost.blocks).set("mean", ns * cost.mean));
  return costs;
}

}  // namespace

Json timing_of(const realtime::Loop& loop, const session::LoopSettings& settings) {
  const realtime::Deadlines& deadlines = loop.deadlines();
  return Json::object()
      .set("period", 1.0 / settings.rate)
      .set("served", loop.steps())
      .set("missed", deadlines.missed())
      .set("late", deadlines.late())
      .set("dropped", deadlines.dropped())
      .set("longest", deadlines.longest_row())
      .set("lateness", times_json(loop.measurements().wake_up()))
      .set("response", times_json(loop.measurements().response()))
      .set("step", times_json(loop.measurements().step()))
      .set("costs", costs_json(loop));
}

}  // namespace stepwire::live
