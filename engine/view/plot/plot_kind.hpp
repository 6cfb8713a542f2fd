#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

class PlotBuilder;
/// Requirement of a key on its plot.
enum class KeyNeeds {
  nothing,
  plane,      ///< Two axes in a plane.
  both,       ///< Numbers along both axes of a plane.
  depth,      ///< Numbers along a third axis.
  outlines,   ///< Axes in a plane or in space.
  ratio,      ///< Axes with a settable ratio of lengths.
  choice,     ///< Rows or runs that may be selected.
  rows,       ///< Several rows of each run.
  legend,     ///< Texts that distinguish its curves.
  across,     ///< Numbers along x.
  up,         ///< Numbers along y.
  scale,      ///< Axes with a settable scale.
  color_bar,  ///< A colour bar.
};

/// Stage at which a key is read.
enum class KeyStage {
  options,  ///< with the units of the axes
  points,   ///< after the ranges, which must contain it
  rows      ///< after the recordings of the panel, whose rows it reads
};

/// Key of panels. A key without a reader is read by its kind of plot.
struct PanelKey : yaml::KeyRow<Panel, query::NamesReading> {
  using KeyRow::KeyRow;
  KeyNeeds needs = KeyNeeds::nothing;
  KeyStage stage = KeyStage::options;
};

/// Returns a key that its kind of plot reads.
PanelKey described_key(const yaml::Key& key);

/// Key of a plot whose value is an expression over recorded columns.
struct Channel {
  std::string key;
  std::string doc;
  bool required = false;
  bool several = false;     ///< true if a list is allowed
  std::string otherwise{};  ///< default if the file does not have it
};

/// Returns a key of one number or, with `several`, of a list along an axis, in its unit; without an axis of
/// plain numbers. `take` is called for each number.
PanelKey key_of_numbers(std::string name, std::string doc, bool several, std::string axis,
                        std::function<void(Panel&, double)> take);

/// Returns a key that sets a number among the options of its kind.
template <class Options, class Number>
PanelKey number_key(std::string name, std::string doc, Number Options::*member, std::string axis = {}) {
  return key_of_numbers(std::move(name), std::move(doc), false, std::move(axis),
                        [=](Panel& panel, double value) { panel.options<Options>().*member = value; });
}

/// Returns a key that appends to a list of numbers among the options of its kind.
template <class Options>
PanelKey numbers_key(std::string name, std::string doc, std::vector<double> Options::*member,
                     std::string axis) {
  return key_of_numbers(
      std::move(name), std::move(doc), true, std::move(axis),
      [=](Panel& panel, double value) { (panel.options<Options>().*member).push_back(value); });
}

/// Returns a key that sets an option of its kind, whose type determines the reading.
template <class Options, class Member>
PanelKey option_key(std::string name, std::string doc, yaml::Key form, Member Options::*member) {
  PanelKey key{std::move(name), std::move(doc), std::move(form)};
  key.otherwise = yaml::default_text(key, Options{}.*member);
  key.set = [member, row = static_cast<yaml::Key>(key)](Panel& panel, const yaml::Node& node,
                                                        const query::NamesReading& read) {
    read.take(node, row, panel.options<Options>().*member);
  };
  return key;
}

/// Kind of plot: its keys and its drawing function. A new kind is one file with such a value and a struct of
/// its options, a declaration here and a line in the list of plots.cpp.
struct PlotKind {
  std::string name;
  std::string doc;
  std::vector<Channel> channels;
  std::vector<PanelKey> options;
  bool plane = true;  ///< true with axes x and y in a plane
  void (*draw)(const Panel& panel, std::span<const record::Recording> recordings,
               PlotBuilder& plot) = nullptr;
  /// Reader of a plot without axes, which is alone in its picture; replaces `draw`. Reads the options itself;
  /// their rows are descriptions only.
  PanelContent (*read)(const yaml::Node& node, const query::SymbolTable& names,
                       yaml::Faults& faults) = nullptr;
  /// Function that returns true if a plot with `read` uses recordings; nullptr: always.
  bool (*reads_rows)(const yaml::Node& node) = nullptr;
  /// Function that returns the quantities in a plot with `read`, by names below that of its panel; nullptr:
  /// none.
  std::vector<query::NamedFormula> (*shown)(const yaml::Node& node,
                                            const query::SymbolTable& names) = nullptr;
  bool last_rows = false;         ///< true if it always reads only the last row of each run
  std::vector<KeyNeeds> lacks{};  ///< requirements of keys that this plot does not meet
  bool bar_of_channel = false;    ///< true if it has its colour bar only with `color`

  /// Returns the channel of this name, or nullptr.
  const Channel* channel(std::string_view key) const;
  /// True if the plot meets the requirement of a key.
  bool takes(KeyNeeds needs) const;
};

/// Returns the keys of a kind, alone in its picture or as one of several panels.
yaml::Key plot_form(const PlotKind& kind, bool alone);

/// Returns all kinds, in the order of the reference.
const std::vector<PlotKind>& plot_kinds();

PlotKind lines_plot();
PlotKind xy_plot();
PlotKind loop_plot();
PlotKind path_plot();
PlotKind strip_plot();
PlotKind map_plot();
PlotKind field_plot();
PlotKind space_plot();
PlotKind box_plot();
PlotKind histogram_plot();
PlotKind tornado_plot();
PlotKind band_plot();
PlotKind sensitivity_plot();
PlotKind diagram_plot();
PlotKind rig_plot();
PlotKind table_plot();
PlotKind scene_plot();
PlotKind bode_plot();
PlotKind nyquist_plot();
PlotKind poles_plot();
PlotKind root_locus_plot();
PlotKind step_response_plot();
/// Returns the lower panel of a Bode plot, which files cannot name.
const PlotKind& bode_phase_plot();

}  // namespace stepwire::plot
