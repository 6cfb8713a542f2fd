#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

class PlotBuilder;
/// What a key needs of its plot.
enum class KeyNeeds {
  nothing,
  plane,      ///< two axes in a plane
  both,       ///< numbers along both axes of a plane
  depth,      ///< numbers along a third axis
  outlines,   ///< axes in a plane or in space
  ratio,      ///< axes whose lengths the file may relate
  choice,     ///< rows or runs of which some may be left out
  rows,       ///< several rows of each run
  legend,     ///< texts that tell its curves apart
  across,     ///< numbers along x
  up,         ///< numbers along y
  scale,      ///< axes whose scale the file may choose
  color_bar,  ///< a colour bar
};

/// When a key is read.
enum class KeyStage {
  options,  ///< with the units of the axes
  points,   ///< behind the ranges, within which it lies
  rows      ///< behind the recordings of the panel, whose rows it reads
};

/// A key of panels. One without a reader is read by its kind of plot.
struct PanelKey : yaml::KeyRow<Panel, query::NamesReading> {
  using KeyRow::KeyRow;
  KeyNeeds needs = KeyNeeds::nothing;
  KeyStage stage = KeyStage::options;
};

/// A key that its kind of plot reads.
PanelKey described_key(const yaml::Key& key);

/// A key of a plot whose value is an expression over recorded columns.
struct Channel {
  std::string key;
  std::string doc;
  bool required = false;
  bool several = false;     ///< a list is allowed
  std::string otherwise{};  ///< what counts where the file does not have it
};

/// A number along an axis, in whose unit it is; without an axis a plain one.
PanelKey number_key(std::string name, std::string doc, std::optional<double> Panel::*member,
                    std::string axis = {});
/// A number or a list of them along an axis.
PanelKey numbers_key(std::string name, std::string doc, std::vector<double> Panel::*member, std::string axis);

/// One kind of plot: what it reads and how it is drawn. A new kind is one file with one such value, and a
/// line in the list of plots.cpp.
struct PlotKind {
  std::string name;
  std::string doc;
  std::vector<Channel> channels;
  std::vector<PanelKey> options;
  bool plane = true;  ///< has the axes x and y in a plane
  void (*draw)(const Panel& panel, std::span<const record::Recording> recordings,
               PlotBuilder& plot) = nullptr;
  /// For a plot that has no axes and a picture for itself, in place of `draw`: reads its options, whose rows
  /// only describe them.
  PanelContent (*read)(const yaml::Node& node, const query::SymbolTable& names,
                       yaml::Faults& faults) = nullptr;
  /// Does one that is read so show what was recorded? Null: it does.
  bool (*reads_rows)(const yaml::Node& node) = nullptr;
  /// The quantities that one that is read so shows, by names below that of its panel; null: none.
  std::vector<query::NamedFormula> (*shown)(const yaml::Node& node,
                                            const query::SymbolTable& names) = nullptr;
  bool last_rows = false;         ///< reads the last row of each run alone, whatever the file has
  std::vector<KeyNeeds> lacks{};  ///< what keys of panels may need and this plot does not have
  bool bar_of_channel = false;    ///< has its colour bar where the file gives `color` alone

  /// The channel of this name, or nullptr.
  const Channel* channel(std::string_view key) const;
  /// Has the plot what a key of panels needs?
  bool takes(KeyNeeds needs) const;
};

/// The keys of a kind, alone in its picture or as one of several panels.
yaml::Key plot_form(const PlotKind& kind, bool alone);

/// All kinds, in the order of the reference.
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
/// The lower panel of a Bode plot, which no file names.
const PlotKind& bode_phase_plot();

}  // namespace stepwire::plot
