#pragma once

#include "engine/view/scene/scene.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::testing {

/// A pen over a square of 4 mm with a hole of 2 mm, as samples.hpp draws it.
inline query::SymbolTable pen_names() {
  const unit::Dimension metre{{1}}, second{{0, 0, 1}}, newton{{1, 1, -2}};
  return {"d.yaml",
          {{"time", second, {}},
           {"run", {}, {}},
           {"pen.1", metre, 0},
           {"pen.2", metre, 0},
           {"map.distance", metre, 0},
           {"map.nearest.1", metre, 0},
           {"map.nearest.2", metre, 0},
           {"push", newton, 0},
           {"slow", newton, 1}},
          {{"reach", 3e-3, metre}},
          {"hole.distance"},
          "",
          nullptr,
          {{"map", square_outline()}, {"hole", square_outline()}, {"ball", {true, {}}}}};
}

/// Makes two runs in which the pen moves along x from the middle of the hole to x = 4 mm, at y = 0 and 1 mm.
/// It crosses the inner and then the outer wall.
inline record::Recording pen_recording(int rows) {
  record::Recording recording;
  recording.starts.clear();
  for (const query::RecordedName& name : pen_names().columns)
    if (name.name != "slow") recording.table.columns.push_back({name.name, "", {}});
  for (const double run : {0.0, 1.0}) {
    recording.starts.push_back(recording.table.rows());
    for (int i = 0; i <= rows; ++i) {
      const double t = static_cast<double>(i) / rows, x = 4e-3 * t, y = 1e-3 * run;
      const double middle = 1.5e-3, wall = x < middle ? 1e-3 : 2e-3;  // the nearer one of both
      const double row[] = {t, run, x, y, std::abs(x - middle) - 0.5e-3, wall, y, 5.0};
      for (std::size_t k = 0; k < std::size(row); ++k) recording.table.columns[k].values.push_back(row[k]);
    }
  }
  return recording;
}

struct ReadScene {
  scene::Scene scene;
  std::string faults;
};

inline ReadScene read_scene_of(const std::string& text) {
  const yaml::Document document = yaml::parse_document(text, "d.yaml");
  yaml::Faults faults;
  scene::Scene scene = scene::read_scene(document.root, pen_names(), faults);
  return {std::move(scene), all_text(faults)};
}

/// A scene with these objects and further keys, without faults.
inline scene::Scene scene_of(const std::string& objects, const std::string& more = "") {
  auto read =
      read_scene_of("{view: {x: [-5 mm, 5 mm], y: [-4 mm, 4 mm]}, objects: {" + objects + "}" + more + "}");
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  return std::move(read.scene);
}

/// The faults of a scene with these objects.
inline std::string scene_faults(const std::string& objects, const std::string& more = "") {
  return read_scene_of("{view: {x: [-5 mm, 5 mm], y: [-4 mm, 4 mm]}, objects: {" + objects + "}" + more + "}")
      .faults;
}

/// One of everything.
inline const std::string all_objects =
    "walls: {walls: map, crossed: red}, ring: {circle: [0, 0], radius: $reach}, "
    "rod: {rod: [[-5 mm, -4 mm], pen]}, way: {line: [pen, map.nearest], when: map.distance > 0}, "
    "bow: {line: [[0, 0], pen, [1 mm, 1 mm]]}, goal: {point: map.nearest, when: map.distance > 0}, "
    "ball: {ball: pen, color: {red: map.distance > 0, else: yellow}}, "
    "hint: {text: \"a < b\", at: [0 mm, 3 mm], when: map.distance > 0}";

}  // namespace stepwire::testing
