#include "engine/model/diagram/guard_keys.hpp"

#include <algorithm>
#include <cctype>

#include "engine/base/expression/expression.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/resolve.hpp"

namespace stepwire::diagram {

namespace {

using yaml::form;

yaml::Key condition_form() {
  return form::naming(yaml::Key::Names::signal, form::of(yaml::Key::Form::source));
}

yaml::Key edge_form() {
  return form::words({{"rising", "the condition becomes true"},
                      {"falling", "it becomes false"},
                      {"either", "it becomes the one or the other"}});
}

yaml::Key states_form() {
  return form::words({{"held", "states go on where they stood"},
                      {"reset", "they, and those of parts inside, take their initial values"}});
}

yaml::Key outputs_key() {
  return yaml::otherwise(
      "held",
      yaml::key("outputs",
                "what others read of it while it is off: held (the last value), reset (the `safe` value of "
                "a port, else 0) or a value of their own: 0 N",
                form::of(yaml::Key::Form::value)));
}

yaml::Key enable_key() {
  return yaml::key(
      "enable", "active while this is above 0 or true: a signal or a formula of signals, door.angle > 5 deg",
      form::either(
          {condition_form(),
           form::keys(
               "a condition", "{when: door.open, states: reset, outputs: reset}",
               {yaml::needed(yaml::key("when", "the signal or the formula", condition_form())),
                yaml::otherwise("held", yaml::key("states", "of it, as it becomes active", states_form())),
                outputs_key()})}));
}

yaml::Key trigger_key() {
  return yaml::key(
      "trigger", "active at each tick at which this crosses 0, or becomes true: index, position > 3 mm",
      form::either(
          {condition_form(),
           form::keys("a trigger", "{when: index, edge: either}",
                      {yaml::needed(yaml::key("when", "the signal or the formula", condition_form())),
                       yaml::otherwise("rising", yaml::key("edge", "the crossings that count", edge_form())),
                       yaml::otherwise("held", yaml::key("states", "of it, at each edge", states_form())),
                       outputs_key()})}));
}

int index_of(const std::vector<yaml::Key::Word>& words, const std::string& word) {
  const auto found = std::ranges::find(words, word, &yaml::Key::Word::word);
  return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

}  // namespace

const std::vector<yaml::Key>& guard_keys() {
  static const std::vector<yaml::Key> keys{
      enable_key(), trigger_key(),
      yaml::key("guard", "the Guard that decides whether this block is active, in a flattened file",
                form::naming(yaml::Key::Names::block, form::string()))};
  return keys;
}

bool is_guard_key(std::string_view key) {
  return std::ranges::find(guard_keys(), key, &yaml::Key::name) != guard_keys().end();
}

bool is_condition(std::string_view key, const yaml::Node& value) {
  return is_guard_key(key) && key != "guard" && value.is_map() && value.find("when");
}

bool is_formula(const yaml::Node& condition) {
  const std::string& text = condition.text;
  if (text.starts_with('=')) return true;
  const std::string name = text.starts_with('$') ? text.substr(1) : text;
  const bool is_name =
      std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.'; });
  return !is_name && (text.starts_with('$') || names_signal(condition));
}

std::string plain_formula(std::string text) {
  std::erase(text, '$');
  if (text.starts_with('=')) text.erase(0, text.find_first_not_of("= "));
  return text;
}

std::vector<std::string> signals_of_condition(const yaml::Node& condition) {
  if (!is_formula(condition))
    return names_signal(condition) ? std::vector{condition.text} : std::vector<std::string>{};
  try {
    const auto always = [](std::string_view) { return true; };
    return expression::Expression::hiding_constants(plain_formula(condition.text), always).variables();
  } catch (const expression::ExpressionError&) {
    return {};
  }
}

GuardOptions read_guard_options(const yaml::Node& node, const std::string& key, const Scope& scope,
                                const std::string& owner, Report& report) {
  GuardOptions options;
  if (!node.is_map()) {
    options.when = &node;
    return options;
  }
  const yaml::Key& keys = std::ranges::find(guard_keys(), key, &yaml::Key::name)->of.back();
  const HeadReading read(scope.prefix + owner + "." + key, scope, report);
  if (!read.check(node, keys)) return options;
  options.when = node.find("when");
  const ValueReader reader(scope.parameters, report, scope.index);
  const auto word = [&](const char* name) -> std::optional<int> {
    const yaml::Node* value = node.find(name);
    const auto text = value ? reader.fill_in(*value, read.subject + "." + name) : std::nullopt;
    if (!text) return std::nullopt;
    const int index = index_of(keys.find(name)->words, *text);
    if (index >= 0) return index;
    yaml::below(read, name).word(*value, *keys.find(name));
    return std::nullopt;
  };
  options.edge = keys.find("edge") ? word("edge") : std::nullopt;
  options.states = word("states");
  if (const yaml::Node* outputs = node.find("outputs"); outputs && outputs->text != "held")
    options.outputs = outputs;
  return options;
}

}  // namespace stepwire::diagram
