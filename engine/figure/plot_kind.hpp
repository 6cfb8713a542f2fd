#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/figure/figure.hpp"

namespace stepwire {

class Script;

/// A key of a plot whose value is an expression over recorded columns.
struct Channel {
  std::string key;
  std::string doc;
  bool required = false;
  bool several = false;  ///< a list is allowed
};

/// A key of a plot whose value is a number, a list of numbers, or one of some words.
struct Option {
  std::string key;
  std::string doc;
  std::string axis{};  ///< the channel in whose unit its numbers are drawn; empty: plain numbers
  bool list = false;   ///< a number or a list of them
  std::vector<std::string> words{};  ///< the words that are allowed, for an option that is a word or a list
  /// All but plain ones are read by the plot itself: names, a map of texts, a map of lists of names, or what
  /// only its doc describes.
  enum class Form { plain, names, texts, lists, tree } form = Form::plain;
  bool pairs = false;  ///< of a list: its numbers come in twos
};

/// One kind of plot: what it reads and how it is drawn. A new kind is one file with one such value, and a
/// line in the list of plots.cpp.
struct PlotKind {
  std::string name;
  std::string doc;
  std::vector<Channel> channels;
  std::vector<Option> options;
  bool plane = true;  ///< has the axes x and y in a plane
  void (*draw)(const Panel& panel, std::span<const Recording> recordings, Script& script) = nullptr;
  /// For a plot that has a picture for itself and draws it without gnuplot, in place of `draw`: reads its
  /// options.
  Picture (*read)(const Node& node, const Names& names, Faults& faults) = nullptr;

  /// The channel of this name, or nullptr.
  const Channel* channel(std::string_view key) const;
  /// May this key of panels be given here? Boundaries want a plane; marks, motions and roses also something
  /// along both its axes.
  bool takes(std::string_view panel_key) const;
};

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
PlotKind diagram_plot();
PlotKind rig_plot();
PlotKind table_plot();
PlotKind scene_plot();

}  // namespace stepwire
