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

/// Wrong value of a parameter or of an element of its list.
struct WrongValue {
  std::string name;     ///< "lens.2"
  std::string old;      ///< the number as written
  std::string version;  ///< the wrong number
  std::string text;     ///< the wrong value as a whole
};

/// Returns the wrong versions of a number. One in degC changes on its own scale, since a formula refuses a
/// multiple of it.
std::vector<WrongValue> wrong_numbers(const std::string& name, const std::string& text) {
  const std::string own = text.starts_with("=") || text.starts_with("$") ? text.substr(1) : text;
  const bool is_celsius = own == text && text.ends_with("degC");
  std::vector<WrongValue> wrong;
  if (is_celsius && is_zero(text)) return wrong;
  for (const double factor : factors) {
    const std::string formula = fmt::format("{}({})", factor == -1.0 ? "-" : fmt::format("{}*", factor), own);
    const std::string value = is_celsius ? times(factor, text) : formula;
    wrong.push_back({name, text, value, is_celsius ? value : "= " + formula});
  }
  return wrong;
}

/// Returns the numbers of a list such as "[1 m, 2 m]" or "{value: [1, 2], unit: m}"; an empty list for
/// others.
std::vector<std::string> elements_of(const std::string& text) try {
  std::vector<std::string> elements;
  const yaml::Node written = diagram::value_of_text(text, "");
  const yaml::Node *value = written.is_map() ? written.find("value") : nullptr,
                   *unit = written.is_map() ? written.find("unit") : nullptr;
  const yaml::Node& list = value ? *value : written;
  for (const yaml::Node& item : list.items) {
    const auto number = item.is_scalar() ? unit::parse_quantity(item.text) : std::nullopt;
    if (!number) return {};
    elements.push_back(unit && !number->dimension ? item.text + " " + unit->text : item.text);
  }
  return elements;
} catch (const yaml::Error&) {
  return {};
}

/// Returns the wrong versions of each element of a list but of zeros.
std::vector<WrongValue> wrong_elements(const std::string& name, const std::vector<std::string>& elements) {
  std::vector<WrongValue> wrong;
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const double factor : factors) {
      if (is_zero(elements[i])) continue;
      std::vector<std::string> list = elements;
      list[i] = times(factor, elements[i]);
      wrong.push_back({fmt::format("{}.{}", name, i + 1), elements[i], list[i],
                       fmt::format("[{}]", fmt::join(list, ", "))});
    }
  return wrong;
}

/// Wrong versions of a parameter, or the reason why there are none.
struct WrongValues {
  std::vector<WrongValue> values{};
  std::string reason{};
};

WrongValues wrong_values(const diagram::DiagramParameter& parameter, const std::set<std::string>& swept) {
  if (swept.contains(parameter.name)) return {{}, "it is swept"};
  const double* number = std::get_if<double>(&parameter.value.content);
  const std::vector<std::string> elements = elements_of(parameter.text);
  if (!number && elements.empty()) return {{}, "its value is no number and no list of plain numbers"};
  WrongValues wrong;
  if (!elements.empty())
    wrong.values = wrong_elements(parameter.name, elements);
  else if (*number != 0.0)
    wrong.values = wrong_numbers(parameter.name, parameter.text);
  if (wrong.values.empty()) wrong.reason = "it is 0";
  return wrong;
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

/// Returns a document with another value at a path.
std::shared_ptr<const yaml::Document> with_value(const yaml::Document& document, const NodePath& path,
                                                 yaml::Node value) {
  auto changed = std::make_shared<yaml::Document>(document);
  yaml::Node& node = node_at(changed->root, path);
  value.mark = node.mark;
  node = std::move(value);
  return changed;
}

/// Returns the path of the value that the file gives to a parameter of a part, as "rig.k"; std::nullopt where
/// it gives none.
std::optional<NodePath> path_in_part(const yaml::Node& root, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  NodePath path;
  const yaml::Node* node = &root;
  for (const std::string& key : {std::string("blocks"), name.substr(0, dot), name.substr(dot + 1)}) {
    const auto entry = std::ranges::find(node->entries, key, &yaml::Entry::key);
    if (entry == node->entries.end()) return std::nullopt;
    path.push_back(static_cast<std::size_t>(entry - node->entries.begin()));
    node = &entry->value;
  }
  return path;
}

/// Adds the mutations of all parameters that the file gives a value. Returns those without any, with the
/// reason.
std::vector<std::string> add_parameters(const LoadedModel& model, const yaml::Document& document,
                                        std::vector<Mutation>& all) {
  const std::set<std::string> swept = swept_in(model.job.plan.diagram);
  std::vector<std::string> left_out;
  for (const diagram::DiagramParameter& parameter : model.job.plan.diagram.parameters) {
    const bool is_of_part = parameter.name.find('.') != std::string::npos;
    const auto path = is_of_part ? path_in_part(document.root, parameter.name) : std::nullopt;
    if (is_of_part && !path) continue;  // a value of the part's own file
    const WrongValues wrong = wrong_values(parameter, swept);
    if (!wrong.reason.empty()) left_out.push_back(parameter.name + ": " + wrong.reason);
    for (const WrongValue& one : wrong.values) {
      Mutation mutation{Mutation::Kind::parameter, "parameter " + one.name, one.old};
      mutation.versions.push_back({one.version});
      if (path)
        mutation.versions.back().document =
            with_value(document, *path, diagram::value_of_text(one.text, model.file));
      else
        mutation.versions.back().setting = diagram::Setting{parameter.name, one.text};
      all.push_back(std::move(mutation));
    }
  }
  return left_out;
}

/// True for a name such as "lag.u.1" that is no parameter of the block's type, as `variables` is one, and
/// none of the part.
bool is_wire_key(const LoadedModel& model, const std::string& name) {
  if (name.ends_with(".block") || name.ends_with(".diagram")) return false;
  const auto& parameters = model.job.plan.diagram.parameters;
  const bool is_of_part = std::ranges::any_of(parameters, [&](const diagram::DiagramParameter& one) {
    return one.name.find('.') != std::string::npos && (name + ".").starts_with(one.name + ".");
  });
  if (is_of_part) return false;
  const std::size_t dot = name.find('.');
  const auto& blocks = model.job.plan.diagram.blocks;
  const auto block = std::ranges::find(blocks, name.substr(0, dot), &diagram::DiagramBlock::name);
  if (block == blocks.end() || dot == std::string::npos) return true;
  return !block->type().parameter(name.substr(dot + 1, name.find('.', dot + 1) - dot - 1));
}

void add_wires(const LoadedModel& model, const yaml::Document& document, std::vector<Mutation>& all) {
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
                      yaml::Node source = node;
                      source.text = other;
                      mutation.versions.push_back({other});
                      mutation.versions.back().document = with_value(document, path, std::move(source));
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

Mutations mutations_of(const LoadedModel& model) {
  const yaml::Document document = yaml::read_document(model.file, model.options.limits);
  Mutations found;
  found.left_out = add_parameters(model, document, found.all);
  add_wires(model, document, found.all);
  add_drawn(model, found.all);
  return found;
}

}  // namespace stepwire::session
