#include <fmt/format.h>

#include <array>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/overlay.hpp"

namespace stepwire {
namespace {

const std::string motion_subject = "figure.motion";

/// Words for the colours in which a motion is drawn, dark enough for a line.
std::optional<std::string> motion_color(const std::string& word) {
  constexpr std::array<std::array<const char*, 2>, 4> colors{
      {{"red", "#d11a1a"}, {"blue", "#0072B2"}, {"green", "#009E73"}, {"black", "#222222"}}};
  for (const auto& [name, color] : colors)
    if (word == name) return color;
  return std::nullopt;
}

void read_heads(const Node& node, Motion& motion, const Names& names, Faults& faults) {
  constexpr double most = 100.0;
  const auto heads = read_number(node, names, motion_subject + ".heads", faults);
  if (heads) motion.heads = heads->value;
  if (heads && !(motion.heads >= 0.0 && motion.heads <= most))
    faults.add({{names.file, node.mark},
                motion_subject + ".heads",
                fmt::format("{} arrow heads are not allowed; 0 to {} are", heads->text, most),
                {}});
}

void read_color(const Node& node, Motion& motion, const Names& names, Faults& faults) {
  if (const auto color = motion_color(node.text))
    motion.color = *color;
  else
    faults.add({{names.file, node.mark},
                motion_subject + ".color",
                fmt::format("'{}' is no colour of a motion; it is one of red, blue, green, black", node.text),
                {}});
}

void read_motion(const Node& node, Panel& panel, const Names& names, Faults& faults) {
  const Node *x = node.find("x"), *y = node.find("y"), *where = node.find("where");
  if (!x || !y)
    return faults.add({{names.file, node.mark},
                       motion_subject,
                       "a motion is a map with x and y: {x: hand.1, y: hand.2}",
                       {}});
  check_keys(node, motion_keys(), "a motion", names, motion_subject, faults);
  auto across = read_coordinate(*x, "x", panel, names, motion_subject + ".x", faults);
  auto up = read_coordinate(*y, "y", panel, names, motion_subject + ".y", faults);
  if (!across || !up) return;
  Motion motion{std::move(*across), std::move(*up)};
  if (where) motion.where = read_formula(*where, names, motion_subject + ".where", faults);
  if (const Node* heads = node.find("heads")) read_heads(*heads, motion, names, faults);
  if (const Node* color = node.find("color")) read_color(*color, motion, names, faults);
  motion.recording =
      common_recording({&motion.x.formula, &motion.y.formula, motion.where ? &*motion.where : nullptr}, names,
                       node, motion_subject, faults);
  panel.motions.push_back(std::move(motion));
}

}  // namespace

void read_motions(const Node& node, Panel& panel, const Names& names, Faults& faults) {
  for (const Node& item : items_of(node)) read_motion(item, panel, names, faults);
}

}  // namespace stepwire
