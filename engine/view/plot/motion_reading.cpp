#include <fmt/format.h>

#include "engine/analyse/query/number.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/view/plot/overlay.hpp"

namespace stepwire::plot {
namespace {

void read_heads(const yaml::Node& node, Motion& motion, const query::NamesReading& read) {
  constexpr double most = 100.0;
  const auto heads = query::read_number(node, read.names, read.subject, read.faults);
  if (heads) motion.heads = heads->value;
  if (heads && !(motion.heads >= 0.0 && motion.heads <= most))
    read.fault(node.mark, yaml::fault_text("{} arrow heads are not allowed; 0 to {} are", heads->text, most));
}

void read_motion(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  if (!read.check(node, motion_form())) return;
  const yaml::Node *x = node.find("x"), *y = node.find("y");
  if (!x || !y) return;
  auto across = read_coordinate(*x, "x", panel, yaml::below(read, "x"));
  auto up = read_coordinate(*y, "y", panel, yaml::below(read, "y"));
  if (!across || !up) return;
  Motion motion{std::move(*across), std::move(*up)};
  if (const yaml::Node* where = node.find("where")) motion.where = yaml::below(read, "where").formula(*where);
  if (const yaml::Node* heads = node.find("heads")) read_heads(*heads, motion, yaml::below(read, "heads"));
  if (const yaml::Node* color = node.find("color"))
    if (const auto index = yaml::below(read, "color").word(*color, *motion_form().find("color")))
      motion.color = motion_colors()[*index].doc;
  motion.recording =
      query::common_recording({&motion.x.formula, &motion.y.formula, motion.where ? &*motion.where : nullptr},
                              read.names, node, read.subject, read.faults);
  panel.motions.push_back(std::move(motion));
}

}  // namespace

const std::vector<yaml::Key::Word>& motion_colors() {
  static const std::vector<yaml::Key::Word> colors{// dark enough for a line
                                                   {"red", "#d11a1a"},
                                                   {"blue", "#0072B2"},
                                                   {"green", "#009E73"},
                                                   {"black", "#222222"}};
  return colors;
}

void read_motions(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  for (const yaml::Node& item : node.as_list()) read_motion(item, panel, read);
}

}  // namespace stepwire::plot
