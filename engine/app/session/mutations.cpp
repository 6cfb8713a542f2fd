#include "engine/app/session/mutations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "engine/model/diagram/output_names.hpp"

namespace stepwire::session {

namespace {

constexpr std::size_t most_versions = 4;  // of one wire, where the file refuses the others

/// Signal of a diagram, with its unit and size.
struct NamedSignal {
  std::string name;
  std::optional<unit::Dimension> dimension;
  Eigen::Index size;
};

std::vector<NamedSignal> signals_in(const plan::Plan& plan) {
  std::vector<NamedSignal> signals;
  const diagram::Diagram& diagram = plan.diagram;
  for (std::size_t b = 0; b < diagram.blocks.size(); ++b)
    for (std::size_t o = 0; o < diagram.blocks[b].type().outputs.size(); ++o)
      signals.push_back({diagram::output_name(diagram.blocks[b].name, diagram.blocks[b].type(), o),
                         diagram.output_dimensions[b][o], plan.blocks[b].outputs[o].size});
  return signals;
}

/// Returns other signals of the unit and size of one, beginning behind it.
std::vector<std::string> others_like(const std::string& name, const std::vector<NamedSignal>& signals) {
  const auto begin = std::ranges::find(signals, name, &NamedSignal::name);
  std::vector<std::string> others;
  if (begin == signals.end()) return others;
  const auto take = [&](const NamedSignal& one) {
    const bool alike = one.dimension == begin->dimension && one.size == begin->size;
    if (alike && one.name != name && others.size() < most_versions) others.push_back(one.name);
  };
  std::for_each(begin, signals.end(), take);
  std::for_each(signals.begin(), begin, take);
  return others;
}

std::set<std::string> swept_in(const diagram::Diagram& diagram) {
  std::set<std::string> names;
  if (diagram.sweep)
    for (const diagram::Sweep::Axis& axis : diagram.sweep->axes) names.insert(axis.parameter);
  return names;
}

constexpr double factors[] = {2.0, 0.5, -1.0};

/// Returns the number of "20 degC" or "3 mm" times a factor, in the same unit.
std::string times(double factor, const std::string& text) {
  char* unit = nullptr;
  const double number = std::strtod(text.c_str(), &unit);
  return fmt::format("{}{}", factor * number, unit);
}

bool is_zero(const std::string& text) {
  return std::strtod(text.c_str(), nullptr) == 0.0;
}

void add_setting(const std::string& name, const std::string& old, const std::string& version,
                 diagram::Setting setting, std::vector<Mutation>& all) {
  Mutation mutation{Mutation::Kind::parameter, "parameter " + name, old};
  mutation.versions.push_back({version, std::move(setting)});
  all.push_back(std::move(mutation));
}

/// Adds the wrong versions of a number. One in degC changes on its own scale, since a formula refuses a
/// multiple of it.
void add_number(const std::string& name, const std::string& text, std::vector<Mutation>& all) {
  const std::string own = text.starts_with("=") ? text.substr(1) : text;
  const bool is_celsius = own == text && text.ends_with("degC");
  if (is_celsius && is_zero(text)) return;
  for (const double factor : factors) {
    const std::string formula = fmt::format("{}({})", factor == -1.0 ? "-" : fmt::format("{}*", factor), own);
    const std::string value = is_celsius ? times(factor, text) : formula;
    add_setting(name, text, value, {name, is_celsius ? value : "= " + formula}, all);
  }
}

/// Returns the numbers of a list such as "[1 m, 2 m]"; an empty list for others.
std::vector<std::string> elements_of(const std::string& text) try {
  std::vector<std::string> elements;
  const yaml::Node list = diagram::value_of_text(text, "");
  for (const yaml::Node& item : list.items) {
    if (!item.is_scalar() || !unit::parse_quantity(item.text)) return {};
    elements.push_back(item.text);
  }
  return elements;
} catch (const yaml::Error&) {
  return {};
}

/// Adds the wrong versions of each element of a list but of zeros.
void add_elements(const std::string& name, const std::vector<std::string>& elements,
                  std::vector<Mutation>& all) {
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const double factor : factors) {
      if (is_zero(elements[i])) continue;
      std::vector<std::string> wrong = elements;
      wrong[i] = times(factor, elements[i]);
      add_setting(fmt::format("{}.{}", name, i + 1), elements[i], wrong[i],
                  {name, fmt::format("[{}]", fmt::join(wrong, ", "))}, all);
    }
}

/// Adds the mutations of a parameter. Returns why there are none; empty if there are.
std::string add_parameter(const diagram::DiagramParameter& parameter, const std::set<std::string>& swept,
                          std::vector<Mutation>& all) {
  if (swept.contains(parameter.name)) return "it is swept";
  const std::size_t before = all.size();
  const std::vector<std::string> elements = elements_of(parameter.text);
  const double* number = std::get_if<double>(&parameter.value.content);
  if (!number && elements.empty()) return "its value is no number and no list of plain numbers";
  if (number && *number != 0.0) add_number(parameter.name, parameter.text, all);
  add_elements(parameter.name, elements, all);
  return all.size() == before ? "it is 0" : "";
}

/// Adds the mutations of all own parameters. Returns those without any, with the reason.
std::vector<std::string> add_parameters(const LoadedModel& model, std::vector<Mutation>& all) {
  const std::set<std::string> swept = swept_in(model.job.plan.diagram);
  std::vector<std::string> left_out;
  for (const diagram::DiagramParameter& parameter : model.job.plan.diagram.parameters) {
    if (parameter.name.find('.') != std::string::npos) continue;  // of a part
    const std::string reason = add_parameter(parameter, swept, all);
    if (!reason.empty()) left_out.push_back(parameter.name + ": " + reason);
  }
  return left_out;
}

/// Path of a value in a tree of YAML: indices of entries and items.
using NodePath = std::vector<std::size_t>;

yaml::Node& node_at(yaml::Node& root, const NodePath& path) {
  yaml::Node* node = &root;
  for (const std::size_t index : path)
    node = node->is_map() ? &node->entries[index].value : &node->items[index];
  return *node;
}

/// Calls a function with each scalar below a node, its path and its name.
void for_each_scalar(
    const yaml::Node& node, NodePath path, const std::string& name,
    const std::function<void(const yaml::Node&, const NodePath&, const std::string&)>& call) {
  if (node.is_scalar()) return call(node, path, name);
  path.push_back(0);
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    path.back() = i;
    for_each_scalar(node.items[i], path, fmt::format("{}.{}", name, i + 1), call);
  }
  for (std::size_t i = 0; i < node.entries.size(); ++i) {
    path.back() = i;
    const std::string inner = name.empty() ? node.entries[i].key : name + "." + node.entries[i].key;
    for_each_scalar(node.entries[i].value, path, inner, call);
  }
}

