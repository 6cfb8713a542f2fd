#include "tests/diagrams/broken/signals.hpp"

#include <algorithm>
#include <set>

namespace stepwire::broken {

namespace {

void add(const Signal& signal, std::vector<Signal>& signals) {
  const auto same = [&](const Signal& one) { return one.text == signal.text; };
  if (std::ranges::none_of(signals, same)) signals.push_back(signal);
}

Signal signal_of(const query::Formula& formula) {
  return {formula.text, formula.dimension, formula.recording};
}

/// Returns the columns of time, swept parameters and words.
std::set<std::string> other_columns(const session::LoadedModel& model, const record::Recording& recording) {
  std::set<std::string> names{"time"};
  if (model.job.plan.diagram.sweep)
    for (const diagram::Sweep::Axis& axis : model.job.plan.diagram.sweep->axes) names.insert(axis.parameter);
  for (const record::Categories& words : recording.categories) names.insert(words.column);
  return names;
}

void add_recorded(const session::LoadedModel& model, std::span<const record::Recording> recordings,
                  std::vector<Signal>& signals) {
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const std::set<std::string> others = other_columns(model, recordings[i]);
    for (const table::Column& column : recordings[i].table.columns) {
      if (others.contains(column.name)) continue;
      const auto unit = unit::parse_unit(column.unit);
      add({column.name, unit ? std::optional(unit->dimension) : std::nullopt, i}, signals);
    }
  }
}

}  // namespace

bool is_drawn(const std::string& channel) {
  static const std::set<std::string> others{"by", "beside", "sheets", "to", "note"};
  return !others.contains(channel);
}

std::vector<Signal> signals_of(const session::LoadedModel& model, const session::Outcome& outcome) {
  std::vector<Signal> signals;
  for (const plot::Figure& figure : model.figures)
    for (const plot::Panel& panel : figure.panels) {
      for (const auto& [key, rows] : panel.series)
        for (const query::Series& row : rows)
          if (is_drawn(key)) add(signal_of(row.formula), signals);
    }
  add_recorded(model, outcome.recordings(), signals);
  return signals;
}

std::vector<Signal> instead_of(const query::Formula& drawn, const std::vector<Signal>& signals) {
  const auto begin = std::ranges::find(signals, drawn.text, &Signal::text);
  std::vector<Signal> others;
  const auto take = [&](const Signal& signal) {
    const bool together = !signal.recording || !drawn.recording || signal.recording == drawn.recording;
    const bool alike =
        signal.dimension.value_or(unit::Dimension{}) == drawn.dimension.value_or(unit::Dimension{});
    if (together && alike && signal.text != drawn.text) others.push_back(signal);
  };
  std::for_each(begin, signals.end(), take);
  std::for_each(signals.begin(), begin, take);
  return others;
}

}  // namespace stepwire::broken
