#include "engine/app/reference/block_json.hpp"

#include "engine/app/reference/example.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/model/diagram/block_keys.hpp"

namespace stepwire::reference {

using json::Json;

namespace {

Json tree_json(const Value& value);

/// Visitor that converts a parameter value to JSON by its C++ type.
struct Content {
  const ParameterSpec& spec;

  Json operator()(double number) const {
    const auto index = static_cast<std::size_t>(number);
    const bool word = spec.kind == ParameterKind::word && index < spec.words.size();
    if (spec.kind == ParameterKind::integer) return static_cast<std::int64_t>(number);
    return word ? Json(spec.words[index]) : Json(number);
  }
  Json operator()(bool flag) const { return flag; }
  Json operator()(const std::string& text) const { return text; }
  Json operator()(const Eigen::VectorXd& vector) const {
    const bool one = spec.kind == ParameterKind::per_element && vector.size() == 1;
    return one ? Json(vector[0]) : Json::list_of(vector);
  }
  Json operator()(const Eigen::MatrixXd& matrix) const {
    Json rows = Json::list();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push(Json::list_of(Eigen::VectorXd(matrix.row(i))));
    return rows;
  }
  Json operator()(const Value::List& list) const {
    Json items = Json::list();
    for (const Value& item : list) items.push(tree_json(item));
    return items;
  }
  Json operator()(const Value::Map& map) const {
    Json object = Json::object();
    for (const ValueEntry& entry : map) object.set(entry.key, tree_json(entry.value));
    return object;
  }
};

Json tree_json(const Value& value) {
  ParameterSpec spec;
  spec.kind = ParameterKind::tree;
  return std::visit(Content{spec}, value.content);
}

void add_bounds(Json& json, const Range& range) {
  if (range.above) json.set("above", *range.above);
  if (range.at_least) json.set("at_least", *range.at_least);
  if (range.below) json.set("below", *range.below);
  if (range.at_most) json.set("at_most", *range.at_most);
}

Json parameter_json(const BlockType& type, const ParameterSpec& spec) {
  Json json = Json::object().set("name", spec.name).set("kind", kind_text(spec.kind)).set("unit", spec.unit);
  json.set("shape", spec.shape).set("doc", spec.doc).set("required", spec.required);
  json.set("default", value_json(spec, default_of(type, spec)));
  add_bounds(json, spec.range);
  if (!spec.words.empty()) json.set("words", Json::list_of(spec.words));
  return json;
}

/// Returns the fields that all ports and states have.
template <class Spec>
Json port_json(const Spec& spec) {
  return Json::object()
      .set("name", spec.name)
      .set("unit", spec.unit)
      .set("shape", spec.shape)
      .set("doc", spec.doc);
}

Json input_json(const InputSpec& spec) {
  return port_json(spec)
      .set("feedthrough", spec.feedthrough)
      .set("optional", spec.optional)
      .set("list", spec.list)
      .set("multiply_units", spec.multiply_units)
      .set("one_unit", spec.one_unit);
}

Json output_json(const OutputSpec& spec) {
  return port_json(spec).set("state", spec.state.empty() ? Json() : Json(spec.state));
}

Json state_json(const BlockType& type, const StateSpec& spec) {
  Json json = port_json(spec).set("continuous", spec.continuous).set("initial", spec.initial);
  return json.set("key", spec.settable ? Json(diagram::initial_key(type, spec)) : Json());
}

/// Returns a preset with the values in which it differs from the defaults.
Json preset_json(const BlockType& type, const PresetSpec& preset) {
  AnyBlock block(type);
  preset.apply(block.get());
  Json values = Json::object();
  for (const ParameterSpec& spec : type.parameters) {
    Json value = value_json(spec, spec.get(block.get()));
    if (value.text() != value_json(spec, default_of(type, spec)).text())
      values.set(spec.name, std::move(value));
  }
  return Json::object().set("name", preset.name).set("doc", preset.doc).set("values", std::move(values));
}

Json diagnostic_json(const DiagnosticSpec& spec) {
  return Json::object().set("name", spec.name).set("doc", spec.doc).set("ends_run", spec.ends_run);
}

const char* timing_word(Timing timing) {
  if (timing == Timing::inherited) return "inherited";
  return timing == Timing::continuous ? "continuous" : "discrete";
}

template <class Specs, class Make>
Json list_json(const Specs& specs, Make make) {
  Json list = Json::list();
  for (const auto& spec : specs) list.push(make(spec));
  return list;
}

}  // namespace

Json value_json(const ParameterSpec& spec, const Value& value) {
  return std::visit(Content{spec}, value.content);
}

Json block_json(const BlockType& type) {
  Json json = Json::object().set("name", type.name).set("folder", type.folder).set("doc", type.doc);
  json.set("source", type.source).set("timing", timing_word(type.timing));
  json.set("not_real_time", type.not_real_time.empty() ? Json() : Json(type.not_real_time));
  json.set("parameters",
           list_json(type.parameters, [&](const auto& spec) { return parameter_json(type, spec); }));
  json.set("inputs", list_json(type.inputs, input_json));
  json.set("outputs", list_json(type.outputs, output_json));
  json.set("states", list_json(type.states, [&](const auto& spec) { return state_json(type, spec); }));
  json.set("presets", list_json(type.presets, [&](const auto& spec) { return preset_json(type, spec); }));
  json.set("notices", list_json(type.diagnostics, diagnostic_json));
  json.set("keys", Json::list_of(diagram::keys_of(type)));
  return json.set("example", block_example(type));
}

Json blocks_json(const Registry& registry) {
  Json list = Json::list();
  for (const BlockType* type : registry.types()) list.push(block_json(*type));
  return list;
}

}  // namespace stepwire::reference
