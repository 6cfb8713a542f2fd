#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "engine/figure/curve.hpp"
#include "engine/figure/figure.hpp"

namespace stepwire {

/// Smallest and largest number seen.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value);
  bool empty() const { return !(low <= high); }
  /// Widened by a share of its width on both sides; where it is one point, so that it has a width at all.
  Extent padded(double share) const;
};

/// The gnuplot commands of one panel while it is put together.
class Script {
 public:
  /// `name` starts the names of its data blocks, so that panels of one picture do not share them.
  Script(const Panel& panel, std::string name) : panel_(panel), name_(std::move(name)) {}

  void set(const std::string& command) { commands_ += command + "\n"; }
  /// Writes curves as a data block, with a gap between them, and returns its name.
  std::string data(const std::vector<Curve>& curves) { return data(curves, "\n\n"); }
  /// The same with lines that are tied to a net.
  std::string net(const std::vector<Curve>& lines) { return data(lines, "\n"); }
  /// Takes the first two columns of curves into the extent of the plane.
  void cover(const std::vector<Curve>& curves);
  /// Adds something to be plotted: "$a0 using 1:2 with lines", with its text in the legend or none.
  /// What gnuplot wants behind the title goes `behind`.
  void plot(const std::string& item, const std::string& title = {}, const std::string& behind = {});

  /// The same below everything else.
  void plot_below(const std::string& item) { items_.insert(items_.begin(), item + " notitle"); }

  /// Labels the axis of a channel with its series.
  void label(const std::string& axis, const Series& series);
  /// Sets the range of an axis: the file's, or this.
  void range(const std::string& axis, const Extent& extent);
  /// Colour bar of a series whose values lie in this extent.
  void color_bar(const Series& series, const Extent& extent);
  /// Ranges of x and y around what is covered, with a little room; equal units where the panel asks for it.
  void plane(double room);

  /// Pixels that the drawing wants to be high; 0: as usual.
  double height = 0.0;
  bool space = false;  ///< three axes
  double share = 1.0;  ///< part of the picture's size, in bytes, that this panel may take
  Extent x, y;

  /// Curves in the plane that are drawn so far, where marks will have to keep off them; else none.
  const std::vector<Curve>& drawn() const { return drawn_; }
  const Panel& panel() const { return panel_; }
  /// What the axes show, by their names in gnuplot; logarithmic ones aside.
  const std::map<std::string, Extent>& shown() const { return shown_; }
  std::size_t titles() const { return titles_; }
  std::string text() const;

 private:
  std::string data(const std::vector<Curve>& curves, const char* gap);

  void name_more_than_decades(const std::string& axis, const Extent& shown);

  const Panel& panel_;
  std::string name_, commands_;
  std::vector<std::string> items_;
  std::vector<Curve> drawn_;
  std::map<std::string, Extent> shown_;
  std::size_t blocks_ = 0, titles_ = 0;
};

/// A text as gnuplot takes it literally, 'it’s': in these quotes nothing but an apostrophe has a meaning. All
/// that a diagram says goes through this, or through quoted_tic().
std::string quoted(const std::string& text);
/// The same for a label at a tic, which gnuplot takes for a format of numbers.
std::string quoted_tic(const std::string& text);

/// A unit as people print it: mm, N m, m/s², °; "-" where there is none.
std::string printed_unit(const std::string& unit);

/// Colour of the i-th curve, told apart by colour-blind people too (Okabe and Ito).
std::string curve_color(std::size_t index);

}  // namespace stepwire
