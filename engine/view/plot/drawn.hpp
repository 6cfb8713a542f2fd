#pragma once

#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::plot {

/// What the pictures of a file draw, under the names that its claims may use:
/// "figure.PICTURE.PANEL.CHANNEL.NUMBER", and "where" in place of a channel and number for the condition
/// under which a row is drawn. Each number counts from 1. The number of a channel, the panel and then also
/// the picture may be left out where they are 1: "figure.color", "figure.2.y.3"; what lies over a panel has
/// its own number, "figure.motion.x", "figure.rose.2.value".
std::vector<query::NamedFormula> drawn_quantities(const std::vector<Figure>& figures);

/// Where the objects of a scene are, under the names that claims may use: "scene.ball.x", "scene.guide.2.y"
/// of the second of several points, and "scene.circle.radius".
std::vector<query::NamedFormula> shown_quantities(const scene::Scene& scene);

}  // namespace stepwire::plot
