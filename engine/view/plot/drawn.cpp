#include "engine/view/plot/drawn.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/formula.hpp"

namespace stepwire::plot {
namespace {

using Names = std::vector<std::string>;

/// Adds quantities under each name of a place.
class Drawn {
 public:
  Drawn(Names places, std::vector<query::NamedFormula>& drawn) : places_(std::move(places)), drawn_(drawn) {}

  void add(const std::string& name, const std::string& text) const {
    for (const std::string& place : places_) drawn_.push_back({fmt::format("{}.{}", place, name), text});
  }
  void add(const std::string& name, const query::Formula& formula) const { add(name, formula.text); }
  void add(const Names& names, const std::string& below, const std::string& text) const {
    for (const std::string& name : names) add(name + below, text);
  }

 private:
  Names places_;
  std::vector<query::NamedFormula>& drawn_;
};

/// Returns the names with a number appended, and also without it if it is 1.
Names numbered_names(const Names& names, std::size_t number) {
  Names result;
  for (const std::string& name : names) result.push_back(fmt::format("{}.{}", name, number));
  if (number == 1) result.insert(result.end(), names.begin(), names.end());
  return result;
}

/// Adds the quantities over the panel: "figure.motion.x", "figure.rose.2.value".
void add_overlays(const Panel& panel, const Drawn& drawn) {
  for (std::size_t i = 0; i < panel.motions.size(); ++i)
    for (const std::string& name : numbered_names({"motion"}, i + 1)) {
      const Motion& motion = panel.motions[i];
      drawn.add(name + ".x", motion.x.formula);
      drawn.add(name + ".y", motion.y.formula);
      if (motion.where) drawn.add(name + ".where", *motion.where);
    }
  for (std::size_t i = 0; i < panel.roses.size(); ++i)
    for (const std::string& name : numbered_names({"rose"}, i + 1)) {
      const Rose& rose = panel.roses[i];
      drawn.add(name + ".x", rose.x.formula);
      drawn.add(name + ".y", rose.y.formula);
      drawn.add(name + ".angle", rose.angle.formula);
      drawn.add(name + ".value", rose.value.formula);
      if (rose.where) drawn.add(name + ".where", *rose.where);
    }
}

/// True if the texts of the legend name rows, not the curves of `by`.
bool names_rows(const Panel& panel) {
  return !panel.legend.empty() && !panel.series.contains("by");
}

/// Adds the rows of a channel by their texts; a single x for all y has the texts of all.
void add_labelled(const Panel& panel, const std::string& channel, const std::vector<query::Series>& rows,
                  const Drawn& drawn) {
  const std::size_t count = names_rows(panel) ? panel.legend.size() : rows.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= rows.size() && rows.size() != 1) continue;
    const query::Series& row = rows[i < rows.size() ? i : 0];
    const std::string& label = names_rows(panel) ? panel.legend[i] : row.label;
    drawn.add(fmt::format("{}.{}", channel, name_of_label(label, i + 1)), row.formula);
  }
}

/// Adds the rows. Keys of the file have precedence, since a text may be the same.
void add_rows(const Panel& panel, const Drawn& drawn) {
  if (panel.where) drawn.add("where", *panel.where);
  for (const auto& [key, rows] : panel.series)
    for (std::size_t i = 0; i < rows.size(); ++i)
      drawn.add(numbered_names({key}, i + 1), "", rows[i].formula.text);
  for (const auto& [key, rows] : panel.series) {
    add_labelled(panel, key, rows, drawn);
    const std::string axis = name_of_label(panel.axis(key).label, 0);
    if (axis == "0") continue;
    for (std::size_t i = 0; i < rows.size(); ++i)
      drawn.add(numbered_names({axis}, i + 1), "", rows[i].formula.text);
    add_labelled(panel, axis, rows, drawn);
  }
}

/// Returns the numbers of the curves of a swept parameter, in the order of the legend.
std::vector<double> numbers_of_curves(const query::Series& by, const query::SymbolTable& names) {
  const query::RecordedName* swept = names.find(by.formula.text);
  if (!swept) return {};
  std::vector<double> numbers = swept->values;
  for (std::size_t word = 0; word < swept->words.size(); ++word) numbers.push_back(static_cast<double>(word));
  return numbers;
}

/// Adds the curves of `by` by their texts, with the condition of each.
void add_curves(const Panel& panel, const query::SymbolTable& names, const Drawn& drawn) {
  const query::Series* by = panel.find("by");
  if (!by) return;
  const std::vector<double> numbers = numbers_of_curves(*by, names);
  if (numbers.size() != panel.legend.size()) return;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string number = query::number_text(numbers[i], by->formula.dimension, names);
    drawn.add("by." + name_of_label(panel.legend[i], i + 1),
              fmt::format("{} == {}", by->formula.text, number));
  }
}

