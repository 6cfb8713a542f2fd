#include "engine/analyse/linear/columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/analyse/linear/step_response.hpp"

namespace stepwire::linear {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// An analysis with its curves.
struct Found {
  const Analysis& analysis;
  const StateSpace& system;  ///< System of its single channel.
  std::vector<double> frequencies;
  std::vector<Complex> loop;  ///< L, whose margins are given, at these frequencies.
  ResponseCurve step;
  RootLocus locus;

  const ChannelAnalysis& channel() const { return analysis.channels.front(); }
  const Margins& margins() const { return channel().margins; }
};

/// A column of an analysis: suffix of its name, unit, and function of its numbers.
struct Column {
  enum class Unit { ratio, radian, per_second, second, own, place };  ///< place: of a pole or zero
  const char* name;
  Unit unit = Unit::ratio;
  std::vector<double> (*numbers)(const Found& found);
};

/// Returns a number of each element of a list of poles, zeros or modes.
template <class List, class Number>
std::vector<double> each(const List& list, Number number) {
  std::vector<double> numbers;
  for (const auto& item : list) numbers.push_back(number(item));
  return numbers;
}

double real(const Complex& number) {
  return number.real();
}
double imaginary(const Complex& number) {
  return number.imag();
}

Found found_of(const Analysis& analysis, const StateSpace& system) {
  constexpr std::size_t most_of_locus = 40;  // limit of the number of states
  const FrequencyResponse response(system);
  Found found{analysis, system, response.frequencies(60), {}, step_response(system), {}};
  for (const double w : found.frequencies) found.loop.push_back(-analysis.feedback * response.at(w));
  if (system.states.size() <= most_of_locus) found.locus = root_locus(system, analysis.feedback);
  return found;
}

/// Returns the phase without jumps; it begins between -270 and 90 degrees.
std::vector<double> phase_of(const std::vector<Complex>& loop) {
  std::vector<double> phase;
  for (const Complex& value : loop) {
    const double angle = std::arg(value), turn = 2.0 * std::numbers::pi;
    const double before = phase.empty() ? -0.5 * std::numbers::pi : phase.back();
    phase.push_back(angle + turn * std::round((before - angle) / turn));
  }
  return phase;
}

/// Returns the frequency of a crossing; nan without one, or if its margin could not be determined.
double frequency_of(const std::optional<Crossing>& crossing, double margin) {
  return crossing && !std::isnan(margin) ? crossing->frequency : none;
}

/// Returns a number of the least damped mode. In a stable system, poles at rest do not count.
std::vector<double> least_damped(const Analysis& analysis, double Mode::*number) {
  double largest = 0.0;
  for (const Mode& mode : analysis.modes) largest = std::max(largest, std::abs(mode.pole));
  const Mode* least = nullptr;
  for (const Mode& mode : analysis.modes)
    if (!analysis.stability.stable || decays(analysis.system, mode.pole, largest))
      if (!least || mode.damping < least->damping) least = &mode;
  return {least ? least->*number : none};
}

using Unit = Column::Unit;

// In the order of the page.
const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      {"", Unit::ratio, [](const Found&) { return std::vector<double>{1.0}; }},
      {".margin.gain", Unit::ratio, [](const Found& f) { return std::vector{f.margins().gain_margin()}; }},
      {".margin.gain_db", Unit::ratio,
       [](const Found& f) { return std::vector{20.0 * std::log10(f.margins().gain_margin())}; }},
      {".margin.gain_frequency", Unit::per_second,
       [](const Found& f) {
         return std::vector{frequency_of(f.margins().worst_gain(), f.margins().gain_margin())};
       }},
      {".margin.phase", Unit::radian, [](const Found& f) { return std::vector{f.margins().phase_margin()}; }},
      {".margin.phase_frequency", Unit::per_second,
       [](const Found& f) {
         return std::vector{frequency_of(f.margins().worst_phase(), f.margins().phase_margin())};
       }},
      {".margin.delay", Unit::second, [](const Found& f) { return std::vector{f.margins().delay()}; }},
      {".margin.modulus", Unit::ratio,
       [](const Found& f) { return std::vector{f.margins().modulus_margin()}; }},
      {".stable", Unit::ratio,
       [](const Found& f) {
         return std::vector{!f.margins().knows_stability ? none : f.margins().stable ? 1.0 : 0.0};
       }},
      {".bandwidth", Unit::per_second, [](const Found& f) { return std::vector{f.channel().bandwidth}; }},
      {".gain_at_rest", Unit::own, [](const Found& f) { return std::vector{f.channel().gain_at_rest}; }},
      {".damping", Unit::ratio, [](const Found& f) { return least_damped(f.analysis, &Mode::damping); }},
      {".natural_frequency", Unit::per_second,
       [](const Found& f) { return least_damped(f.analysis, &Mode::frequency); }},
      {".sample_time", Unit::second, [](const Found& f) { return std::vector{f.system.sample_time}; }},
      {".frequency", Unit::per_second, [](const Found& f) { return f.frequencies; }},
      {".gain", Unit::own,
       [](const Found& f) { return each(f.loop, [](const Complex& value) { return std::abs(value); }); }},
      {".phase", Unit::radian, [](const Found& f) { return phase_of(f.loop); }},
      {".real", Unit::own, [](const Found& f) { return each(f.loop, real); }},
      {".imaginary", Unit::own, [](const Found& f) { return each(f.loop, imaginary); }},
      {".pole.real", Unit::place,
       [](const Found& f) {
         return each(f.analysis.modes, [](const Mode& mode) { return mode.pole.real(); });
       }},
      {".pole.imaginary", Unit::place,
       [](const Found& f) {
         return each(f.analysis.modes, [](const Mode& mode) { return mode.pole.imag(); });
       }},
      {".pole.damping", Unit::ratio,
       [](const Found& f) { return each(f.analysis.modes, [](const Mode& mode) { return mode.damping; }); }},
      {".pole.frequency", Unit::per_second,
       [](const Found& f) {
         return each(f.analysis.modes, [](const Mode& mode) { return mode.frequency; });
       }},
      {".zero.real", Unit::place, [](const Found& f) { return each(f.channel().zeros, real); }},
      {".zero.imaginary", Unit::place, [](const Found& f) { return each(f.channel().zeros, imaginary); }},
      {".closed_pole.real", Unit::place, [](const Found& f) { return each(f.margins().closed_poles, real); }},
      {".closed_pole.imaginary", Unit::place,
       [](const Found& f) { return each(f.margins().closed_poles, imaginary); }},
      {".step.time", Unit::second, [](const Found& f) { return f.step.x; }},
      {".step.response", Unit::own, [](const Found& f) { return f.step.y; }},
      {".locus.gain", Unit::ratio, [](const Found& f) { return f.locus.gain; }},
      {".locus.real", Unit::place, [](const Found& f) { return f.locus.real; }},
      {".locus.imaginary", Unit::place, [](const Found& f) { return f.locus.imaginary; }},
      {".locus.branch", Unit::ratio, [](const Found& f) { return f.locus.branch; }}};
  return all;
}

