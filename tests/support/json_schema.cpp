#include "tests/support/json_schema.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>

namespace stepwire {

using nlohmann::json;

namespace {

json scalar_of(const yaml::Node& node) {
  if (node.quoted) return node.text;
  if (node.text == "true" || node.text == "false") return node.text == "true";
  const json number = json::parse(node.text, nullptr, false);
  return number.is_number() ? number : json(node.text);
}

bool is_type(const json& value, const std::string& type) {
  if (type == "integer") return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
  if (type == "number") return value.is_number();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "array") return value.is_array();
  if (type == "object") return value.is_object();
  return type == "null" && value.is_null();
}

/// Checks one value; subschemas are checked by more of these.
class Check {
 public:
  Check(const json& root, const json& value, std::string path)
      : root_(root), value_(value), path_(std::move(path)) {}

  std::string faults(const json& schema) {
    if (schema.is_boolean()) return schema.get<bool>() ? "" : fault("is not allowed");
    for (const auto& [keyword, argument] : schema.items()) apply(keyword, argument, schema);
    return faults_;
  }

 private:
  std::string fault(const std::string& message) {
    faults_ += path_ + ": " + message + "\n";
    return faults_;
  }
  void demand(bool holds, const std::string& message) {
    if (!holds) fault(message);
  }
  std::string inside(const json& schema, const json& value, const std::string& key) const {
    return Check(root_, value, path_ + "/" + key).faults(schema);
  }
  bool fits(const json& schema) const { return Check(root_, value_, path_).faults(schema).empty(); }
  void join(const json& schema) { faults_ += Check(root_, value_, path_).faults(schema); }

  using Rule = void (*)(Check& check, const json& is, const json& schema);

  void apply(const std::string& keyword, const json& is, const json& schema) {
    static const std::set<std::string> silent{"$schema", "$defs", "title", "description",
                                              "default", "then",  "else"};
    if (const auto rule = rules().find(keyword); rule != rules().end())
      return rule->second(*this, is, schema);
    if (!silent.contains(keyword))
      throw std::logic_error("the schema has a keyword that is not known here: " + keyword);
  }

  static const std::map<std::string, Rule>& rules() {
    static const std::map<std::string, Rule> all{
        {"$ref", [](Check& c, const json& is, const json&) { c.refer(is); }},
        {"type", [](Check& c, const json& is, const json&) { c.check_type(is); }},
        {"const",
         [](Check& c, const json& is, const json&) { c.demand(c.value_ == is, "is not " + is.dump()); }},
        {"enum", [](Check& c, const json& is, const json&) { c.check_among(is); }},
        {"pattern", [](Check& c, const json& is, const json&) { c.check_pattern(is); }},
        {"anyOf", [](Check& c, const json& is,
                     const json&) { c.demand(c.count_of(is) > 0, "fits none of several forms"); }},
        {"oneOf", [](Check& c, const json& is,
                     const json&) { c.demand(c.count_of(is) == 1, "fits not just one form"); }},
        {"allOf",
         [](Check& c, const json& is, const json&) {
           for (const json& one : is) c.join(one);
         }},
        {"if", [](Check& c, const json&, const json& schema) { c.check_condition(schema); }},
        {"items", [](Check& c, const json& is, const json&) { c.check_items(is); }},
        {"properties", [](Check& c, const json& is, const json&) { c.check_properties(is); }},
        {"additionalProperties",
         [](Check& c, const json& is, const json& schema) { c.check_others(is, schema); }},
        {"propertyNames", [](Check& c, const json& is, const json&) { c.check_names(is); }},
        {"required", [](Check& c, const json& is, const json&) { c.check_required(is); }},
        {"dependentRequired", [](Check& c, const json& is, const json&) { c.check_dependent(is); }},
        {"minItems",
         [](Check& c, const json& is, const json&) {
           c.demand(!c.value_.is_array() || c.value_.size() >= is, "is too short");
         }},
        {"maxItems",
         [](Check& c, const json& is, const json&) {
           c.demand(!c.value_.is_array() || c.value_.size() <= is, "is too long");
         }},
        {"minProperties",
         [](Check& c, const json& is, const json&) {
           c.demand(!c.value_.is_object() || c.value_.size() >= is, "has too few keys");
         }},
        {"maxProperties",
         [](Check& c, const json& is, const json&) {
           c.demand(!c.value_.is_object() || c.value_.size() <= is, "has too many keys");
         }},
        {"minimum", [](Check& c, const json& is,
                       const json&) { c.demand(!c.value_.is_number() || c.value_ >= is, "is too small"); }},
        {"maximum", [](Check& c, const json& is,
                       const json&) { c.demand(!c.value_.is_number() || c.value_ <= is, "is too large"); }},
        {"exclusiveMinimum",
         [](Check& c, const json& is, const json&) {
           c.demand(!c.value_.is_number() || c.value_ > is, "is too small");
         }},
        {"exclusiveMaximum",
         [](Check& c, const json& is, const json&) {
           c.demand(!c.value_.is_number() || c.value_ < is, "is too large");
         }},
    };
    return all;
  }

