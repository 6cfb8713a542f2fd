#include "engine/identify/shared_code.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "engine/run/simulation.hpp"

namespace stepwire {

namespace {

constexpr double probe_step = 0.01;  // of the scale

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// One plan, and at what values.
struct Point {
  std::size_t record;
  Values values;
  Plan plan;
};

/// Plans around the start, whose numbers show how they move with the parameters.
class Probing {
 public:
  Probing(const std::vector<Plan>& at_start, const std::vector<FitParameter>& parameters, const Planner& plan,
          CodeSource& source)
      : at_start_(at_start),
        parameters_(parameters),
        start_(start_of(parameters)),
        plan_(plan),
        source_(source),
        probed_by_(at_start.size(), 0) {}

  SharedCode code() {
    std::vector<RecordCode> records = codes();
    if (!records.empty() || compiled_.empty()) return {std::move(records), std::nullopt};
    return {{}, PlannedCode(compiled_)};
  }

 private:
  std::vector<RecordCode> codes() {
    add_probes(0);
    for (std::size_t record = 0; record < at_start_.size(); ++record) add_check(record);
    add_far_checks();
    std::vector<RecordCode> codes = compile();
    const std::vector<std::size_t> wrong = disagreeing(codes);
    for (std::size_t record : wrong) {
      if (record == 0) return {};
      probed_by_[record] = record;  // its numbers move otherwise than those of the first
      add_probes(record);
    }
    if (!wrong.empty()) codes = compile();
    return disagreeing(codes).empty() ? std::move(codes) : std::vector<RecordCode>{};
  }

  /// A plan with one parameter changed, into the direction that its bounds and the diagram allow.
  void add_probes(std::size_t record) {
    for (std::size_t j = 0; j < parameters_.size(); ++j) {
      const FitParameter& parameter = parameters_[j];
      const double step = probe_step * parameter.scale;
      const double first = parameter.start + step <= parameter.upper ? step : -step;
      Values values = start_;
      values[j] += first;
      if (add(probes_, record, values)) continue;
      values[j] = parameter.start - first;
      probes_.push_back({record, values, plan_(record, values)});
    }
  }

  bool add(std::vector<Point>& points, std::size_t record, const Values& values) {
    try {
      points.push_back({record, values, plan_(record, values)});
      return true;
    } catch (const Error&) {
      return false;  // blocks may refuse some values, e.g. a friction that pushes
    }
  }

  /// All parameters changed together, each by another part of its probe.
  void add_check(std::size_t record) {
    Values values = start_;
    for (std::size_t j = 0; j < values.size(); ++j)
      values[j] += (0.3 + 0.5 * part(j)) * (probes_[j].values[j] - start_[j]);
    add(checks_, record, values);
  }

  /// Far from the start, where a straight line through near points shows most.
  void add_far_checks() {
    for (const double share : {0.1, 0.9}) {
      Values values = start_;
      for (std::size_t j = 0; j < values.size(); ++j) {
        const FitParameter& parameter = parameters_[j];
        const double mix = share + 0.1 * (part(j) - 0.5);
        if (parameter.bounded()) values[j] = parameter.lower + mix * (parameter.upper - parameter.lower);
      }
      add(checks_, 0, values);
    }
  }

  /// 0 to 1, another for each.
  static double part(std::size_t j) {
    const double golden = 0.6180339887498949 * static_cast<double>(j + 1);
    return golden - static_cast<double>(static_cast<long>(golden));
  }

  std::vector<RecordCode> compile() {
    std::vector<const Plan*> plans;
    for (const Plan& plan : at_start_) plans.push_back(&plan);
    for (const auto* points : {&probes_, &checks_})
      for (const Point& point : *points) plans.push_back(&point.plan);
    compiled_ = source_.compile(plans, {});
    const auto other = [&](const CompiledPlan& one) {
      return one.functions.evaluate != compiled_.front().functions.evaluate;
    };
    if (compiled_.size() != plans.size() || std::ranges::any_of(compiled_, other)) {
      compiled_.clear();
      return {};
    }
    starts_.clear();
    for (const Plan* plan : plans) starts_.push_back(Simulation(*plan).workspace().values);
    std::vector<RecordCode> codes;
    for (std::size_t record = 0; record < at_start_.size(); ++record) codes.push_back(code_of(record));
    return codes;
  }

  RecordCode code_of(std::size_t record) const {
    std::vector<AffineNumbers::Probe> parameters, workspace;
    const std::size_t from = probed_by_[record];
    for (std::size_t i = 0; i < probes_.size(); ++i) {
      if (probes_[i].record != from) continue;
      const std::size_t j = parameters.size();
      const double change = probes_[i].values[j] - start_[j];
      parameters.push_back({change, compiled_[at_start_.size() + i].parameters});
      workspace.push_back({change, starts_[at_start_.size() + i]});
    }
    return {compiled_.front().functions,
            AffineNumbers(start_, compiled_[record].parameters, compiled_[from].parameters, parameters),
            AffineNumbers(start_, starts_[record], starts_[from], workspace)};
  }

  std::vector<std::size_t> disagreeing(const std::vector<RecordCode>& codes) const {
    std::vector<std::size_t> wrong;
    const std::size_t first = at_start_.size() + probes_.size();
    for (std::size_t i = 0; i < checks_.size(); ++i) {
      const Point& check = checks_[i];
      if (codes.empty() ||
          !codes[check.record].agrees(check.values, compiled_[first + i], starts_[first + i]))
        wrong.push_back(check.record);
    }
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
    return wrong;
  }

  const std::vector<Plan>& at_start_;
  const std::vector<FitParameter>& parameters_;
  Values start_;
  const Planner& plan_;
  CodeSource& source_;
  std::vector<std::size_t> probed_by_;  ///< whose probes tell how a record's numbers move
  std::vector<Point> probes_, checks_;
  std::vector<CompiledPlan> compiled_;
  std::vector<std::vector<double>> starts_;  ///< workspaces, parallel to compiled_
};

}  // namespace

bool RecordCode::agrees(const Values& values, const CompiledPlan& code,
                        const std::vector<double>& workspace) const {
  return parameters_.agrees(values, code.parameters) && workspace_.agrees(values, workspace);
}

PlannedCode::PlannedCode(const std::vector<CompiledPlan>& compiled)
    : functions_(compiled.front().functions),
      numbers_(compiled.front().parameters),
      varies_(numbers_.size(), 0) {
  for (const CompiledPlan& other : compiled)
    for (std::size_t i = 0; i < std::min(numbers_.size(), other.parameters.size()); ++i)
      if (!same_bits(numbers_[i], other.parameters[i])) varies_[i] = 1;
}

std::optional<CompiledPlan> PlannedCode::with(std::vector<double> numbers) const {
  if (numbers.size() != numbers_.size()) return std::nullopt;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!varies_[i] && !same_bits(numbers[i], numbers_[i])) return std::nullopt;
  return CompiledPlan{functions_, std::move(numbers)};
}

SharedCode share_code(const std::vector<Plan>& at_start, const std::vector<FitParameter>& parameters,
                      const Planner& plan, CodeSource& source) {
  return Probing(at_start, parameters, plan, source).code();
}

}  // namespace stepwire
