#include "engine/view/plot/panel_reading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/axis_checks.hpp"
#include "engine/view/plot/gather.hpp"
#include "engine/view/plot/overlay.hpp"
#include "engine/view/plot/plot_kind.hpp"
#include "engine/view/plot/run_numbers.hpp"

namespace stepwire::plot {
namespace {

using Keys = std::vector<std::string>;

/// Returns the row of this name, or nullptr.
template <class AnyRow>
const AnyRow* find_key(const std::vector<AnyRow>& keys, const std::string& name) {
  const auto found = std::ranges::find(keys, name, &AnyRow::name);
  return found == keys.end() ? nullptr : &*found;
}

/// Reads the keys of one panel; collects faults.
class PanelReader {
 public:
  PanelReader(const yaml::Node& node, const query::SymbolTable& names, bool alone, yaml::Faults& faults)
      : node_(node), names_(names), alone_(alone), faults_(faults) {}

  std::optional<Panel> read() {
    if (!find_kind()) return std::nullopt;
    if (panel_.kind->read) return read_picture();
    for (const auto& entry : node_.entries)
      if (panel_.kind->channel(entry.key)) read_channel(entry);
    for (const auto& channel : panel_.kind->channels)
      if (!channel.otherwise.empty() && !node_.find(channel.key)) read_channel(in_place(channel));
    reading("").check_unknown(node_, plot_form(*panel_.kind, alone_));
    // Options are in the units of the channels, so they are read second.
    for (const auto& entry : node_.entries)
      if (!panel_.kind->channel(entry.key)) read_option(entry);
    for (const auto& channel : panel_.kind->channels)
      if (channel.required && node_.find(channel.key) == nullptr)
        fault(node_.mark, "figure." + channel.key,
              fmt::format("a plot '{}' needs '{}': {}", panel_.kind->name, channel.key, channel.doc));
    for (const PanelKey& option : panel_.kind->options)
      if (option.required && node_.find(option.name) == nullptr)
        fault(node_.mark, "figure." + option.name,
              fmt::format("a plot '{}' needs '{}': {}", panel_.kind->name, option.name, option.doc));
    check_beside();
    check_numbers();
    read_later(KeyStage::points);
    check_axes(panel_, node_, names_, faults_);
    find_recordings();
    read_later(KeyStage::rows);
    return std::move(panel_);
  }

 private:
  void fault(yaml::Mark mark, const std::string& subject, const yaml::Message& message) {
    faults_.add({{names_.file, mark}, subject, message, {}});
  }

  query::NamesReading reading(const std::string& key) const {
    const query::NamesReading read("figure", names_, faults_);
    return key.empty() ? read : yaml::below(read, key);
  }

  bool find_kind() {
    Keys all;
    for (const auto& kind : plot_kinds()) all.push_back(kind.name);
    const yaml::Node* plot = node_.find("plot");
    if (plot == nullptr) {
      fault(node_.mark, "figure", fmt::format("'plot' is missing; it is one of {}", fmt::join(all, ", ")));
      return false;
    }
    for (const auto& kind : plot_kinds())
      if (plot->is_scalar() && kind.name == plot->text) panel_.kind = &kind;
    if (panel_.kind == nullptr)
      fault(plot->mark, "figure.plot",
            fmt::format("there is no plot '{}'", plot->text) +
                yaml::nearest_or_all(plot->text, all, "there are"));
    return panel_.kind != nullptr;
  }

  /// Reads a plot without axes, which takes no keys of axes and is alone in its picture.
  std::optional<Panel> read_picture() {
    if (!alone_) {
      fault(node_.mark, "figure.panels",
            fmt::format(
                "a plot '{}' is a picture for itself; give it an entry of its own in the list of figures",
                panel_.kind->name));
      return std::nullopt;
    }
    reading("").check(node_, plot_form(*panel_.kind, true));
    panel_.content = panel_.kind->read(node_, names_, faults_);
    panel_.reads_rows = !panel_.kind->reads_rows || panel_.kind->reads_rows(node_);
    if (panel_.kind->shown) panel_.shown = panel_.kind->shown(node_, names_);
    yaml::Faults told;  // already reported by the plot
    if (const yaml::Node* where = node_.find("where"))
      panel_.where = query::read_formula(*where, names_, "figure.where", told);
    return std::move(panel_);
  }

  void read_channel(const yaml::Entry& entry) {
    const Channel& channel = *panel_.kind->channel(entry.key);
    const std::string subject = "figure." + entry.key;
    if (entry.value.is_list() && !channel.several)
      return fault(entry.value.mark, subject,
                   fmt::format("'{}' takes one expression, not a list", entry.key));
    if (entry.value.is_list() && entry.value.items.empty())
      return fault(entry.value.mark, subject, "the list is empty");
    for (const yaml::Node& item : entry.value.as_list())
      if (auto series = reduces_runs(item) ? read_run_series(item, reading(entry.key), panel_)
                                           : query::read_series(item, names_, subject, faults_)) {
        if (entry.key == "by") show_as_written(*series, names_);
        panel_.series[entry.key].push_back(std::move(*series));
      }
  }

  /// Returns the default of a channel that the file does not have, as an entry of the file.
  yaml::Entry in_place(const Channel& channel) const {
    yaml::Entry entry{channel.key, node_.mark, {}};
    entry.value.kind = yaml::Node::Kind::scalar;
    entry.value.text = channel.otherwise;
    entry.value.mark = node_.mark;
    return entry;
  }

