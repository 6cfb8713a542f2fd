#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/scene/scene.hpp"
#include "engine/view/scene/scene_pointer.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::scene {

using yaml::form;

namespace {

/// Context for reading an object, with the formulas of its scene.
struct ObjectReading : query::NamesReading {
  std::vector<query::Formula>& formulas;

  ObjectReading(const query::NamesReading& read, std::vector<query::Formula>& formulas)
      : query::NamesReading(read), formulas(formulas) {}

  std::optional<FormulaIndex> add(std::optional<query::Formula> formula) const {
    if (!formula) return std::nullopt;
    formulas.push_back(std::move(*formula));
    return formulas.size() - 1;
  }
};

using ObjectTable = yaml::KeyTable<SceneObject, ObjectReading>;
using ObjectRow = ObjectTable::Row;

bool is_hexadecimal(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

std::optional<std::array<FormulaIndex, 2>> read_plane_point(const yaml::Node& node,
                                                            const ObjectReading& read) {
  const std::size_t before = read.faults.size();
  std::vector<query::Formula> place = query::read_place(node, read.names, read.subject, read.faults);
  if (place.size() == 2) return std::array{*read.add(std::move(place[0])), *read.add(std::move(place[1]))};
  if (read.faults.size() == before)
    read.fault(node.mark,
               fmt::format("a point of a scene has two coordinates, [x, y], and this has {}", place.size()));
  return std::nullopt;
}

void read_point(SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
  if (const auto point = read_plane_point(node, read)) object.points.push_back(*point);
}

const Outline* find_outline(const yaml::Node& node, const ObjectReading& read) {
  std::vector<std::string> known;
  for (const query::NamedOutline& named : read.names.outlines) {
    known.push_back(named.name);
    if (node.is_scalar() && named.name == node.text) return &named.outline;
  }
  read.fault(node.mark, fmt::format("'{}' is no block with a boundary, as a Region is", node.text) +
                            (known.empty() ? yaml::Message("; this file has none")
                                           : yaml::nearest_or_all(node.text, known, "there are")));
  return nullptr;
}

void read_walls(SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
  const Outline* outline = find_outline(node, read);
  if (!outline) return;
  if (outline->space)
    return read.fault(node.mark, fmt::format("'{}' lies in space, and a scene in the plane", node.text));
  for (const Outline::Line& line : outline->lines) {
    SceneWall& wall = object.walls.emplace_back(SceneWall{{}, !line.endless});
    for (const Outline::Point& point : line.points) wall.points.push_back({point[0], point[1]});
  }
}

void read_points(SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
  const SceneKind& kind = *object.kind;
  if (!node.is_list() || node.items.size() < kind.min_points || node.items.size() > kind.max_points)
    return read.fault(node.mark, fmt::format("'{}' is {}: [[0, 0], rig.position]", kind.name, kind.doc));
  for (const yaml::Node& item : node.items) read_point(object, item, read);
}

/// Returns the form of a point: [x, y], or the name of a recorded vector.
yaml::Key point_form() {
  return form::either({form::signal(), form::pair(form::expression())});
}

/// Returns the form of the value under the name of a kind.
yaml::Key value_of(const SceneKind& kind) {
  if (kind.max_points == 0) return kind.name == "walls" ? form::block() : form::text();
  return kind.max_points == 1 ? point_form()
                              : form::list(point_form(), static_cast<double>(kind.min_points),
                                           static_cast<double>(kind.max_points));
}

ObjectRow kind_row(const SceneKind& kind) {
  return yaml::one_of(
      "kind", ObjectRow{kind.name, kind.doc, value_of(kind),
                        [&kind](SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
                          object.kind = &kind;
                          if (kind.name == "walls") return read_walls(object, node, read);
                          if (kind.name == "text") return read.take(node, {}, object.text);
                          if (kind.max_points == 1) return read_point(object, node, read);
                          read_points(object, node, read);
                        }});
}

ObjectRow length_row(std::string name, std::string doc, std::optional<FormulaIndex> SceneObject::*member) {
  return {std::move(name), std::move(doc), form::expression(),
          [=](SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
            object.*member = read.add(query::read_length(node, read.names, read.subject, read.faults));
          }};
}

/// Reads a colour by its name or as "#rrggbb". A fault lists the colours and the `other` allowed words.
std::optional<SceneColor> read_scene_color(const std::string& text, yaml::Mark mark,
                                           const std::vector<std::string>& other,
                                           const query::NamesReading& read) {
  if (is_hexadecimal(text)) return SceneColor{"", text};
  std::vector<std::string> known;
  for (const SceneColor& color : scene_colors()) {
    if (color.name == text) return color;
    known.push_back(color.name);
  }
  known.insert(known.end(), other.begin(), other.end());
  yaml::Message message =
      fmt::format("there is no colour '{}'", text) + yaml::nearest_or_all(text, known, "there are");
  message += ", or a colour as \"#rrggbb\"";
  read.fault(mark, message);
  return std::nullopt;
}

void read_colors(SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
  const auto add = [&](const std::string& text, yaml::Mark mark, const std::vector<std::string>& other) {
    const auto one = read_scene_color(text, mark, other, read);
    if (one) object.colors.push_back({*one, {}});
    return one.has_value();
  };
  if (node.is_scalar()) return static_cast<void>(add(node.text, node.mark, {}));
  if (!node.is_map())
    return read.fault(node.mark, "is a colour, or colours by condition: {red: map.distance > 0, else: blue}");
  for (const yaml::Entry& entry : node.entries) {
    if (entry.key == "else") continue;
    const bool known = add(entry.key, entry.mark, {"else"});
    const auto when = read.add(read.formula(entry.value));
    if (known) object.colors.back().when = when;
  }
  if (const yaml::Node* last = node.find("else")) add(last->text, last->mark, {});
}

const yaml::Key& scene_color_form() {
  static const yaml::Key form = [] {
    std::vector<yaml::Key::Word> names;
    for (const SceneColor& named : scene_colors()) names.push_back({named.name, named.value});
    yaml::Key hexadecimal = form::string();
    hexadecimal.pattern = "^#[0-9A-Fa-f]{6}$";
    return form::either({form::words(std::move(names)), std::move(hexadecimal)});
  }();
  return form;
}

std::vector<ObjectRow> key_rows() {
  return {{"color",
           "a colour, or colours by condition, of which the first that holds counts: {red: map.distance > 0, "
           "else: blue}",
           form::either({scene_color_form(), form::names(form::expression())}), read_colors},
          {"when", "the object is shown while this expression is true", form::expression(),
           [](SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
             object.when = read.add(read.formula(node));
           }},
          yaml::beside({"ball", "circle", "point"},
                       length_row("radius", "of a ball, circle or point", &SceneObject::radius)),
          yaml::beside({"rod", "walls", "circle", "line"},
                       length_row("width", "of the line, or of the rod", &SceneObject::width)),
          yaml::beside({"walls"},
                       ObjectRow{"crossed",
                                 "colour of the wall that is crossed: that at the nearest boundary point, "
                                 "while the distance is above 0",
                                 scene_color_form(),
                                 [](SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
                                   object.crossed = read_scene_color(node.text, node.mark, {}, read);
                                 }}),
          yaml::beside(
              {"walls"},
              length_row("distance",
                         "from the boundary; without it the output distance of the block itself, which is "
                         "recorded",
                         &SceneObject::distance)),
          yaml::beside(
              {"walls"},
              ObjectRow{"nearest",
                        "point of the boundary; without it the block's output nearest, which is recorded",
                        point_form(),
                        [](SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
                          object.nearest = read_plane_point(node, read);
                        }}),
          yaml::beside({"text"},
                       ObjectRow{"at", "where the middle of the text is: [x, y]", point_form(), read_point}),
          yaml::beside({"text"}, length_row("size", "height of the letters", &SceneObject::size))};
}

std::vector<ObjectRow> object_rows() {
  std::vector<ObjectRow> rows;
  for (const SceneKind& kind : scene_kinds()) rows.push_back(kind_row(kind));
  for (ObjectRow& row : key_rows()) rows.push_back(std::move(row));
  return rows;
}

const ObjectTable& object_table() {
  static const ObjectTable table("an object", "{ball: rig.position, color: blue}", object_rows());
  return table;
}

/// Sets the distance and the nearest point of walls to the outputs of their Region, unless the file has these
/// keys.
void complete_walls(SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
  const ObjectReading crossed = yaml::below(read, "crossed");
  yaml::Node own = *node.find("walls");
  const std::string block = own.text;
  own.text = block + ".distance";
  if (!node.find("distance"))
    object.distance = read.add(query::read_length(own, read.names, crossed.subject, read.faults));
  own.text = block + ".nearest";
  if (!node.find("nearest") && object.walls.size() > 1) object.nearest = read_plane_point(own, crossed);
}

void check_needed(const SceneObject& object, const yaml::Node& node, const ObjectReading& read) {
  if (object.kind->name == "circle" && !node.find("radius"))
    read.fault(node.mark, "a circle needs a radius: {circle: [$x, $y], radius: 20 mm}");
  if (object.kind->name == "text" && !node.find("at"))
    read.fault(node.mark, "a text needs a place: {text: \"Follow the line\", at: [0 mm, 20 mm]}");
}

const yaml::Key& scene_object_form() {
  return object_table().form;
}

/// Reads one object, NAME: {KIND: .., color: ..}; its formulas are added to those of the scene.
std::optional<SceneObject> read_scene_object(const yaml::Entry& entry, std::vector<query::Formula>& formulas,
                                             const query::NamesReading& names) {
  const ObjectReading read(names, formulas);
  SceneObject object;
  object.name = entry.key;
  if (!object_table().read(entry.value, object, read) || !object.kind) return std::nullopt;
  if (object.colors.empty() || object.colors.back().when)
    object.colors.push_back({*std::ranges::find(scene_colors(), object.kind->color, &SceneColor::name), {}});
  check_needed(object, entry.value, read);
  if (object.crossed && !object.walls.empty()) complete_walls(object, entry.value, read);
  return object;
}

using SceneTable = yaml::KeyTable<Scene, query::NamesReading>;
using AnimationTable = yaml::KeyTable<SceneAnimation, query::NamesReading>;

const SceneTable& view_table() {
  const yaml::Key range = yaml::needed(yaml::like("[-5 mm, 5 mm]", form::pair(form::computed("m"))));
  static const SceneTable table(
      "a view", "{x: [-5 mm, 5 mm], y: [-5 mm, 5 mm]}",
      {{"x", "to the right: [-20 mm, 20 mm]", range, &Scene::x}, {"y", "upward", range, &Scene::y}});
  return table;
}

AnimationTable::Row time_row(std::string name, std::string doc,
                             std::optional<double> SceneAnimation::*member) {
  const yaml::Key form = form::computed("s");
  return {std::move(name), std::move(doc), form,
          [=](SceneAnimation& animation, const yaml::Node& node, const query::NamesReading& read) {
            const auto time = read.number(node, form);
            const double stop = read.names.diagram ? read.names.diagram->diagram().stop : 0.0;
            if (time && (*time < 0.0 || (stop > 0.0 && *time > stop)))
              read.fault(node.mark,
                         fmt::format("{} is not within the run, which lasts {} s", node.text, stop));
            animation.*member = time;
          }};
}

const AnimationTable& animation_table() {
  static const AnimationTable table(
      "an animation", "{from: 1 s, to: 6 s}",
      {time_row("from", "time in the run at which it begins", &SceneAnimation::from),
       time_row("to", "time in the run at which it ends", &SceneAnimation::to),
       {"speed", "seconds of the run in one second of the animation", form::above_zero(form::computed()),
        &SceneAnimation::speed},
       {"where", "of several runs, that with the first row for which this is true; without it the first",
        form::expression(), &SceneAnimation::where}});
  return table;
}

void read_objects(Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark, "'objects' are a map of name: object, such as {hand: {ball: rig.position}}");
  for (const yaml::Entry& entry : node.entries) {
    const query::NamesReading object_read("scene." + entry.key, read.names, read.faults);
    if (auto object = read_scene_object(entry, scene.formulas, object_read))
      scene.objects.push_back(std::move(*object));
  }
}

void read_animation(Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
  SceneAnimation& animation = scene.animation;
  if (!animation_table().read(node, animation, read)) return;
  if (animation.from && animation.to && !(*animation.from < *animation.to))
    yaml::below(read, "to").fault(node.find("to")->mark, "the end of an animation is behind its beginning");
}

void read_background(Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
  scene.background = node.text;
  if (node.is_scalar() && (node.text == "dark" || node.text == "light")) return;
  if (const auto color = read_scene_color(node.text, node.mark, {"dark", "light"}, read))
    scene.background = color->value;
}

const SceneTable& scene_table() {
  static const SceneTable table(
      "a scene", "{view: {x: [-5 mm, 5 mm], y: [-5 mm, 5 mm]}, objects: {..}}",
      {yaml::needed(
           SceneTable::Row{"view", "what is seen of the plane", view_table().form,
                           [](Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
                             view_table().read(node, scene, read);
                           }}),
       yaml::needed(SceneTable::Row{
           "objects", "by name, in the order in which they are drawn: {hand: {ball: rig.position}}",
           form::names(scene_object_form(), 1), read_objects}),
       yaml::otherwise("dark",
                       SceneTable::Row{"background", "dark, light, or a colour",
                                       form::either({form::word({"dark", "light"}), scene_color_form()}),
                                       read_background}),
       {"pointer", "what a pointer in the picture moves, where the scene is live", scene_pointer_form(),
        [](Scene&, const yaml::Node& node, const query::NamesReading& read) {
          read_scene_pointer(node, read);  // for its faults: a run without a page has no pointer
        }},
       {"animation", "what of the run scene.svg shows; without it the whole run", animation_table().form,
        read_animation}});
  return table;
}

std::size_t recording_of(const Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
  std::vector<const query::Formula*> formulas;
  for (const query::Formula& formula : scene.formulas) formulas.push_back(&formula);
  if (scene.animation.where) formulas.push_back(&*scene.animation.where);
  return query::common_recording(formulas, read.names, node, read.subject, read.faults);
}

}  // namespace

