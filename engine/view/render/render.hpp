#pragma once

#include <span>
#include <string>

#include "engine/view/plot/figure.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::render {

/// A picture, and what the program that drew it complained of (empty as a rule).
struct Drawing {
  std::string svg;
  std::string warnings;
};

/// Draws nothing but what the spec holds; the same spec gives the same bits. Throws EnvironmentError where
/// gnuplot, or what else draws, is missing or fails.
Drawing render(const plot::FigureSpec& figure);

/// Draws; the same data give the same bits. Throws EnvironmentError where gnuplot, or what else draws, is
/// missing or fails.
Drawing draw(const plot::Figure& figure, std::span<const record::Recording> recordings);

}  // namespace stepwire::render
