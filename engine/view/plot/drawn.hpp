#pragma once

#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::plot {

/// Returns the quantities that the pictures of a file draw, by the names that its claims may use. A name is
/// that of the panel, "figure.PICTURE.PANEL", and behind it one of these:
///
/// - CHANNEL.NUMBER is a row.
///
/// - CHANNEL.TEXT, LABEL.TEXT are a row by its text in the legend, and the channel by the label of its axis.
///
/// - by.TEXT is the condition of the curve with this text in the legend, for a swept `by`.
///
/// - where is the condition of the drawn rows.
///
/// - motion.x, rose.2.value is a quantity of a motion or a rose.
///
/// - region.OUTPUT is a recorded output of the block of the region.
///
/// - boundary is the expression of the boundary, at the drawn x and y.
///
/// - marks.NAME.x, texts.TEXT.y is a coordinate of a named point or a text.
///
/// - ROW.HEADING is a cell of a table.
///
/// - labels.TEXT is the signal with this label in a picture of the diagram.
///
/// - elements.NAME.x, elements.NAME.2.y, elements.NAME.direction.x is a coordinate of an element of a rig.
///
/// Each number counts from 1. Numbers of rows, the panel and then also the picture may be left out where they
/// are 1: "figure.color", "figure.2.y.3". Texts are written as name_of_label() has them.
std::vector<query::NamedFormula> drawn_quantities(const std::vector<Figure>& figures,
                                                  const query::SymbolTable& names);

/// A text of a figure as a part of a name: "0.5 A (as 0.35 A)" is 0_5_A_as_0_35_A. Of a text without letters
/// and digits of ASCII it is the number.
std::string name_of_label(const std::string& label, std::size_t number);

/// Where the objects of a scene are, under the names that claims may use: "scene.ball.x", "scene.guide.2.y"
/// of the second of several points, and "scene.circle.radius".
std::vector<query::NamedFormula> shown_quantities(const scene::Scene& scene);

}  // namespace stepwire::plot
