#include "tests/diagrams/varied_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/simulate/run/drive.hpp"

namespace stepwire {

namespace {

constexpr std::int64_t most_ticks = 500;
constexpr std::size_t most_varied = 4;

/// Returns the value of a run as `--set` has it.
std::string text_of(const Varied& varied, std::size_t index) {
  return fmt::format("{} {}", varied.value * (1.0 + 1e-3 * static_cast<double>(index)), varied.unit);
}

/// True if a run with this value keeps the plan and its numbers are finite for three ticks.
bool may_vary(const plan::Plan& plan, const Varied& varied) try {
  run::Executor run(plan);
  if (run.set(varied.name, text_of(varied, 7)) != run::Executor::Setting::done) return false;
  run.reset();
  for (int tick = 0; tick < 3 && run.healthy(); ++tick) {
    run.evaluate();
    run.advance();
  }
  return run.healthy();
} catch (const std::exception&) {
  return false;
}

std::string si_unit_of(const ParameterSpec& spec) {
  const auto unit = unit::parse_unit(spec.unit);
  return unit ? unit::si_name(unit->dimension) : "";
}

}  // namespace

std::vector<Varied> varied_of(const plan::Plan& plan) {
  std::vector<Varied> all;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks)
    for (const ParameterSpec& spec : block.type().parameters) {
      const Value value = spec.get ? spec.get(block.block.get()) : Value{};
      const double* number = std::get_if<double>(&value.content);
      if (number && *number != 0.0 && std::isfinite(*number))
        all.push_back({block.name + "." + spec.name, *number, si_unit_of(spec)});
    }
  std::vector<Varied> chosen;
  const std::size_t stride = std::max<std::size_t>(1, all.size() / (3 * most_varied));
  for (std::size_t i = 0; i < all.size() && chosen.size() < most_varied; i += stride)
    if (may_vary(plan, all[i])) chosen.push_back(all[i]);
  return chosen;
}

diagram::Variation variation_of(const plan::Plan& plan, const std::vector<Varied>& varied) {
  std::vector<std::string> names;
  for (const Varied& one : varied) names.push_back(one.name);
  return diagram::Variation(plan.diagram, names);
}

std::unique_ptr<run::Executor> run_of(const plan::Plan& plan, const std::vector<Varied>& varied,
                                      std::size_t index) {
  auto run = std::make_unique<run::Executor>(plan);
  for (const Varied& one : varied) static_cast<void>(run->set(one.name, text_of(one, index)));
  run->reset();
  return run;
}

void go_alone(run::Executor& run, std::vector<record::Recorder>& recorders) {
  run::Drive(run, recorders).run();
}

bool same_bits(const std::vector<record::Recording>& a, const std::vector<record::Recording>& b) {
  for (std::size_t r = 0; r < a.size(); ++r)
    for (std::size_t c = 0; c < a[r].table.columns.size(); ++c) {
      const auto &one = a[r].table.columns[c].values, &other = b[r].table.columns[c].values;
      if (one.size() != other.size() ||
          std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) != 0)
        return false;
    }
  return true;
}

plan::Plan short_plan(const run::Job& job) {
  plan::Plan plan = job.plan;
  plan.steps = std::min(plan.steps, most_ticks);
  for (diagram::RecordRequest& request : plan.diagram.records)
    if (request.every && *request.every > 8.0 * plan.diagram.step) request.every.reset();
  return plan;
}

}  // namespace stepwire
