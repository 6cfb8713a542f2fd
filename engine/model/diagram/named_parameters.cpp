#include "engine/model/diagram/named_parameters.hpp"

#include <algorithm>

namespace stepwire::diagram {

namespace {

/// True for "u", "u2", "time", an input, or a block's name for one.
bool is_of_block(const std::string& name, const BlockType& type) {
  if (name == "time" || name == "u" || type.input(name) >= 0 || type.output(name) >= 0) return true;
  return name.size() > 1 && name[0] == 'u' && name.find_first_not_of("0123456789", 1) == std::string::npos;
}

bool is_among(const std::vector<std::string>& keys, const std::string& key) {
  return std::ranges::find(keys, key) != keys.end();
}

}  // namespace

std::vector<std::string> words_given_to(const BlockType& type, const yaml::Node& keys) {
  std::vector<std::string> words;
  for (const ParameterSpec& spec : type.parameters) {
    const yaml::Node* given = keys.find(spec.name);
    if (given && spec.kind == ParameterKind::texts)
      for (const yaml::Node& word : given->as_list()) words.push_back(word.text);
    if (given && spec.kind == ParameterKind::tree && spec.formulas.empty())
      for (const yaml::Entry& named : given->entries) words.push_back(named.key);
  }
  return words;
}

std::string name_parameters(const std::string& text, const ParameterScope& parameters,
                            const std::function<bool(const std::string& name)>& has_meaning) {
  if (text.find('$') != std::string::npos) return text;
  try {
    const expression::Expression expression(text);
    std::vector<std::string> names;
    for (const std::string& name : expression.variables())
      names.push_back(parameters.defined(name) && !has_meaning(name) ? "$" + name : name);
    return expression.renamed(names);
  } catch (const expression::ExpressionError&) {
    return text;
  }
}

yaml::Node name_parameters(const yaml::Node& node, const std::vector<std::string>& keys,
                           const BlockType& type, const std::vector<std::string>& words,
                           const ParameterScope& parameters) {
  yaml::Node result = node;
  const auto has_meaning = [&](const std::string& name) {
    return is_of_block(name, type) || is_among(words, name);
  };
  if (node.is_scalar() && is_among(keys, ""))
    result.text = name_parameters(node.text, parameters, has_meaning);
  for (yaml::Node& item : result.items) item = name_parameters(item, keys, type, words, parameters);
  // All values of a map of formulas are formulas, whatever their keys; an example is a guard below its
  // target.
  const bool all = node.is_map() && is_among(keys, "");
  for (yaml::Entry& entry : result.entries) {
    const bool are_formulas = all || (!entry.value.is_list() && is_among(keys, entry.key)) ||
                              (entry.value.is_map() && is_among(keys, entry.key + "."));
    entry.value = name_parameters(entry.value, are_formulas ? std::vector<std::string>{""} : keys, type,
                                  words, parameters);
  }
  return result;
}

}  // namespace stepwire::diagram