  void refer(const std::string& reference) { join(root_.at(json::json_pointer(reference.substr(1)))); }
  void check_among(const json& values) {
    demand(std::find(values.begin(), values.end(), value_) != values.end(), "is none of " + values.dump());
  }
  void check_dependent(const json& dependents) {
    for (const auto& [key, keys] : dependents.items())
      if (value_.contains(key)) check_required(keys);
  }
  void check_type(const json& type) {
    if (type.is_string()) return demand(is_type(value_, type), "is no " + type.get<std::string>());
    bool any = false;
    for (const json& one : type) any = any || is_type(value_, one);
    demand(any, "is none of " + type.dump());
  }
  void check_pattern(const json& pattern) {
    if (value_.is_string())
      demand(std::regex_search(value_.get<std::string>(), std::regex(pattern.get<std::string>())),
             "does not look right");
  }
  std::size_t count_of(const json& schemas) const {
    std::size_t count = 0;
    for (const json& schema : schemas) count += fits(schema);
    return count;
  }
  void check_condition(const json& schema) {
    const char* branch = fits(schema.at("if")) ? "then" : "else";
    if (schema.contains(branch)) join(schema.at(branch));
  }
  void check_items(const json& schema) {
    if (!value_.is_array()) return;
    for (std::size_t i = 0; i < value_.size(); ++i) faults_ += inside(schema, value_[i], std::to_string(i));
  }
  void check_properties(const json& properties) {
    if (!value_.is_object()) return;
    for (const auto& [key, schema] : properties.items())
      if (value_.contains(key)) faults_ += inside(schema, value_.at(key), key);
  }
  void check_others(const json& schema, const json& parent) {
    if (!value_.is_object()) return;
    for (const auto& [key, value] : value_.items())
      if (!parent.contains("properties") || !parent.at("properties").contains(key))
        faults_ += inside(schema, value, key);
  }
  void check_names(const json& schema) {
    if (!value_.is_object()) return;
    for (const auto& [key, value] : value_.items()) faults_ += inside(schema, key, key);
  }
  void check_required(const json& keys) {
    if (!value_.is_object()) return;
    for (const json& key : keys) demand(value_.contains(key.get<std::string>()), "lacks " + key.dump());
  }

  const json& root_;
  const json& value_;
  std::string path_, faults_;
};

}  // namespace

json json_of(const yaml::Node& node) {
  if (node.is_scalar()) return scalar_of(node);
  json result;
  if (node.is_list()) result = json::array();
  for (const yaml::Node& item : node.items) result.push_back(json_of(item));
  if (node.is_map()) result = json::object();
  for (const yaml::Entry& entry : node.entries) result[entry.key] = json_of(entry.value);
  return result;
}

std::string schema_faults(const json& value, const json& schema) {
  return Check(schema, value, "").faults(schema);
}

}  // namespace stepwire