/// Adds the recorded outputs of the blocks whose boundaries are drawn.
void add_regions(const Panel& panel, const query::SymbolTable& names, const Drawn& drawn) {
  for (std::size_t i = 0; i < panel.regions.size(); ++i)
    for (const query::RecordedName& column : names.columns)
      if (column.name.starts_with(panel.regions[i].name + "."))
        drawn.add(numbered_names({"region"}, i + 1), column.name.substr(panel.regions[i].name.size()),
                  column.name);
}

/// Replaces x and y in an expression of the plane by the quantities along these axes.
std::string at_drawn_point(const std::string& text, const Panel& panel) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::string name = query::name_at(text, i);
    const bool of_axis = name == "x" || name == "y";
    const query::Series* axis = of_axis ? panel.find(name) : nullptr;
    const std::size_t length = std::max<std::size_t>(name.size(), 1);
    result += axis ? "(" + axis->formula.text + ")" : text.substr(i, length);
    i += length;
  }
  return result;
}

void add_points(const std::string& key, const std::vector<MarkedPoint>& points, const Panel& panel,
                const query::SymbolTable& names, const Drawn& drawn) {
  const auto text = [&](const std::string& axis, double value) {
    const query::Series* series = panel.find(axis);
    return series ? query::number_text(series->unit.to_si(value), series->formula.dimension, names)
                  : fmt::format("{}", value);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string name = fmt::format("{}.{}", key, name_of_label(points[i].name, i + 1));
    drawn.add(name + ".x", text("x", points[i].x));
    drawn.add(name + ".y", text("y", points[i].y));
  }
}

void add_panel(const Panel& panel, const query::SymbolTable& names, const Drawn& drawn) {
  add_rows(panel, drawn);
  add_overlays(panel, drawn);
  add_curves(panel, names, drawn);
  add_regions(panel, names, drawn);
  for (std::size_t i = 0; i < panel.boundaries.size(); ++i)
    drawn.add(numbered_names({"boundary"}, i + 1), "",
              at_drawn_point(query::substitute(panel.boundaries[i].text, names).text, panel));
  add_points("marks", panel.marks, panel, names, drawn);
  add_points("texts", panel.texts, panel, names, drawn);
  for (const query::NamedFormula& one : panel.shown) drawn.add(one.name, one.text);
}

/// Returns the names of a panel by its numbers. The number of a panel always follows that of its picture.
Names numbered_places(const std::vector<Figure>&, std::size_t picture, std::size_t panel) {
  Names places = numbered_names({fmt::format("figure.{}", picture + 1)}, panel + 1);
  if (picture == 0 && panel == 0) places.emplace_back("figure");
  return places;
}

/// Returns the names of a panel by its title and that of its picture. Numbers have precedence.
Names titled_places(const std::vector<Figure>& figures, std::size_t picture, std::size_t panel) {
  const Figure& figure = figures[picture];
  Names pictures{fmt::format("figure.{}", picture + 1)};
  if (picture == 0) pictures.emplace_back("figure");
  const std::string title = name_of_label(figure.title, 0),
                    name = name_of_label(figure.panels[panel].title, 0);
  Names places;
  if (title != "0") {
    pictures.push_back("figure." + title);
    places = numbered_names({pictures.back()}, panel + 1);
  }
  if (name != "0")
    for (const std::string& place : pictures) places.push_back(place + "." + name);
  return places;
}

void add_places(const scene::SceneObject& object, const scene::Scene& scene,
                std::vector<query::NamedFormula>& shown) {
  for (std::size_t point = 0; point < object.points.size(); ++point)
    for (const std::string& name : numbered_names({"scene." + object.name}, point + 1))
      for (const std::size_t axis : {0u, 1u})
        shown.push_back({name + (axis == 0 ? ".x" : ".y"), scene.formulas[object.points[point][axis]].text});
}

}  // namespace

std::string name_of_label(const std::string& label, std::size_t number) {
  std::string name;
  for (const char c : label) {
    const bool letter = query::is_word(c) && c != '_';
    if (letter) name += c;
    if (!letter && !name.empty() && name.back() != '_') name += '_';
  }
  if (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? std::to_string(number) : name;
}

std::vector<query::NamedFormula> drawn_quantities(const std::vector<Figure>& figures,
                                                  const query::SymbolTable& names) {
  std::vector<query::NamedFormula> drawn;
  for (const auto& names_of_places : {numbered_places, titled_places})
    for (std::size_t picture = 0; picture < figures.size(); ++picture)
      for (std::size_t panel = 0; panel < figures[picture].panels.size(); ++panel)
        add_panel(figures[picture].panels[panel], names,
                  Drawn(names_of_places(figures, picture, panel), drawn));
  return drawn;
}

std::vector<query::NamedFormula> shown_quantities(const scene::Scene& scene) {
  std::vector<query::NamedFormula> shown;
  for (const scene::SceneObject& object : scene.objects) {
    add_places(object, scene, shown);
    if (object.radius)
      shown.push_back({fmt::format("scene.{}.radius", object.name), scene.formulas[*object.radius].text});
  }
  return shown;
}

}  // namespace stepwire::plot
