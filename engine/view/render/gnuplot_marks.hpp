#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_mark.hpp"

namespace stepwire::render {

/// Generates gnuplot's commands for the marks of one panel, in order.
class GnuplotMarks {
 public:
  /// `panel` is the prefix of the names of data blocks, so that panels of one picture do not share them.
  explicit GnuplotMarks(std::string panel) : panel_(std::move(panel)) {}

  void operator()(const plot::LineMark& mark);
  void operator()(const plot::BandMark& mark);
  void operator()(const plot::SpanMark& mark);
  void operator()(const plot::AreaMark& mark);
  void operator()(const plot::PointsMark& mark);
  void operator()(const plot::BoxesMark& mark);
  void operator()(const plot::RectanglesMark& mark);
  void operator()(const plot::ImageMark& mark);
  void operator()(const plot::VectorsMark& mark);
  void operator()(const plot::SurfaceMark& mark);

  /// Returns data blocks and settings, followed by `plot` or, with `space`, `splot` with all marks.
  std::string text(bool space) const;

 private:
  using Columns = std::vector<const std::vector<double>*>;

  /// Writes pieces as a data block, with a gap between two of them, and returns its name.
  std::string data(const std::vector<Columns>& pieces, const char* gap = "\n\n");
  void plot(const std::string& item, const std::string& legend = {}, const std::string& behind = {});

  std::string panel_, commands_;
  std::vector<std::string> items_;
  std::size_t blocks_ = 0;
  bool has_surface_ = false;  ///< true after a surface
};

/// Returns gnuplot's point size for a diameter [px] in pictures with its font of 13 pixels.
double point_size(double diameter);

}  // namespace stepwire::render
