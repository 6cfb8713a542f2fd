#include "engine/view/plot/panel_reading.hpp"

namespace stepwire {
namespace {

void read_size(Figure& figure, const Node& node, const KeyReading& read) {
  static const FigureKey across{"size", "", ValueType::whole, false, {}, {}, false, 100, 4000};
  static const FigureKey up{"size", "", ValueType::whole, false, {}, {}, false, 80, 4000};
  if (!node.is_list() || node.items.size() != 2)
    return read.fault(node.mark, "size", "size takes width and height in pixels: [640, 420]");
  figure.width = read.whole(node.items[0], across).value_or(across.low);
  figure.height = read.whole(node.items[1], up).value_or(up.low);
}

KeyOf<Figure> whole_key(FigureKey row, int Figure::*member) {
  return {row, [=](Figure& figure, const Node& node, const KeyReading& read) {
            figure.*member = read.whole(node, row).value_or(row.low);
          }};
}

}  // namespace

const std::vector<KeyOf<Figure>>& picture_keys() {
  static const std::vector<KeyOf<Figure>> keys{
      text_key("title", "text above the picture", &Figure::title),
      text_key("caption", "text below the picture on the gallery page", &Figure::caption),
      truth_key("own", "true: the source has no such picture; the gallery says so", &Figure::own),
      {{"size", "width and height in pixels: [640, 420]", ValueType::size_pair}, read_size},
      {{"panels", "list of panels in one picture", ValueType::panels}},
      whole_key(
          {"columns", "how many panels stand side by side", ValueType::whole, false, {}, {}, false, 1, 6},
          &Figure::columns)};
  return keys;
}

}  // namespace stepwire
