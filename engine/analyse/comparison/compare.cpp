#include "engine/analyse/comparison/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/comparison/sampling.hpp"
#include "engine/base/text/count.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::comparison {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;  // accepted share of the largest value

/// Tolerance of one signal in numbers, in SI.
struct Limits {
  double absolute = 0.0, relative = 0.0, jitter = 0.0;
  bool hold = false;
};

double largest_of(const Trace& trace) {
  double largest = 0.0;
  for (const double value : trace.values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

/// True for whole numbers throughout, such as states, counts and truths.
bool is_whole(const Trace& trace) {
  return std::ranges::all_of(trace.values,
                             [](double value) { return std::isnan(value) || value == std::floor(value); });
}

/// Difference of two numbers; of a missing one infinite, of two 0.
double distance(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return 0.0;
  if (a == b) return 0.0;
  return std::isnan(a) || std::isnan(b) ? infinity : std::abs(a - b);
}

/// Distance of a number from the values of a window.
double distance(double a, const ValueRange& range) {
  if (std::isnan(a)) return range.has_missing ? 0.0 : infinity;
  if (range.empty()) return infinity;
  return std::max({0.0, a - range.high, range.low - a});
}

double last_step(const Trace& trace) {
  for (std::size_t row = trace.time.size(); row-- > 1;)
    if (trace.time[row] > trace.time[row - 1]) return trace.time[row] - trace.time[row - 1];
  return 0.0;
}

/// Comparison of a signal in one run. `a` gives the instants.
///
/// At an instant where both have two rows, the first is compared with the first and the last with the last.
/// A single row is the value after the instant, so it is compared with the last one.
class RunComparison {
 public:
  RunComparison(const Trace& a, const Trace& b, const Limits& limits)
      : a_(a),
        b_(b),
        limits_(limits),
        same_(same_instant(std::max(std::abs(a.time.back()), std::abs(b.time.back())))),
        of_b_(b, limits.hold, same_),
        of_a_(a, limits.hold, same_),
        scale_(std::max(largest_of(a), 0.0)),
        tolerance_(std::max(
            {limits.absolute, limits.relative * scale_, rounding * std::max(scale_, largest_of(b))})) {}

  SignalDifference compared() {
    found_.tolerance = tolerance_;
    compare_rows();
    if (limits_.jitter > 0.0) compare_backwards();
    compare_ends();
    found_.excess = found_.missing > 0 ? infinity : ratio(found_.difference);
    found_.agrees = found_.agrees && found_.differing == 0 && found_.missing == 0;
    if (scale_ > 0.0) found_.share = found_.difference / scale_;
    return found_;
  }

  /// Returns the value of B beside a row of A; std::nullopt for a row without a counterpart.
  std::optional<double> counterpart(std::size_t row) {
    const RowGroup of_a = of_a_.group(a_.time[row]), of_b = of_b_.group(a_.time[row]);
    if (of_b.size() == 0) {
      found_.method = limits_.hold ? Method::hold : Method::linear;
      return of_b_.between(a_.time[row], of_b);
    }
    if (of_a.size() == of_b.size()) return b_.values[of_b.begin + (row - of_a.begin)];
    if (row + 1 == of_a.end) return b_.values[of_b.end - 1];
    if (row == of_a.begin && of_b.size() > 1) return b_.values[of_b.begin];
    return std::nullopt;
  }

  bool is_common(double time) const {
    return time >= b_.time.front() - same_ && time <= b_.time.back() + same_;
  }

 private:
  double ratio(double difference) const {
    return difference == 0.0 ? 0.0 : tolerance_ > 0.0 ? difference / tolerance_ : infinity;
  }

  void compare_rows() {
    for (std::size_t row = 0; row < a_.time.size(); ++row) {
      if (!is_common(a_.time[row])) continue;
      const std::optional<double> b = counterpart(row);
      if (!b) {
        ++found_.unpaired;
        continue;
      }
      ++found_.rows;
      take(a_.time[row], a_.values[row], *b, of_b_, false);
    }
  }

  /// Compares the rows of B with the windows of A, so that a short pulse of B alone is found.
  void compare_backwards() {
    if (a_.time.size() < b_.time.size()) {
      found_.notes.push_back("rows of B between those of A are not compared");
      return;
    }
    for (std::size_t row = 0; row < b_.time.size(); ++row) {
      const double time = b_.time[row];
      if (time < a_.time.front() - same_ || time > a_.time.back() + same_) continue;
      const RowGroup at = of_a_.group(time);
      take(time, b_.values[row], at.size() > 0 ? a_.values[at.end - 1] : of_a_.between(time, at), of_a_,
           true);
    }
  }

  /// Adds the difference of a value from that of the other trace, or from the nearest within the jitter.
  void take(double time, double value, double other, const Sampling& others, bool backwards) {
    double difference = distance(value, other), nearest = other;
    const bool is_worse = difference > found_.difference || difference > tolerance_;
    if (is_worse && limits_.jitter > 0.0) {
      const ValueRange near = others.range(time - limits_.jitter, time + limits_.jitter);
      difference = distance(value, near);
      if (!near.empty() && !std::isnan(value)) nearest = std::clamp(value, near.low, near.high);
    }
    if (difference > tolerance_) ++found_.differing;
    const bool missing = std::isnan(value) != std::isnan(other) && difference == infinity;
    if (missing) ++found_.missing;
    if (missing ? found_.missing > 1 : found_.missing > 0 || difference <= found_.difference) return;
    if (!missing) found_.difference = difference;
    found_.time = time;
    found_.a = backwards ? nearest : value;
    found_.b = backwards ? value : nearest;
  }

  void compare_ends() {
    const double a = a_.time.front(), b = b_.time.front();
    compare_end("begins", a, b, a > b ? a_ : b_);
    compare_end("ends", a_.time.back(), b_.time.back(), a_.time.back() < b_.time.back() ? a_ : b_);
    if (found_.rows > 0) return;
    found_.notes.push_back("A and B have no time in common");
    found_.agrees = false;
  }

  /// Compares two ends. At another rate the shorter trace may lack less than one of its steps.
  void compare_end(const char* verb, double a, double b, const Trace& shorter) {
    const double step_a = last_step(a_), step_b = last_step(b_);
    const bool same_rate = std::abs(step_a - step_b) <= 1e-6 * std::max(step_a, step_b);
    const double gap = std::abs(a - b) - same_ - limits_.jitter;
    if (gap <= 0.0 || (!same_rate && gap < last_step(shorter) - same_)) return;
    found_.notes.push_back(fmt::format("{} at {:.6g} s in A and at {:.6g} s in B", verb, a, b));
    found_.agrees = false;
  }

  const Trace &a_, &b_;
  const Limits limits_;
  const double same_;
  const Sampling of_b_, of_a_;
  const double scale_, tolerance_;
  SignalDifference found_;
};

/// Returns why two units cannot be compared; empty if they can.
std::string fault_of_units(const std::string& name, const std::string& a, const std::string& b) {
  if (a == b) return "";
  const auto of_a = unit::parse_unit(a), of_b = unit::parse_unit(b);
  const std::string& lone = a.empty() ? b : a;
  const auto unit = a.empty() ? of_b : of_a;
  const bool is_number = unit && unit->dimension == unit::Dimension{} && unit->scale == 1.0L;
  if ((a.empty() || b.empty()) && !is_number)
    return fmt::format(
        "'{0}' is in {1} in {2} and has no unit in {3}; write '{0} [{1}]' in the header of {3}", name, lone,
        a.empty() ? "B" : "A", a.empty() ? "A" : "B");
  if (!of_a || !of_b || of_a->dimension != of_b->dimension)
    return fmt::format("'{}' is in {} in A and in {} in B, which cannot be converted", name, a, b);
  const std::string other = unit::other_meaning(of_b->dimension, of_a->dimension);
  return other.empty() ? "" : fmt::format("'{}' in {} in A, in {} in B: {}", name, a, b, other);
}

/// Returns why a tolerance does not fit a signal; empty if it does.
std::string fault_of_tolerance(const std::string& name, const std::string& unit, const Tolerance& tolerance) {
  const auto known = unit::parse_unit(unit);
  const bool is_bare = unit.empty() || !known;
  if (tolerance.relative && known && known->offset != 0.0L)
    return fmt::format("a share of '{}' in {} is one of its kelvins; give an absolute tolerance in K", name,
                       unit);
  if (!tolerance.absolute || (is_bare && !tolerance.unit)) return "";
  if (is_bare && *tolerance.unit != unit::Dimension{})
    return fmt::format("'{}' has no known unit, and its tolerance is {}; write a number without unit", name,
                       tolerance.absolute_text);
  if (is_bare) return "";
  if (!tolerance.unit && *tolerance.absolute == 0.0) return "";
  if (!tolerance.unit && (known->scale != 1.0L || known->dimension != unit::Dimension{}))
    return fmt::format("'{0}' is in {2}, and its tolerance {1} has no unit; write {1} {2}", name,
                       tolerance.absolute_text, unit);
  if (tolerance.unit && *tolerance.unit != known->dimension)
    return fmt::format("'{}' is in {}, and its tolerance is {}", name, unit, tolerance.absolute_text);
  return "";
}

Limits limits_of(const Tolerance& tolerance, const Trace& a, const Trace& b, const std::string& unit) {
  const bool may_hold = unit.empty() || unit == "1";
  return {tolerance.absolute.value_or(0.0), tolerance.relative.value_or(0.0), tolerance.jitter.value_or(0.0),
          tolerance.hold.value_or(may_hold && is_whole(a) && is_whole(b))};
}

/// Converts differences from SI to a unit; the zero of a temperature does not count.
double difference_in(const std::string& name, double difference) {
  const auto unit = unit::parse_unit(name);
  return name.empty() || !unit ? difference : static_cast<double>(difference / unit->scale);
}

double value_in(const std::string& name, double value) {
  const auto unit = unit::parse_unit(name);
  return name.empty() || !unit ? value : unit->from_si(value);
}

/// Adds the difference of a further run: counts are added, the worst run is shown.
void join(SignalDifference& all, SignalDifference run) {
  const bool is_worse = all.rows == 0 || run.excess > all.excess ||
                        (run.excess == all.excess && run.difference > all.difference);
  run.agrees = run.agrees && all.agrees;
  run.rows += all.rows;
  run.differing += all.differing;
  run.missing += all.missing;
  run.unpaired += all.unpaired;
  run.method = std::max(run.method, all.method);
  for (const std::string& note : all.notes)
    if (std::ranges::find(run.notes, note) == run.notes.end()) run.notes.push_back(note);
  if (!is_worse) {
    run.difference = all.difference;
    run.share = all.share;
    run.time = all.time;
    run.run = all.run;
    run.a = all.a;
    run.b = all.b;
    run.tolerance = all.tolerance;
    run.excess = all.excess;
  }
  all = std::move(run);
}

SignalDifference compare_signal(const TraceIndex& a, const TraceIndex& b, const std::string& name,
                                const Tolerance& tolerance) {
  SignalDifference all;
  for (std::size_t run = 0; run < std::min(a.runs(name), b.runs(name)); ++run) {
    const Trace of_a = a.trace(name, run), of_b = b.trace(name, run);
    if (of_a.time.empty() || of_b.time.empty()) {
      all.agrees = all.agrees && of_a.time.empty() == of_b.time.empty();
      if (!all.agrees) all.notes.push_back(fmt::format("run {} has no row on one side", run + 1));
      continue;
    }
    SignalDifference found =
        RunComparison(of_a, of_b, limits_of(tolerance, of_a, of_b, a.unit(name))).compared();
    found.run = run;
    join(all, std::move(found));
  }
  all.name = name;
  all.unit = a.unit(name).empty() ? b.unit(name) : a.unit(name);
  if (a.runs(name) != b.runs(name)) {
    all.notes.push_back(fmt::format("A has {} and B {}", text::counted(a.runs(name), "run"), b.runs(name)));
    all.agrees = false;
  }
  all.difference = difference_in(all.unit, all.difference);
  all.tolerance = difference_in(all.unit, all.tolerance);
  all.a = value_in(all.unit, all.a);
  all.b = value_in(all.unit, all.b);
  return all;
}

/// Adds the faults of the common signals, and the names that one side alone has.
void check_signals(const TraceIndex& a, const TraceIndex& b, const Tolerances& tolerances,
                   RecordingDifference& found) {
  for (const std::string& name : a.names()) {
    if (!tolerances.includes(name)) continue;
    if (!b.has(name)) {
      found.only_in_a.push_back(name);
      continue;
    }
    const std::string units = fault_of_units(name, a.unit(name), b.unit(name));
    const std::string fault =
        units.empty() ? fault_of_tolerance(name, a.unit(name), tolerances.of(name)) : units;
    if (!fault.empty()) found.faults.push_back(fault);
  }
  for (const std::string& name : b.names())
    if (tolerances.includes(name) && !a.has(name)) found.only_in_b.push_back(name);
}

/// Adds a fault for each pattern that no signal matches: its tolerance would have no effect.
void check_patterns(const TraceIndex& a, const TraceIndex& b, const Tolerances& tolerances,
                    RecordingDifference& found) {
  const auto check = [&](const std::string& pattern) {
    const auto is_met = [&](const std::string& name) { return matches(pattern, name); };
    if (pattern == "*" || std::ranges::any_of(a.names(), is_met) || std::ranges::any_of(b.names(), is_met))
      return;
    found.faults.push_back(
        fmt::format("no signal has the name '{}'; those of A are {}", pattern, fmt::join(a.names(), ", ")));
  };
  for (const ToleranceRule& rule : tolerances.rules) check(rule.signals);
  for (const std::string& pattern : tolerances.only) check(pattern);
}

}  // namespace

const char* method_name(Method method) {
  return method == Method::rows ? "rows" : method == Method::linear ? "linear" : "hold";
}

RecordingDifference compare(Tables a, Tables b, const Tolerances& tolerances) {
  RecordingDifference found;
  const TraceIndex of_a(a, found.faults), of_b(b, found.faults);
  check_signals(of_a, of_b, tolerances, found);
  check_patterns(of_a, of_b, tolerances, found);
  if (!found.faults.empty()) {
    found.agrees = false;
    return found;
  }
  for (const std::string& name : of_a.names())
    if (tolerances.includes(name) && of_b.has(name))
      found.signals.push_back(compare_signal(of_a, of_b, name, tolerances.of(name)));
  if (found.signals.empty()) found.faults.push_back("A and B have no signal in common");
  std::ranges::stable_sort(found.signals, [](const SignalDifference& one, const SignalDifference& other) {
    return one.agrees != other.agrees ? other.agrees : one.excess > other.excess;
  });
  found.agrees = found.faults.empty() && found.only_in_a.empty() && found.only_in_b.empty() &&
                 std::ranges::all_of(found.signals, &SignalDifference::agrees);
  return found;
}

DifferenceCurves curves_of(Tables a, Tables b, const SignalDifference& signal, const Tolerances& tolerances) {
  std::vector<std::string> faults;
  const TraceIndex of_a(a, faults), of_b(b, faults);
  const Trace first = of_a.trace(signal.name, signal.run), second = of_b.trace(signal.name, signal.run);
  DifferenceCurves curves;
  if (first.time.empty() || second.time.empty()) return curves;
  RunComparison run(first, second,
                    limits_of(tolerances.of(signal.name), first, second, of_a.unit(signal.name)));
  for (std::size_t row = 0; row < first.time.size(); ++row) {
    const std::optional<double> other = run.is_common(first.time[row]) ? run.counterpart(row) : std::nullopt;
    if (!other) continue;
    curves.time.push_back(first.time[row]);
    curves.a.push_back(value_in(signal.unit, first.values[row]));
    curves.b.push_back(value_in(signal.unit, *other));
    curves.difference.push_back(difference_in(signal.unit, first.values[row] - *other));
  }
  return curves;
}

}  // namespace stepwire::comparison