  /// Returns the row of an option of the kind or of a key of panels; nullptr if the plot takes no such key.
  const PanelKey* find_row(const std::string& key) const {
    if (const PanelKey* option = find_key(panel_.kind->options, key)) return option;
    const PanelKey* row = find_key(panel_keys(), key);
    return row && panel_.kind->takes(row->needs) ? row : nullptr;
  }

  void read_option(const yaml::Entry& entry) {
    if (entry.key == "plot" || (alone_ && find_key(picture_keys(), entry.key))) return;
    const PanelKey* row = find_row(entry.key);
    if (row && row->stage == KeyStage::options) row->set(panel_, entry.value, reading(row->name));
  }

  void read_later(KeyStage stage) {
    for (const PanelKey& row : panel_keys())
      if (const yaml::Node* value = node_.find(row.name);
          value && row.stage == stage && panel_.kind->takes(row.needs))
        row.set(panel_, *value, reading(row.name));
  }

  /// Checks that a panel of one number for each run has no channel with several values in a run.
  void check_numbers() {
    if (panel_.numbers.empty()) return;
    panel_.final_rows = true;
    for (const query::RecordedName& name : names_.columns)
      if (!name.recording) panel_.of_runs.push_back(name.name);
    for (const auto& [key, list] : panel_.series)
      for (const query::Series& series : list)
        if (series.formula.recording ||
            std::ranges::find(series.formula.columns, "time") != series.formula.columns.end())
          fault(series.formula.mark, "figure." + key,
                fmt::format("'{}' has many values in a run; reduce it, as in max({})", series.formula.text,
                            series.formula.text));
  }

  /// Adds a fault for a key whose object is missing, such as a line without a region.
  void check_beside() {
    std::vector<std::pair<const char*, const char*>> beside{{"region_line", "region"}};
    if (panel_.kind->channel("low")) beside.insert(beside.end(), {{"low", "high"}, {"high", "low"}});
    if (panel_.kind->bar_of_channel)
      for (const char* key : {"color_label", "color_range"}) beside.emplace_back(key, "color");
    for (const auto& [key, of] : beside)
      if (const yaml::Node* node = node_.find(key); node && !node_.find(of))
        fault(node->mark, std::string("figure.") + key,
              fmt::format("goes with '{}', which is not given", of));
  }

  /// True for a series of numbers that the panel computes from each run, which no recording has.
  bool is_number(const query::Series& series) const {
    return !series.formula.columns.empty() &&
           std::ranges::find(panel_.numbers, series.formula.columns.front(), &RunNumber::name) !=
               panel_.numbers.end();
  }

  /// Finds the recordings. Each y is drawn with the other channels, so they must be in one recording.
  void find_recordings() {
    std::vector<const query::Formula*> shared;
    if (panel_.where) shared.push_back(&*panel_.where);
    for (const RunNumber& number : panel_.numbers)
      for (const claim::Claim& one : number.formula.reductions)
        for (const query::Formula& value : one.values) shared.push_back(&value);
    for (const auto& [key, list] : panel_.series)
      for (const query::Series& series : list)
        if (key != "y" && !is_number(series)) shared.push_back(&series.formula);
    const auto y = panel_.series.find("y");
    if (y == panel_.series.end()) {
      panel_.recordings = {query::common_recording(shared, names_, node_, "figure", faults_)};
      return;
    }
    for (const query::Series& series : y->second) {
      auto all = shared;
      if (!is_number(series)) all.push_back(&series.formula);
      panel_.recordings.push_back(query::common_recording(all, names_, node_, "figure", faults_));
    }
  }

  const yaml::Node& node_;
  const query::SymbolTable& names_;
  bool alone_;
  yaml::Faults& faults_;
  Panel panel_;
};

}  // namespace

std::optional<Panel> read_panel(const yaml::Node& node, const query::SymbolTable& names, bool alone,
                                yaml::Faults& faults) {
  if (!node.is_map()) {
    faults.add(
        {{names.file, node.mark}, "figure", "a figure is a map: {plot: lines, x: time, y: rig.x}", {}});
    return std::nullopt;
  }
  return PanelReader(node, names, alone, faults).read();
}

std::optional<double> read_axis_number(const yaml::Node& node, const Panel& panel, const std::string& axis,
                                       const query::SymbolTable& names, const std::string& subject,
                                       yaml::Faults& faults) {
  const auto read = query::read_number(node, names, subject, faults);
  if (!read) return std::nullopt;
  const query::Series* series = panel.find(axis);
  if (series == nullptr) return read->value;
  query::check_dimension(*read, {series->formula.dimension, series->formula.is_ratio},
                         fmt::format("'{}'", series->formula.text), node, names, subject, faults);
  if (read->dimension && *read->dimension != unit::Dimension{} && series->unit_text.empty())
    faults.add({{names.file, node.mark},
                subject,
                fmt::format("{} has a unit, but that of '{}' is not known; {}", read->text,
                            series->formula.text, query::unit_cure(series->formula, *read->dimension)),
                {}});
  if (auto wrong = bare_number(read->text, *series))
    faults.add({{names.file, node.mark}, subject, std::move(*wrong), {}});
  return series->unit.from_si(read->value);
}

}  // namespace stepwire::plot