/// Returns a document with another text at a path.
std::shared_ptr<const yaml::Document> with_text(const yaml::Document& document, const NodePath& path,
                                                const std::string& text) {
  auto changed = std::make_shared<yaml::Document>(document);
  node_at(changed->root, path).text = text;
  return changed;
}

/// True for a name such as "lag.u.1" that is no parameter of the block's type, as `variables` is one.
bool is_wire_key(const LoadedModel& model, const std::string& name) {
  if (name.ends_with(".block") || name.ends_with(".diagram")) return false;
  const std::size_t dot = name.find('.');
  const auto& blocks = model.job.plan.diagram.blocks;
  const auto block = std::ranges::find(blocks, name.substr(0, dot), &diagram::DiagramBlock::name);
  if (block == blocks.end() || dot == std::string::npos) return true;
  return !block->type().parameter(name.substr(dot + 1, name.find('.', dot + 1) - dot - 1));
}

void add_wires(const LoadedModel& model, std::vector<Mutation>& all) {
  const yaml::Document document = yaml::read_document(model.file, model.options.limits);
  const yaml::Node* blocks = document.root.find("blocks");
  if (!blocks) return;
  const auto at = std::ranges::find(document.root.entries, std::string("blocks"), &yaml::Entry::key);
  const auto signals = signals_in(model.job.plan);
  const auto begin = static_cast<std::size_t>(at - document.root.entries.begin());
  for_each_scalar(*blocks, {begin}, "",
                  [&](const yaml::Node& node, const NodePath& path, const std::string& name) {
                    if (node.quoted || !is_wire_key(model, name)) return;
                    Mutation mutation{Mutation::Kind::wire, "wire " + name, node.text};
                    for (const std::string& other : others_like(node.text, signals)) {
                      mutation.versions.push_back({other});
                      mutation.versions.back().document = with_text(document, path, other);
                    }
                    if (!mutation.versions.empty()) all.push_back(std::move(mutation));
                  });
}

