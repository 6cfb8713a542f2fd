// Forms of blocks and parts.
#include <algorithm>

#include "engine/app/language/forms.hpp"
#include "engine/app/language/type_keys.hpp"
#include "engine/model/diagram/every.hpp"

namespace stepwire::language {

using yaml::form;

namespace {

using Form = yaml::Key::Form;

std::string doc_of(const yaml::Node& declared) {
  const yaml::Node* doc = declared.is_map() ? declared.find("doc") : nullptr;
  return doc ? doc->text : "";
}

std::string text_under(const yaml::Node& declared, const char* name) {
  const yaml::Node* value = declared.is_map() ? declared.find(name) : nullptr;
  return value && value->is_scalar() ? value->text : "";
}

}  // namespace

const yaml::Key& Forms::block_form(const BlockType& type) {
  auto& made = made_["block " + type.name];
  if (!made) made = std::make_unique<const yaml::Key>(form::keys(type.name, "", keys_of_type(type)));
  return *made;
}

const yaml::Key& Forms::any_block() {
  auto& made = made_["block"];
  if (made) return *made;
  std::vector<yaml::Key::Word> types;
  for (const BlockType* type : registry_.types()) types.push_back({type->name, type->doc});
  yaml::Key keys = form::keys(
      "a block", "",
      {yaml::key("block", "kind of block", form::words(std::move(types))),
       yaml::key("diagram", "file of a part", form::string()),
       yaml::key("fields", "of a bus, signals under names: {force: f, torque: t}", form::of(Form::tree))});
  // Without a type, any key can be an input.
  keys.rest = {form::naming(yaml::Key::Names::signal, form::of(Form::source))};
  made = std::make_unique<const yaml::Key>(std::move(keys));
  return *made;
}

yaml::Key part_form(const yaml::Node& part) {
  std::vector<yaml::Key> keys{yaml::needed(yaml::key("diagram", text_under(part, "title"), form::string()))};
  if (const yaml::Node* inputs = part.find("inputs"))
    for (const yaml::Entry& input : inputs->entries) {
      keys.push_back(yaml::key(input.key, doc_of(input.value),
                               form::naming(yaml::Key::Names::signal, form::of(Form::source))));
      keys.back().unit = text_under(input.value, "unit");
      keys.back().required = !input.value.is_map() || !input.value.find("default");
    }
  if (const yaml::Node* parameters = part.find("parameters"))
    for (const yaml::Entry& parameter : parameters->entries) {
      keys.push_back(yaml::key(parameter.key, doc_of(parameter.value), form::of(Form::value)));
      keys.back().otherwise =
          parameter.value.is_scalar() ? parameter.value.text : text_under(parameter.value, "value");
    }
  const bool has_every = std::ranges::any_of(keys, [](const yaml::Key& key) { return key.name == "every"; });
  if (!has_every)
    keys.push_back(diagram::every_key("time between two runs of its blocks that have none of their own"));
  add_guard_keys(keys);
  return form::keys("a part", "", std::move(keys));
}

}  // namespace stepwire::language
