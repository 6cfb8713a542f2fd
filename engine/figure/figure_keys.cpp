#include "engine/figure/panel_reading.hpp"

namespace stepwire {

const std::vector<FigureKey>& panel_keys() {
  static const std::vector<FigureKey> keys{
      {"title", "text above the panel"},
      {"where", "draws only rows for which this expression is true"},
      {"rows", "all (default), or final: only the last row of each run of a sweep"},
      {"legend", "texts of the legend, in the order of the curves"},
      {"equal", "true: one unit is as long on both axes"},
      {"x_range", "ends of the axis: [-5 mm, 5 mm]"},
      {"y_range", "ends of the axis"},
      {"x_label", "text at the axis, to which the unit is added"},
      {"y_label", "text at the axis"},
      {"z_label", "text at the axis"},
      {"color_label", "text at the colour bar"},
      {"z_range", "ends of the axis"},
      {"color_range", "values at both ends of the colour bar"},
      {"log", "axes with a logarithmic scale: x, y, color, or a list"},
      {"boundary",
       "expression of x and y in SI units (or a list); a line is drawn where it is zero: x - 5 mm. What is "
       "recorded stands for its value in the first row that 'where' selects"},
      {"note",
       "expression whose value in the first row that 'where' selects is told in a corner: {signal: "
       "normalised, "
       "label: error}"},
      {"region", "name of a Region (or a list): its boundary is drawn, and its inside shaded"},
      {"region_line", "how the boundary of a region is drawn: line or dashes"},
      {"marks", "points with names, drawn on top: {A: [0 mm, 20 mm]}; a list of points numbers them"},
      {"texts", "texts in the plane, each about its point: {authorized region: [0 mm, 200 mm]}"},
      {"motion",
       "the way of a point (or a list), drawn as a line with arrow heads: {x: hand.1, y: hand.2, where: time "
       "< "
       "2 s, heads: 8, color: red}"},
      {"rose",
       "what happens at a point in each direction (or a list), drawn as a disc with spokes as long as "
       "`value`: "
       "{x: at.1, y: at.2, angle: phi, value: force in N, where: time > 1 s, at: [5 mm, 0 mm], radius: 4 mm, "
       "name: D2}"}};
  return keys;
}

const std::vector<FigureKey>& picture_keys() {
  static const std::vector<FigureKey> keys{
      {"title", "text above the picture"},
      {"caption", "text below the picture on the gallery page"},
      {"own", "true: the source has no such picture; the gallery says so"},
      {"size", "width and height in pixels: [640, 420]"},
      {"panels", "list of panels in one picture"},
      {"columns", "how many panels stand side by side"}};
  return keys;
}

}  // namespace stepwire
