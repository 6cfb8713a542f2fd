#include "engine/app/language/type_keys.hpp"

#include <algorithm>

#include "engine/app/reference/words.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/every.hpp"
#include "engine/model/diagram/guard_keys.hpp"

namespace stepwire::language {

using yaml::form;

namespace {

using Form = yaml::Key::Form;

yaml::Key source_form(const InputSpec& input) {
  const yaml::Key source = form::naming(yaml::Key::Names::signal, form::of(Form::source));
  yaml::Key made = yaml::key(input.name, input.doc, input.list ? form::one_or_list(source) : source);
  made.unit = input.unit == "*" ? "" : input.unit;
  made.required = !input.optional;
  return made;
}

yaml::Key words_form(const std::vector<std::string>& words) {
  std::vector<yaml::Key::Word> all;
  for (const std::string& word : words) all.push_back({word});
  return form::words(std::move(all));
}

yaml::Key parameter_form_of(const BlockType& type, const ParameterSpec& parameter) {
  const bool word = parameter.kind == ParameterKind::word;
  const bool flag = parameter.kind == ParameterKind::flag;
  const bool tree = parameter.kind == ParameterKind::tree;
  yaml::Key made = yaml::key(parameter.name, parameter.doc,
                             word   ? words_form(parameter.words)
                             : flag ? form::truth()
                             : tree ? form::tree()
                                    : form::of(Form::value));
  made.unit = reference::fixed_unit(parameter.unit);
  made.required = parameter.required;
  made.otherwise = parameter.required ? "" : reference::default_text(type, parameter);
  made.refers = reference::allowed_text(parameter);
  return made;
}

yaml::Key preset_form(const BlockType& type) {
  std::vector<yaml::Key::Word> words;
  for (const PresetSpec& preset : type.presets) words.push_back({preset.name, preset.doc});
  return yaml::key("preset", "a named set of parameter values; keys beside it come on top",
                   form::words(std::move(words)));
}

}  // namespace

void add_guard_keys(std::vector<yaml::Key>& keys) {
  for (const yaml::Key& guard : diagram::guard_keys())
    if (guard.name != "guard" &&
        std::ranges::none_of(keys, [&](const yaml::Key& key) { return key.name == guard.name; }))
      keys.push_back(guard);
}

std::vector<yaml::Key> keys_of_type(const BlockType& type) {
  std::vector<yaml::Key> keys{yaml::needed(yaml::key("block", type.doc, words_form({type.name})))};
  for (const InputSpec& input : type.inputs)
    if (!diagram::has_value(type, input.name)) keys.push_back(source_form(input));
  for (const ParameterSpec& parameter : type.parameters) keys.push_back(parameter_form_of(type, parameter));
  for (const StateSpec& state : type.states)
    if (state.settable)
      keys.push_back(yaml::key(diagram::initial_key(type, state),
                               "where the state " + state.name + " starts: " + state.doc,
                               form::of(Form::value)));
  if (!type.presets.empty()) keys.push_back(preset_form(type));
  if (!type.has_continuous_state()) keys.push_back(diagram::every_key("time between two runs of this block"));
  add_guard_keys(keys);
  return keys;
}

}  // namespace stepwire::language
