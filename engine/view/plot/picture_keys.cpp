#include "engine/view/plot/panel_reading.hpp"

namespace stepwire::plot {

using yaml::form;

namespace {

void read_size(Figure& figure, const yaml::Node& node, const query::NamesReading& read) {
  const auto* size = read.pair(node, yaml::like("[640, 420]", {}));
  if (!size) return;
  read.take((*size)[0], form::whole(100, 4000), figure.width);
  read.take((*size)[1], form::whole(80, 4000), figure.height);
}

}  // namespace

const std::vector<yaml::KeyRow<Figure, query::NamesReading>>& picture_keys() {
  static const std::vector<yaml::KeyRow<Figure, query::NamesReading>> keys{
      {"title", "text above the picture", form::text(), &Figure::title},
      {"caption", "text below the picture on the gallery page", form::text(), &Figure::caption},
      {"own", "true: the source has no such picture; the gallery says so", form::truth(), &Figure::own},
      {"size", "width and height in pixels: [640, 420]", form::pair(form::whole(80, 4000)), read_size},
      {"panels", "list of panels in one picture", form::list(form::section("panel"), 1)},
      yaml::otherwise("", yaml::KeyRow<Figure, query::NamesReading>{
                              "columns", "how many panels stand side by side; two where it is not given",
                              form::whole(1, 6), &Figure::columns})};
  return keys;
}

}  // namespace stepwire::plot