/// Returns the expression of a text such as "x in mm".
std::string expression_in(const std::string& text) {
  return text.substr(0, text.rfind(" in "));
}

/// Signal that a figure draws or a record has.
struct DrawnSignal {
  std::string text;
  std::optional<unit::Dimension> dimension;
  std::optional<std::size_t> recording;
};

void add_drawn_signal(DrawnSignal signal, std::vector<DrawnSignal>& signals) {
  if (std::ranges::find(signals, signal.text, &DrawnSignal::text) == signals.end())
    signals.push_back(std::move(signal));
}

std::vector<DrawnSignal> drawn_signals(const LoadedModel& model) {
  std::vector<DrawnSignal> signals;
  for (const plot::Figure& figure : model.figures)
    for (const plot::Panel& panel : figure.panels)
      for (const auto& [key, rows] : panel.series)
        for (const query::Series& row : rows)
          add_drawn_signal({row.formula.text, row.formula.dimension, row.formula.recording}, signals);
  const diagram::Diagram& diagram = model.job.plan.diagram;
  for (std::size_t i = 0; i < diagram.records.size(); ++i)
    for (const diagram::RecordedSignal& signal : diagram.records[i].signals)
      add_drawn_signal({signal.name, model.job.plan.dimension(signal.signal), i}, signals);
  return signals;
}

/// Returns the keys of panels that draw signals. Signals of other channels choose rows.
std::set<std::string> drawn_keys(const LoadedModel& model) {
  std::set<std::string> keys;
  for (const plot::Figure& figure : model.figures)
    for (const plot::Panel& panel : figure.panels)
      for (const auto& [key, rows] : panel.series) keys.insert(key);
  for (const char* other : {"by", "beside", "sheets", "to", "note"}) keys.erase(other);
  return keys;
}

/// Returns the last word of a path that is no index: "y" of "figure.y.2".
std::string key_in(std::string name) {
  while (name.find('.') != std::string::npos &&
         name.find_first_not_of("0123456789", name.rfind('.') + 1) == std::string::npos)
    name.resize(name.rfind('.'));
  return name.substr(name.rfind('.') + 1);
}

void add_drawn(const LoadedModel& model, std::vector<Mutation>& all) {
  const auto signals = drawn_signals(model);
  const yaml::Node& section = model.job.plan.diagram.figure;
  const std::set<std::string> keys = drawn_keys(model);
  for_each_scalar(
      section, {}, "figure", [&](const yaml::Node& node, const NodePath& path, const std::string& name) {
        const std::string expression = expression_in(node.text);
        const auto drawn = std::ranges::find(signals, expression, &DrawnSignal::text);
        if (drawn == signals.end() || !keys.contains(key_in(name))) return;
        Mutation mutation{Mutation::Kind::drawn, name, node.text};
        for (const DrawnSignal& other : signals) {
          const bool together = !other.recording || !drawn->recording || other.recording == drawn->recording;
          if (!together || other.dimension != drawn->dimension || other.text == expression) continue;
          Mutation::Version version{other.text};
          version.figure = section;
          node_at(*version.figure, path).text = other.text + node.text.substr(expression.size());
          if (mutation.versions.size() < most_versions) mutation.versions.push_back(std::move(version));
        }
        if (!mutation.versions.empty()) all.push_back(std::move(mutation));
      });
}

}  // namespace

const char* kind_name(Mutation::Kind kind) {
  return kind == Mutation::Kind::parameter ? "parameter" : kind == Mutation::Kind::wire ? "wire" : "drawn";
}

std::vector<Mutation> mutations_of(const LoadedModel& model) {
  std::vector<Mutation> all;
  add_parameters(model, all);
  add_wires(model, all);
  add_drawn(model, all);
  return all;
}

std::vector<std::string> left_out_of(const LoadedModel& model) {
  std::vector<Mutation> none;
  return add_parameters(model, none);
}

}  // namespace stepwire::session
