#include "engine/view/scene/scene_states.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stepwire::scene {
namespace {

/// Column of a scene: its name, its shape, and its colour; for an empty colour it is the visibility.
struct NamedState {
  std::string name;
  std::size_t shape = 0;
  std::string color;
};

/// Returns the names of the colours that an object may have, if there are several.
std::vector<std::string> colors_of(const SceneObject& object) {
  std::vector<std::string> names;
  const auto add = [&](const SceneColor& color) {
    if (std::ranges::find(names, color.name) == names.end()) names.push_back(color.name);
  };
  for (const ColorRule& rule : object.colors) add(rule.color);
  if (object.crossed) add(*object.crossed);
  return names.size() > 1 ? names : std::vector<std::string>{};
}

std::vector<NamedState> states_of(const Scene& scene) {
  std::vector<NamedState> states;
  std::size_t first = 0;
  for (const SceneObject& object : scene.objects) {
    const std::size_t shapes = object.kind->name == "walls" ? object.walls.size() : 1;
    const std::size_t told =
        object.crossed ? shapes : std::min<std::size_t>(1, shapes);  // else all are alike
    for (std::size_t i = 0; i < told; ++i) {
      const std::string name =
          told > 1 ? fmt::format("scene.{}.{}", object.name, i + 1) : "scene." + object.name;
      for (const std::string& color : colors_of(object))
        if (!color.empty()) states.push_back({name + "." + color, first + i, color});
      if (object.when) states.push_back({name + ".shown", first + i, ""});
    }
    first += shapes;
  }
  return states;
}

double value_of(const NamedState& state, const std::vector<SceneShape>& shapes) {
  const SceneShape& shape = shapes[state.shape];
  return (state.color.empty() ? shape.shown : shape.color.name == state.color) ? 1.0 : 0.0;
}

}  // namespace

std::vector<query::RecordedName> scene_state_names(const Scene& scene) {
  std::vector<query::RecordedName> names;
  for (const NamedState& state : states_of(scene))
    names.push_back({state.name, unit::Dimension{}, scene.recording});
  return names;
}

void add_scene_states(const Scene& scene, std::vector<record::Recording>& recordings) {
  record::Recording& recording = recordings[scene.recording];
  const std::vector<NamedState> states = states_of(scene);
  if (states.empty()) return;
  const SceneView view = view_of(scene, recording);
  std::vector<table::Column> columns;
  for (const NamedState& state : states) columns.push_back({state.name, "1", {}});
  for (std::size_t row = 0; row < recording.table.rows(); ++row) {
    const std::vector<SceneShape> shapes = view.shapes(row_of(recording, row));
    for (std::size_t i = 0; i < states.size(); ++i) columns[i].values.push_back(value_of(states[i], shapes));
  }
  std::ranges::move(columns, std::back_inserter(recording.table.columns));
}

}  // namespace stepwire::scene