std::optional<unit::Dimension> dimension_of(const Column& column, const NamedAnalysis& analysis) {
  const unit::Dimension second = unit::parse_unit("s")->dimension;
  switch (column.unit) {
    case Unit::per_second:
      return unit::Dimension{} / second;
    case Unit::second:
      return second;
    case Unit::own:
      return analysis.dimension;
    case Unit::radian:
      return unit::parse_unit("rad")->dimension;
    case Unit::place:
      if (analysis.is_sampled) return std::nullopt;
      return unit::Dimension{} / second;
    case Unit::ratio:
      break;
  }
  return unit::Dimension{};
}

}  // namespace

std::vector<query::RecordedName> analysis_names(const NamedAnalysis& analysis, std::size_t recording) {
  std::vector<query::RecordedName> names;
  for (const Column& column : columns()) {
    names.push_back({analysis.name + column.name, dimension_of(column, analysis), recording});
    names.back().is_ratio = column.unit == Unit::ratio;
  }
  return names;
}

record::Recording analysis_recording(const NamedAnalysis& named, const Analysis& analysis) {
  const StateSpace system = analysis.system.channel(0, 0).connected();
  const Found found = found_of(analysis, system);
  record::Recording recording;
  recording.table.columns.push_back({"time", "s", found.step.x});
  std::size_t rows = recording.table.rows();
  for (const Column& column : columns()) {
    const auto dimension = dimension_of(column, named);
    recording.table.columns.push_back(
        {named.name + column.name, dimension ? unit::si_name(*dimension) : "", column.numbers(found)});
    rows = std::max(rows, recording.table.columns.back().values.size());
  }
  for (table::Column& column : recording.table.columns)
    column.values.resize(rows, column.values.empty() ? none : column.values.back());
  return recording;
}

}  // namespace stepwire::linear
