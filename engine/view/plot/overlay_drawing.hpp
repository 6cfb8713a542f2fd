#pragma once

#include <span>

#include "engine/view/plot/plot_builder.hpp"

namespace stepwire::plot {

// Overlays of a panel, for plots of any kind.

/// Extends the plane by regions, marks, texts, motions and roses, before the plot is drawn.
void cover_overlays(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);
/// Draws them, and the note and boundaries, after the plot is drawn.
void draw_overlays(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);

void cover_regions(const Panel& panel, PlotBuilder& plot);
/// Draws the boundaries of regions in front of everything, and shades the inside of those of a plane behind.
void draw_regions(const Panel& panel, PlotBuilder& plot);

void cover_marks(const Panel& panel, PlotBuilder& plot);
/// Draws marks with their names, each at the position beside its point where it covers least in axes of this
/// size [px].
void draw_marks(const Panel& panel, double width, double height, PlotBuilder& plot);
/// Writes texts centred at their points.
void draw_texts(const Panel& panel, PlotBuilder& plot);

void cover_motions(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);
/// Draws motions as lines behind the curves, with arrow heads at equal distances along each.
void draw_motions(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);

/// Extends the plane by the discs of roses that are not at their point.
void cover_roses(const Panel& panel, PlotBuilder& plot);
/// Draws roses: a disc whose radius is the largest value of all of them, a spoke for each row, and the line
/// through their ends. A disc that is not at its point has a line to it.
void draw_roses(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);

}  // namespace stepwire::plot
