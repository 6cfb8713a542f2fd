#pragma once

#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::plot {

/// Returns the quantities in the pictures of a file, by the names that its claims may use. A name is that of
/// the panel, "figure.PICTURE.PANEL", followed by one of these:
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
/// The title of a picture or panel may replace its number: "figure.side_view.x", "figure.2.left_damper.color".
///
/// Each number counts from 1. The number of a row, the panel and then also the picture may be omitted if it
/// is 1: "figure.color", "figure.2.y.3". Texts have the form of name_of_label().
std::vector<query::NamedFormula> drawn_quantities(const std::vector<Figure>& figures,
                                                  const query::SymbolTable& names);

/// Returns a text of a figure as a part of a name: "0.5 A (as 0.35 A)" is 0_5_A_as_0_35_A. For a text without
/// ASCII letters and digits, returns the number.
std::string name_of_label(const std::string& label, std::size_t number);

/// Returns the positions of the objects of a scene, by the names that claims may use: "scene.ball.x",
/// "scene.guide.2.y" for the second of several points, and "scene.circle.radius".
std::vector<query::NamedFormula> shown_quantities(const scene::Scene& scene);

}  // namespace stepwire::plot
