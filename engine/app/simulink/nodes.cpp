#include "engine/app/simulink/nodes.hpp"

#include <algorithm>
#include <cctype>

namespace stepwire::simulink {

namespace {

bool is_name(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/// Makes a node of a number or formula in a list, where no sign of a formula is needed.
yaml::Node item_node(const Cell& cell) {
  return word(cell.formula());
}

}  // namespace

yaml::Node word(std::string text) {
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = std::move(text);
  return node;
}

yaml::Node quoted(std::string text) {
  yaml::Node node = word(std::move(text));
  node.quoted = true;
  return node;
}

yaml::Node list_of(std::vector<yaml::Node> items) {
  yaml::Node node;
  node.kind = yaml::Node::Kind::list;
  node.items = std::move(items);
  return node;
}

yaml::Node map_of(std::vector<std::pair<std::string, yaml::Node>> entries) {
  yaml::Node node;
  node.kind = yaml::Node::Kind::map;
  for (auto& [key, value] : entries) add(node, std::move(key), std::move(value));
  return node;
}

void add(yaml::Node& map, std::string key, yaml::Node value) {
  map.kind = yaml::Node::Kind::map;
  map.entries.push_back({std::move(key), {}, std::move(value)});
}

yaml::Node cell_node(const Cell& cell) {
  if (cell.text.empty()) return word(cell.formula());
  return word((is_name(cell.text) ? "$" : "= ") + cell.text);
}

yaml::Node list_node(const Value& value) {
  if (value.is_missing) return cell_node(value.cells[0]);
  std::vector<yaml::Node> items;
  for (const Cell& cell : value.cells) items.push_back(item_node(cell));
  return list_of(std::move(items));
}

yaml::Node rows_node(const Value& value) {
  if (value.is_missing) return cell_node(value.cells[0]);
  std::vector<yaml::Node> rows;
  for (std::size_t i = 0; i < value.rows; ++i) {
    std::vector<yaml::Node> row;
    for (std::size_t j = 0; j < value.columns; ++j) row.push_back(item_node(value.at(i, j)));
    rows.push_back(list_of(std::move(row)));
  }
  return list_of(std::move(rows));
}

yaml::Node value_node(const Value& value) {
  if (value.is_scalar()) return cell_node(value.cells[0]);
  return value.is_vector() ? list_node(value) : rows_node(value);
}

}  // namespace stepwire::simulink
