#include "engine/figure/panel_reading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/figure/number.hpp"
#include "engine/figure/overlay.hpp"
#include "engine/figure/plot_kind.hpp"

namespace stepwire {
namespace {

using Keys = std::vector<std::string>;

const Option* find_option(const PlotKind& kind, const std::string& key) {
  const auto found = std::find_if(kind.options.begin(), kind.options.end(),
                                  [&](const Option& option) { return option.key == key; });
  return found == kind.options.end() ? nullptr : &*found;
}

bool is_among(const std::vector<FigureKey>& keys, const std::string& name) {
  return std::any_of(keys.begin(), keys.end(), [&](const FigureKey& key) { return key.name == name; });
}

/// Reads the keys of one panel; faults are gathered.
class PanelReader {
 public:
  PanelReader(const Node& node, const Names& names, bool alone, Faults& faults)
      : node_(node), names_(names), alone_(alone), faults_(faults) {}

  std::optional<Panel> read() {
    if (!find_kind()) return std::nullopt;
    if (panel_.kind->read) return read_picture();
    for (const auto& entry : node_.entries)
      if (panel_.kind->channel(entry.key)) read_channel(entry);
    // Options are read in the units of the channels, so they come second.
    for (const auto& entry : node_.entries)
      if (!panel_.kind->channel(entry.key)) read_other(entry);
    for (const auto& channel : panel_.kind->channels)
      if (channel.required && node_.find(channel.key) == nullptr)
        fault(node_.mark, "figure." + channel.key,
              fmt::format("a plot '{}' needs '{}': {}", panel_.kind->name, channel.key, channel.doc));
    if (panel_.kind->takes("marks")) read_points();
    check_axes(panel_, node_, names_, faults_);
    find_recordings();
    // What reads a single row, perhaps of another recording.
    if (const Node* boundary = node_.find("boundary")) read_boundaries(*boundary, panel_, names_, faults_);
    if (const Node* note = node_.find("note")) read_note(*note, panel_, names_, faults_);
    return std::move(panel_);
  }

 private:
  void fault(Mark mark, const std::string& subject, const std::string& message) {
    faults_.add({{names_.file, mark}, subject, message, {}});
  }

  bool find_kind() {
    Keys all;
    for (const auto& kind : plot_kinds()) all.push_back(kind.name);
    const Node* plot = node_.find("plot");
    if (plot == nullptr) {
      fault(node_.mark, "figure", fmt::format("'plot' is missing; it is one of {}", fmt::join(all, ", ")));
      return false;
    }
    for (const auto& kind : plot_kinds())
      if (plot->is_scalar() && kind.name == plot->text) panel_.kind = &kind;
    if (panel_.kind == nullptr)
      fault(plot->mark, "figure.plot",
            fmt::format("there is no plot '{}'{}", plot->text, nearest_or_all(plot->text, all, "there are")));
    return panel_.kind != nullptr;
  }

  /// Of a plot that is a picture for itself, which takes no keys of axes.
  std::optional<Panel> read_picture() {
    if (!alone_) {
      fault(node_.mark, "figure.panels",
            fmt::format(
                "a plot '{}' is a picture for itself; give it an entry of its own in the list of figures",
                panel_.kind->name));
      return std::nullopt;
    }
    Keys known{"plot", "title", "caption", "own"};
    for (const Option& option : panel_.kind->options) known.push_back(option.key);
    for (const auto& entry : node_.entries)
      if (std::find(known.begin(), known.end(), entry.key) == known.end())
        add_unknown_key(entry, known, fmt::format("a plot '{}'", panel_.kind->name), names_, "figure",
                        faults_);
    panel_.picture = panel_.kind->read(node_, names_, faults_);
    Faults told;  // by the plot already
    if (const Node* where = node_.find("where"))
      panel_.where = read_formula(*where, names_, "figure.where", told);
    return std::move(panel_);
  }

  void read_channel(const Entry& entry) {
    const Channel& channel = *panel_.kind->channel(entry.key);
    const std::string subject = "figure." + entry.key;
    if (entry.value.is_list() && !channel.several)
      return fault(entry.value.mark, subject,
                   fmt::format("'{}' takes one expression, not a list", entry.key));
    if (entry.value.is_list() && entry.value.items.empty())
      return fault(entry.value.mark, subject, "the list is empty");
    const std::vector<Node> one{entry.value};
    for (const auto& item : entry.value.is_list() ? entry.value.items : one)
      if (auto series = read_series(item, names_, subject, faults_))
        panel_.series[entry.key].push_back(std::move(*series));
  }

  void read_other(const Entry& entry) {
    const std::string& key = entry.key;
    if (key == "plot" || (alone_ && is_among(picture_keys(), key))) return;
    if (const Option* option = find_option(*panel_.kind, key)) return read_option(*option, entry.value);
    if (!is_among(panel_keys(), key) || !panel_.kind->takes(key)) return unknown(entry);
    const Node& value = entry.value;
    if (key == "title" || key.ends_with("_label")) panel_.words[key] = text(value, key);
    if (key == "where") panel_.where = read_formula(value, names_, "figure.where", faults_);
    if (key == "equal") panel_.equal = word(value, key, {"true", "false"}) == "true";
    if (key == "rows") panel_.final_rows = word(value, key, {"all", "final"}) == "final";
    if (key == "legend") read_legend(value);
    if (key == "log") read_log(value);
    if (key == "region") read_region(value);
    if (key == "region_line") panel_.words[key] = word(value, key, {"line", "dashes"});
    if (key == "motion") read_motions(value, panel_, names_, faults_);
    if (key == "rose") read_roses(value, panel_, names_, faults_);
    if (key.ends_with("_range")) read_range(value, key);
  }

