#pragma once

#include <span>

#include "engine/view/plot/plot_builder.hpp"

namespace stepwire::plot {

// What lies over the plot of a panel, whatever its kind.

/// Takes regions, marks, texts, motions and roses into the extent of the plane; before the plot is drawn.
void cover_overlays(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);
/// Draws them, and the note and boundaries, when the plot is drawn.
void draw_overlays(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);

void cover_regions(const Panel& panel, PlotBuilder& plot);
/// Draws the boundaries of regions above all else, and shades the inside of those of a plane below it.
void draw_regions(const Panel& panel, PlotBuilder& plot);

void cover_marks(const Panel& panel, PlotBuilder& plot);
/// Draws marks with their names, each on the side of its point where it covers least in axes of this size
/// [px].
void draw_marks(const Panel& panel, double width, double height, PlotBuilder& plot);
/// Writes texts about their points.
void draw_texts(const Panel& panel, PlotBuilder& plot);

void cover_motions(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);
/// Draws motions as lines below the curves, with arrow heads at even distances along each.
void draw_motions(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);

/// Takes the discs of roses that stand at places of their own into the extent of the plane.
void cover_roses(const Panel& panel, PlotBuilder& plot);
/// Draws roses: a disc whose edge stands for the largest value of all of them, a spoke for each row, the line
/// through their ends, and a line to the point where the disc stands beside it.
void draw_roses(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);

}  // namespace stepwire::plot