const yaml::Key& scene_form() {
  return scene_table().form;
}

Scene read_scene(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  const query::NamesReading read("scene", names, faults);
  Scene scene;
  scene.mark = node.mark;
  if (!scene_table().read(node, scene, read)) return scene;
  scene.recording = recording_of(scene, node, read);
  for (const query::RecordedName& state : scene_state_names(scene))  // names must be unique
    if (names.find(state.name))
      read.fault(node.mark,
                 fmt::format("'{}' is recorded already, and would be what the scene shows; rename its object",
                             state.name));
  return scene;
}

const std::vector<SceneKind>& scene_kinds() {
  constexpr std::size_t any_number = 1000;
  static const std::vector<SceneKind> kinds{
      {"ball", "a ball about a point", 1, 1, "yellow"},
      {"rod", "a rod from a point to another", 2, 2, "grey"},
      {"walls", "the boundary of a block, such as a Region, by its name; each closed line is a wall", 0, 0,
       "blue"},
      {"circle", "a line around a point, its centre", 1, 1, "white"},
      {"line", "a line through points", 2, any_number, "green"},
      {"point", "a spot", 1, 1, "blue"},
      {"text", "words, for whoever looks at the scene", 0, 0, "white"},
  };
  return kinds;
}

const std::vector<SceneColor>& scene_colors() {
  static const std::vector<SceneColor> colors{
      {"blue", "#2f80ff"},   {"red", "#ff3b30"},    {"green", "#30d158"}, {"yellow", "#ffcc00"},
      {"orange", "#ff9f0a"}, {"purple", "#bf5af2"}, {"cyan", "#3fc8e4"},  {"grey", "#98a2ad"},
      {"white", "#f5f7fa"},  {"black", "#11161c"}};
  return colors;
}

}  // namespace stepwire::scene
