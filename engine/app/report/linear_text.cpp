#include "engine/app/report/linear_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analyse/query/number.hpp"
#include "engine/base/text/count.hpp"
#include "engine/base/text/text_table.hpp"

namespace stepwire::report {
namespace {

using linear::Complex;
using query::short_number;

constexpr Eigen::Index most_printed = 12;
constexpr std::size_t most_crossings = 8;
constexpr std::size_t most_singular_values = 8;

std::string complex_text(const Complex& number) {
  if (number.imag() == 0.0) return short_number(number.real(), 6);
  return fmt::format("{} {} {}j", short_number(number.real(), 6), number.imag() < 0.0 ? "-" : "+",
                     short_number(std::abs(number.imag()), 6));
}

/// A line of text, and how often it occurs.
template <class Line>
struct Repeated {
  Line line;
  std::size_t times = 1;
};

/// Returns the lines without repetitions, in the order of their first occurrence.
template <class Line>
std::vector<Repeated<Line>> counted(const std::vector<Line>& lines) {
  std::vector<Repeated<Line>> all;
  for (const Line& line : lines) {
    const auto same = std::ranges::find(all, line, &Repeated<Line>::line);
    if (same == all.end())
      all.push_back({line});
    else
      ++same->times;
  }
  return all;
}

std::string times_text(std::size_t times) {
  return times == 1 ? "" : fmt::format(" ({} times)", times);
}

std::string list_text(const std::vector<Complex>& numbers) {
  std::vector<std::string> all, texts;
  for (const Complex& number : numbers) all.push_back(complex_text(number));
  for (const auto& [text, times] : counted(all)) texts.push_back(text + times_text(times));
  return texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, ", "));
}

std::string with_unit(const linear::Channel& channel) {
  return channel.unit.empty() ? channel.name : fmt::format("{} [{}]", channel.name, channel.unit);
}

std::string matrix_text(const char* name, const Eigen::MatrixXd& matrix,
                        const std::vector<linear::Channel>& rows,
                        const std::vector<linear::Channel>& columns) {
  if (matrix.size() == 0 || matrix.rows() > most_printed || matrix.cols() > most_printed) return {};
  text::TextTable table;
  table.columns.push_back(name);
  for (const linear::Channel& column : columns) table.columns.push_back(with_unit(column));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    table.rows.push_back({with_unit(rows[static_cast<std::size_t>(i)])});
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      table.rows.back().push_back(short_number(matrix(i, j), 6));
  }
  return text::text(table) + "\n";
}

std::string stability_text(const linear::Stability& stability) {
  if (stability.stable) return "stable";
  if (!stability.known) return "stability not determined";
  if (!stability.hidden) return "not stable";
  return fmt::format("not stable: {} grows, which is not on the way from input to output",
                     complex_text(*stability.hidden));
}

std::string modes_text(const linear::Analysis& analysis) {
  std::vector<std::vector<std::string>> all;
  for (const linear::Mode& mode : analysis.modes)
    all.push_back(
        {complex_text(mode.pole), short_number(mode.frequency, 6) + " rad/s", short_number(mode.damping, 4)});
  text::TextTable table;
  table.columns = {"pole", "natural frequency", "damping"};
  for (auto& [row, times] : counted(all)) {
    row[0] += times_text(times);
    table.rows.push_back(std::move(row));
  }
  return text::text(table) + fmt::format("  {}\n", stability_text(analysis.stability));
}

double decibels(double factor) {
  return 20.0 * std::log10(factor);
}

double degrees(double angle) {
  return angle * 180.0 / std::numbers::pi;
}

std::string crossings_text(const linear::Margins& margins) {
  std::string text;
  for (std::size_t i = 0; i < std::min(margins.gain.size(), most_crossings); ++i)
    text += fmt::format("  gain margin {} dB (factor {}) at {} rad/s\n",
                        short_number(decibels(margins.gain[i].margin), 6),
                        short_number(margins.gain[i].margin, 6), short_number(margins.gain[i].frequency, 6));
  if (margins.gain.size() > most_crossings)
    text += fmt::format(
        "  and {} more, up to {} dB\n", margins.gain.size() - most_crossings,
        short_number(decibels(std::ranges::max(margins.gain, {}, &linear::Crossing::margin).margin), 6));
  if (margins.gain_left_out > 0)
    text += fmt::format("  {} crossings more are not listed\n", margins.gain_left_out);
  if (std::isfinite(margins.gain_up_to))
    text += fmt::format("  the delay turns on: crossings beyond {} rad/s are not listed\n",
                        short_number(margins.gain_up_to, 6));
  for (const linear::Crossing& crossing : margins.phase)
    text += fmt::format("  phase margin {} deg at {} rad/s\n", short_number(degrees(crossing.margin), 6),
                        short_number(crossing.frequency, 6));
  if (margins.gain.empty() && margins.knows_gain)
    text += "  no gain margin: the loop is nowhere real and negative\n";
  if (margins.phase.empty() && margins.knows_phase) text += "  no phase margin: its gain is nowhere 1\n";
  return text;
}

