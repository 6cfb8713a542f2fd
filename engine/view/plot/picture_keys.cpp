#include "engine/view/plot/panel_reading.hpp"

namespace stepwire {
namespace {

void read_size(Figure& figure, const Node& node, const NamesReading& read) {
  const auto* size = read.pair(node, like("[640, 420]", {}));
  if (!size) return;
  read.take((*size)[0], form::whole(100, 4000), figure.width);
  read.take((*size)[1], form::whole(80, 4000), figure.height);
}

}  // namespace

const std::vector<KeyRow<Figure, NamesReading>>& picture_keys() {
  static const std::vector<KeyRow<Figure, NamesReading>> keys{
      {"title", "text above the picture", form::text(), &Figure::title},
      {"caption", "text below the picture on the gallery page", form::text(), &Figure::caption},
      {"own", "true: the source has no such picture; the gallery says so", form::truth(), &Figure::own},
      {"size", "width and height in pixels: [640, 420]", form::pair(form::whole(80, 4000)), read_size},
      {"panels", "list of panels in one picture", form::list(form::section("panel"), 1)},
      otherwise("", KeyRow<Figure, NamesReading>{
                        "columns", "how many panels stand side by side; two where it is not given",
                        form::whole(1, 6), &Figure::columns})};
  return keys;
}

}  // namespace stepwire
