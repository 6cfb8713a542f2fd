#include "engine/model/diagram/written.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engine/model/diagram/resolve.hpp"

namespace stepwire::diagram {

namespace {

yaml::Node number(double value) {
  return written_text(fmt::format("{}", value));
}

template <class Range>
yaml::Node list_of_numbers(const Range& values) {
  yaml::Node list;
  list.kind = yaml::Node::Kind::list;
  for (const double value : values) list.items.push_back(number(value));
  return list;
}

yaml::Node list_of_rows(const Eigen::MatrixXd& matrix) {
  yaml::Node rows;
  rows.kind = yaml::Node::Kind::list;
  for (const auto& row : matrix.rowwise()) rows.items.push_back(list_of_numbers(row));
  return rows;
}

/// Adds the unit. A pure number written with a unit (deg, %) gets one as well, since its place may require a
/// unit.
yaml::Node with_unit(yaml::Node value, const std::optional<unit::Dimension>& dimension) {
  if (!dimension) return value;
  if (value.is_scalar() && *dimension != unit::Dimension{}) {
    value.text += " " + unit::si_name(*dimension);
    return value;
  }
  yaml::Node map;
  add_key(map, "value", std::move(value));
  add_key(map, "unit", written_text(unit::si_name(*dimension)));
  return map;
}

/// Returns an element of a list, with its unit if it has one.
yaml::Node number_with_unit(double value, const std::optional<unit::Dimension>& dimension) {
  const std::string name = dimension ? unit::si_name(*dimension) : "1";
  return name == "1" ? number(value) : written_text(fmt::format("{} {}", value, name));
}

struct Writer {
  const ParameterSpec& spec;
  const std::optional<unit::Dimension>& dimension;

  std::optional<yaml::Node> operator()(double value) const {
    if (spec.kind == ParameterKind::word) return written_text(spec.words[static_cast<std::size_t>(value)]);
    return std::isfinite(value) ? std::optional(with_unit(number(value), dimension)) : std::nullopt;
  }
  std::optional<yaml::Node> operator()(bool value) const { return written_text(value ? "true" : "false"); }
  std::optional<yaml::Node> operator()(const std::string& text) const { return written_filled_in(text); }
  std::optional<yaml::Node> operator()(const Eigen::VectorXd& vector) const {
    if (vector.size() == 0 || !vector.allFinite()) return std::nullopt;
    if (spec.kind == ParameterKind::per_element) return written_numbers(vector, dimension);
    return with_unit(list_of_numbers(vector), dimension);
  }
  std::optional<yaml::Node> operator()(const Eigen::MatrixXd& matrix) const {
    if (matrix.size() == 0 || !matrix.allFinite()) return std::nullopt;
    return with_unit(list_of_rows(matrix), dimension);
  }
  std::optional<yaml::Node> operator()(const Value::List& list) const {
    yaml::Node node;
    node.kind = yaml::Node::Kind::list;
    for (const Value& item : list)
      node.items.push_back(std::visit(*this, item.content).value_or(yaml::Node{}));
    return node;
  }
  std::optional<yaml::Node> operator()(const Value::Map& map) const {
    yaml::Node node;
    node.kind = yaml::Node::Kind::map;
    for (const ValueEntry& entry : map)
      add_key(node, entry.key, std::visit(*this, entry.value.content).value_or(yaml::Node{}));
    return node;
  }
};

}  // namespace

yaml::Node written_text(std::string text) {
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = std::move(text);
  return node;
}

yaml::Node written_filled_in(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '$' ? 2 : 1, c);
  return written_text(std::move(result));
}

yaml::Node written_signal(std::string name) {
  yaml::Node node = written_text(std::move(name));
  node.quoted = !names_signal(node);
  return node;
}

yaml::Node written_numbers(const Eigen::VectorXd& numbers, const std::optional<unit::Dimension>& dimension,
                           Eigen::Index columns) {
  if (columns > 1)
    return with_unit(list_of_rows(numbers.reshaped(numbers.size() / columns, columns)), dimension);
  return with_unit(numbers.size() == 1 ? number(numbers[0]) : list_of_numbers(numbers), dimension);
}

yaml::Node written_each(const Eigen::VectorXd& numbers, const EachUnit& each, Eigen::Index columns) {
  const Eigen::Index rows = numbers.size() / columns;
  yaml::Node all;
  all.kind = yaml::Node::Kind::list;
  for (Eigen::Index row = 0; row < rows; ++row) {
    yaml::Node line;
    line.kind = yaml::Node::Kind::list;
    for (Eigen::Index k = row; k < numbers.size(); k += rows)
      line.items.push_back(number_with_unit(numbers[k], each[static_cast<std::size_t>(k)]));
    all.items.push_back(columns == 1 ? std::move(line.items.front()) : std::move(line));
  }
  return all;
}

std::optional<yaml::Node> written_value(const ParameterSpec& spec, const Value& value,
                                        const std::optional<unit::Dimension>& dimension) {
  return std::visit(Writer{spec, dimension}, value.content);
}

yaml::Node written_every(const Every& every, const std::optional<unit::Dimension>& time) {
  const auto seconds = [&](double number) {
    return written_numbers(Eigen::VectorXd::Constant(1, number), time);
  };
  if (every.offset == 0.0) return seconds(every.period);
  yaml::Node map;
  add_key(map, "period", seconds(every.period));
  add_key(map, "offset", seconds(every.offset));
  return map;
}

void add_key(yaml::Node& map, std::string key, yaml::Node value) {
  map.kind = yaml::Node::Kind::map;
  map.entries.push_back({std::move(key), {}, std::move(value)});
}

}  // namespace stepwire::diagram