std::string margins_text(const linear::Margins& margins, double feedback) {
  std::string text = fmt::format("  closed by u = {}y: {}\n", feedback < 0.0 ? "-" : "",
                                 stability_text({margins.stable, margins.knows_stability, margins.hidden})) +
                     crossings_text(margins);
  if (std::isfinite(margins.delay()))
    text += fmt::format("  delay margin {} s\n", short_number(margins.delay(), 6));
  if (margins.knows_modulus)
    text += fmt::format("  modulus margin {} at {} rad/s\n", short_number(margins.modulus, 6),
                        short_number(margins.modulus_frequency, 6));
  for (const std::string& note : margins.notes) text += fmt::format("  not determined: {}\n", note);
  return text;
}

std::string zeros_text(const linear::Analysis& analysis, const std::vector<Complex>& zeros) {
  return analysis.system.delays.empty() ? list_text(zeros) : "not found with delays";
}

std::string channel_text(const linear::ChannelAnalysis& channel, const linear::Analysis& analysis) {
  return fmt::format("{} -> {}: zeros {}; gain at rest {}; bandwidth {} rad/s\n", channel.input,
                     channel.output, zeros_text(analysis, channel.zeros),
                     short_number(channel.gain_at_rest, 6), short_number(channel.bandwidth, 6)) +
         margins_text(channel.margins, analysis.feedback);
}

std::string rank_text(const char* what, const linear::Rank& rank, std::size_t states) {
  std::vector<std::string> values;
  for (const double value : rank.singular_values)
    if (values.size() < most_singular_values) values.push_back(short_number(value, 3));
  const std::size_t others = rank.singular_values.size() - values.size();
  return fmt::format("{} of {} {} {} (singular values {}{}){}\n", text::counted(rank.rank, "state"), states,
                     rank.rank == 1 ? "is" : "are", what, fmt::join(values, ", "),
                     others == 0 ? "" : fmt::format(" and {} others", others),
                     rank.certain ? "" : "; not certain: a direction is close to rounding");
}

void add_rows(const char* kind, const std::vector<linear::TrimmedValue>& values, text::TextTable& table) {
  for (const linear::TrimmedValue& value : values) {
    const std::string unit = value.channel.unit.empty() ? "" : " " + value.channel.unit;
    const char* how = value.at_bound ? "at its bound" : value.free ? "found" : "given";
    table.rows.push_back({kind, value.channel.name, query::short_number(value.value, 8) + unit, how,
                          value.setting.empty() ? "-" : value.setting});
  }
}

}  // namespace

std::string linear_text(const linear::Analysis& analysis) {
  const linear::StateSpace& system = analysis.system;
  std::string text =
      fmt::format("{} at {} s: {}, {}, {}, {}\n{}\n\n", analysis.file, short_number(analysis.time, 6),
                  text::counted(system.states.size(), "state"), text::counted(system.inputs.size(), "input"),
                  text::counted(system.outputs.size(), "output"),
                  system.is_sampled() ? fmt::format("sampled at {} s", short_number(system.sample_time, 6))
                                      : "continuous",
                  analysis.method);
  text += matrix_text("A", system.A, system.states, system.states) +
          matrix_text("B", system.B, system.states, system.all_inputs()) +
          matrix_text("C", system.C, system.all_outputs(), system.states) +
          matrix_text("D", system.D, system.all_outputs(), system.all_inputs());
  for (const linear::InnerDelay& delay : system.delays)
    text += fmt::format("{} comes in as {} after {} s\n", delay.out.name, delay.in.name,
                        short_number(delay.time, 6));
  if (!analysis.modes.empty()) text += modes_text(analysis);
  text += fmt::format("zeros: {}\n\n", zeros_text(analysis, analysis.zeros));
  for (const linear::ChannelAnalysis& channel : analysis.channels) text += channel_text(channel, analysis);
  if (!system.states.empty() && system.delays.empty())
    text += "\n" + rank_text("controllable", analysis.controllable, system.states.size()) +
            rank_text("observable", analysis.observable, system.states.size());
  for (const std::string& note : analysis.notes) text += fmt::format("note: {}\n", note);
  return text;
}

std::string trim_text(const linear::TrimResult& result) {
  text::TextTable table;
  table.columns = {"", "name", "value", "", "set by"};
  add_rows("state", result.states, table);
  add_rows("input", result.inputs, table);
  add_rows("output", result.outputs, table);
  std::string text = fmt::format(
      "{}: {} after {}, largest residual {}\n\n{}", result.file, result.converged ? "found" : "NOT found",
      text::counted(result.iterations, "step"), query::short_number(result.largest, 3), text::text(table));
  if (result.undetermined > 0)
    text += fmt::format(
        "note: the point is one of many, since the conditions leave {} open; fix one, or give an output\n",
        text::counted(result.undetermined, "free number"));
  if (result.converged) return text;
  for (const auto& [channel, value] : result.residuals)
    text += fmt::format("  {} is off by {}\n", channel.name, query::short_number(value, 4));
  return text;
}

}  // namespace stepwire::report