  /// Points lie within the ranges, which stand anywhere in the map.
  void read_points() {
    if (const Node* marks = node_.find("marks")) read_marks(*marks, panel_, names_, faults_);
    if (const Node* texts = node_.find("texts")) read_texts(*texts, panel_, names_, faults_);
  }

  void unknown(const Entry& entry) {
    Keys keys{"plot"};
    for (const auto& key : figure_keys(panel_.kind->name)) keys.push_back(key.name);
    for (const auto& key : panel_keys())
      if (panel_.kind->takes(key.name)) keys.push_back(key.name);
    if (alone_)
      for (const auto& key : picture_keys())
        if (!is_among(panel_keys(), key.name)) keys.push_back(key.name);
    add_unknown_key(entry, keys, fmt::format("a plot '{}'", panel_.kind->name), names_, "figure", faults_);
  }

  std::string text(const Node& node, const std::string& key) {
    return read_text(node, names_, "figure." + key, faults_);
  }

  std::string word(const Node& node, const std::string& key, const Keys& allowed) {
    if (node.is_scalar() && std::find(allowed.begin(), allowed.end(), node.text) != allowed.end())
      return node.text;
    fault(node.mark, "figure." + key,
          fmt::format("'{}' is not allowed; it is one of {}", node.text, fmt::join(allowed, ", ")));
    return {};
  }

  std::optional<double> number(const Node& node, const std::string& key, const std::string& axis) {
    return read_axis_number(node, panel_, axis, names_, "figure." + key, faults_);
  }

  void read_option(const Option& option, const Node& node) {
    const std::vector<Node> one{node};
    if (!option.words.empty() && option.list) {
      for (const auto& item : node.is_list() ? node.items : one)
        panel_.word_lists[option.key].push_back(word(item, option.key, option.words));
    } else if (!option.words.empty()) {
      panel_.words[option.key] = word(node, option.key, option.words);
    } else if (option.list) {
      for (const auto& item : node.is_list() ? node.items : one)
        if (const auto value = number(item, option.key, option.axis))
          panel_.levels[option.key].push_back(*value);
      if (option.pairs && panel_.levels[option.key].size() % 2 != 0)
        fault(node.mark, "figure." + option.key,
              "needs two numbers for each range, its beginning and its end");
    } else if (const auto value = number(node, option.key, option.axis)) {
      panel_.numbers[option.key] = *value;
    }
  }

  void read_range(const Node& node, const std::string& key) {
    const std::string axis = key.substr(0, key.find('_'));
    if (!node.is_list() || node.items.size() != 2)
      return fault(node.mark, "figure." + key, "a range is two numbers: [-5 mm, 5 mm]");
    const auto low = number(node.items[0], key, axis), high = number(node.items[1], key, axis);
    if (!low || !high) return;
    if (!(*low < *high)) fault(node.mark, "figure." + key, "the first number of a range is below the second");
    panel_.ranges[key] = {*low, *high};
  }

  void read_legend(const Node& node) {
    const std::vector<Node> one{node};
    for (const auto& item : node.is_list() ? node.items : one) panel_.legend.push_back(text(item, "legend"));
  }

  void read_log(const Node& node) {
    const std::vector<Node> one{node};
    for (const auto& item : node.is_list() ? node.items : one) {
      const std::string axis = word(item, "log", {"x", "y", "color"});
      (axis == "x" ? panel_.log_x : axis == "y" ? panel_.log_y : panel_.log_color) = true;
    }
  }

  void read_region(const Node& node) {
    const std::vector<Node> one{node};
    for (const auto& item : node.is_list() ? node.items : one) {
      const Outline* outline = find_outline(item);
      if (outline && outline->space == panel_.kind->plane)
        fault(item.mark, "figure.region",
              fmt::format("'{}' lies in {}, and a plot '{}' shows {}", item.text,
                          outline->space ? "space" : "the plane", panel_.kind->name,
                          outline->space ? "the plane" : "space"));
      if (outline) panel_.regions.push_back(*outline);
    }
  }

  const Outline* find_outline(const Node& node) {
    Keys names;
    for (const NamedOutline& named : names_.outlines) {
      if (node.is_scalar() && named.name == node.text) return &named.outline;
      names.push_back(named.name);
    }
    const std::string choice =
        names.empty() ? "; this file has none" : nearest_or_all(node.text, names, "there are");
    fault(node.mark, "figure.region",
          fmt::format("'{}' is no block with a boundary, as a Region is{}", node.text, choice));
    return nullptr;
  }

  /// Each y is drawn with the other channels, so these must have been recorded together.
  void find_recordings() {
    std::vector<const Formula*> shared;
    if (panel_.where) shared.push_back(&*panel_.where);
    for (const auto& [key, list] : panel_.series)
      for (const Series& series : list)
        if (key != "y") shared.push_back(&series.formula);
    const auto y = panel_.series.find("y");
    if (y == panel_.series.end()) {
      panel_.recordings = {common_recording(shared, names_, node_, "figure", faults_)};
      return;
    }
    for (const Series& series : y->second) {
      auto all = shared;
      all.push_back(&series.formula);
      panel_.recordings.push_back(common_recording(all, names_, node_, "figure", faults_));
    }
  }

  const Node& node_;
  const Names& names_;
  bool alone_;
  Faults& faults_;
  Panel panel_;
};

}  // namespace

std::optional<Panel> read_panel(const Node& node, const Names& names, bool alone, Faults& faults) {
  if (!node.is_map()) {
    faults.add(
        {{names.file, node.mark}, "figure", "a figure is a map: {plot: lines, x: time, y: rig.x}", {}});
    return std::nullopt;
  }
  return PanelReader(node, names, alone, faults).read();
}

}  // namespace stepwire
