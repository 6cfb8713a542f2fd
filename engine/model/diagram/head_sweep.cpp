// Swept values that a file defines.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/head_cases.hpp"
#include "engine/model/diagram/head_design.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/head_range.hpp"

namespace stepwire::diagram {

namespace {

SweptValues listed(const yaml::Node& list) {
  std::vector<std::string> texts;
  std::vector<yaml::Mark> marks;
  for (const yaml::Node& item : list.items) {
    texts.push_back(setting_text(item));
    marks.push_back(item.mark);
  }
  return SweptValues(std::move(texts), std::move(marks));
}

void read_axis(const yaml::Entry& entry, Sweep& sweep, const Scope& scope, Report& report) {
  const yaml::Node* list = entry.value.is_map() ? entry.value.find("values") : &entry.value;
  Sweep::Axis axis{entry.key, {}, scope.at(entry.mark)};
  if (list && list->is_list()) {
    axis.values = listed(*list);
    if (axis.values.empty()) report.add(scope.at(list->mark), "sweep." + entry.key, "has no values");
  } else {
    axis.values = read_range(entry.value, entry.key, scope, report);
  }
  sweep.axes.push_back(std::move(axis));
}

/// Returns a label axis: a column of words about the points of a sweep.
Sweep::Axis label(const char* name, SweptValues words, const Origin& origin) {
  return {name, std::move(words), origin, true};
}

/// Returns values that are the base at all points except a range of one point for each value, after the first
/// `before` points.
SweptValues apart(const Sweep::Axis& axis, const std::string& base, std::size_t before, std::size_t points) {
  std::vector<std::string> texts{base};
  std::vector<yaml::Mark> marks{axis.origin.mark};
  std::vector<std::uint32_t> which(points, 0);
  for (std::size_t i = 0; i < axis.count(); ++i) {
    texts.push_back(axis.text(i));
    marks.push_back(axis.mark(i));
    which[before + i] = static_cast<std::uint32_t>(i + 1);
  }
  return SweptValues(std::move(texts), std::move(marks), std::move(which));
}

/// Arranges the axes one at a time: the first point has all own values of the file, each other one differs in
/// one value.
void set_apart(Sweep& sweep, const Origin& origin, Report& report) {
  std::vector<std::string> names{nothing_differs}, to{""};
  std::vector<std::uint32_t> which{0};
  for (const Sweep::Axis& axis : sweep.axes) {
    for (std::size_t i = 0; i < axis.count(); ++i) to.push_back(axis.text(i));
    which.insert(which.end(), axis.count(), static_cast<std::uint32_t>(names.size()));
    names.push_back(axis.parameter);
  }
  std::size_t before = 1;
  for (Sweep::Axis& axis : sweep.axes) {
    const std::size_t count = axis.count();
    axis.values =
        apart(axis, base_value(axis, "sweep.one_at_a_time." + axis.parameter, report), before, to.size());
    before += count;
  }
  sweep.together = true;
  const std::vector<yaml::Mark> marks(to.size(), origin.mark);
  sweep.axes.push_back(
      label(differs_label, SweptValues(std::move(names), {marks.front()}, std::move(which)), origin));
  sweep.axes.push_back(label(differs_to_label, SweptValues(std::move(to), marks), origin));
}

/// Reads `keep`: a word, or named reductions.
void read_keep(const yaml::Node& section, Sweep& sweep, const Scope& scope, Report& report) {
  const yaml::Node* keep = section.find("keep");
  if (!keep) return;
  const HeadReading read("sweep.keep", scope, report);
  if (!keep->is_map()) return read.take(*keep, keep_word_form(), sweep.keep);
  sweep.keep = Sweep::Keep::numbers;
  sweep.kept = *keep;
  if (keep->entries.empty()) read.fault(keep->mark, "names no number of a run: {peak: max(x)}");
}

/// Reads the runs whose rows are kept beside the reduced numbers.
void read_recorded_runs(const yaml::Node& section, Sweep& sweep, const Scope& scope, Report& report) {
  const yaml::Node* record = section.find("record");
  if (!record) return;
  const HeadReading read("sweep.record", scope, report);
  recorded_runs_table().read(*record, sweep, read);
  if (sweep.keep == Sweep::Keep::rows)
    read.fault(
        record->mark,
        "all runs are recorded already; leave it out, or keep numbers of the runs: keep: {peak: max(x)}");
  if (sweep.keep == Sweep::Keep::final)
    read.fault(record->mark,
               "goes with numbers of the runs, not with their last rows: keep: {last: final(x)}");
}

void read_one_at_a_time(const yaml::Node& section, const yaml::Node& axes, const Scope& scope,
                        Report& report) {
  const auto refuse = [&](const yaml::Mark& mark, const char* message) {
    report.add(scope.at(mark), "sweep.one_at_a_time", message);
  };
  const auto has = [&](const char* key) { return section.find(key) ? std::size_t{1} : 0; };
  if (section.entries.size() > 1 + has("keep") + has("record"))
    return refuse(axes.mark, "stands alone in its sweep; all that is varied is named in it");
  if (!axes.is_map() || axes.entries.empty())
    return refuse(axes.mark, "is a map of parameters and their values: {mass: [1 kg, 3 kg]}");
  Sweep sweep;
  const std::size_t before = report.faults().size();
  for (const yaml::Entry& entry : axes.entries) {
    if (entry.key == nothing_differs)
      refuse(entry.mark, "'base' is the word for the point at which no parameter differs; rename it");
    read_axis(entry, sweep, scope, report);
  }
  read_keep(section, sweep, scope, report);
  read_recorded_runs(section, sweep, scope, report);
  if (report.faults().size() == before) set_apart(sweep, scope.at(axes.mark), report);
  if (sweep.count() > max_runs)
    return refuse(axes.mark,
                  fmt::format("makes {} runs; at most {} are made", sweep.count(), max_runs).c_str());
  report.diagram().sweep = std::move(sweep);
}

bool is_axis(const yaml::Entry& entry) {
  return !sweep_form().find(entry.key);
}

/// True for a map that is neither a list of values nor a range.
bool is_drawn(const yaml::Node& node) {
  const auto has = [&](const yaml::Key& key) { return node.find(key.name) != nullptr; };
  return node.is_map() && !node.find("values") && std::ranges::none_of(range_form().of, has);
}

/// Reads and samples the values of all axes. Adds a fault and returns false for too many runs.
bool read_axes(const yaml::Node& section, Sweep& sweep, const Scope& scope, Report& report) {
  const std::size_t before = report.faults().size();
  const auto refuse = [&] {
    report.add(scope.at(section.mark), "sweep",
               fmt::format("makes {} runs or more; at most {} are made", sweep.count(), max_runs));
    return false;
  };
  std::vector<DrawnAxis> drawn;
  for (const yaml::Entry& entry : section.entries) {
    if (!is_axis(entry)) continue;
    if (is_drawn(entry.value)) {
      if (auto spread = read_distribution(entry.value, entry.key, scope, report))
        drawn.push_back({sweep.axes.size(), std::move(*spread)});
      sweep.axes.push_back({entry.key, {}, scope.at(entry.mark), false, Sweep::Group::samples});
    } else {
      read_axis(entry, sweep, scope, report);
    }
  }
  if (report.faults().size() == before) draw_axes(section, drawn, scope, sweep, report);
  if (const yaml::Node* cases = section.find("cases"); cases && report.faults().size() == before)
    read_cases(*cases, scope, sweep, report);
  return sweep.count() <= static_cast<double>(max_runs) || refuse();
}

}  // namespace

void read_sweep(const Scope& scope, Report& report) {
  const yaml::Node* node = scope.document->root.find("sweep");
  if (!node) return;
  if (!node->is_map())
    return report.add(scope.at(node->mark), "sweep",
                      "must be a map of parameter: {from, to, count} or {values: [..]}");
  if (const yaml::Node* one = node->find("one_at_a_time"))
    return read_one_at_a_time(*node, *one, scope, report);
  Sweep sweep;
  if (const yaml::Node* together = node->find("together"))
    HeadReading("sweep.together", scope, report).take(*together, yaml::form::truth(), sweep.together);
  read_keep(*node, sweep, scope, report);
  read_recorded_runs(*node, sweep, scope, report);
  if (!read_axes(*node, sweep, scope, report)) return;
  if (const yaml::Node* keep = node->find("keep"); keep && sweep.axes.empty())
    report.add(scope.at(keep->mark), "sweep.keep",
               "there are no runs to keep something of; name what varies");
  for (const Sweep::Axis& axis : sweep.axes)
    if (sweep.together && axis.count() != sweep.axes.front().count())
      report.add(axis.origin, "sweep." + axis.parameter,
                 fmt::format("has {} values, '{}' has {}; with 'together: true' they are paired",
                             axis.count(), sweep.axes.front().parameter, sweep.axes.front().count()));
  report.diagram().sweep = std::move(sweep);
}

}  // namespace stepwire::diagram
