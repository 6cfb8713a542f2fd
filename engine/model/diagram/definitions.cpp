#include "engine/model/diagram/definitions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/bare_number.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/keys.hpp"

namespace stepwire::diagram {

namespace {

constexpr std::size_t longest_chain = 1000;  // of parameters that each use a later one

/// Evaluates definitions on demand, so that their order in the file is free.
class Definitions {
 public:
  Definitions(Scope& scope, const Overrides& overrides, Settings& settings, Report& report)
      : scope_(scope), overrides_(overrides), settings_(settings), report_(report) {
    if (const yaml::Node* map = scope.document->root.find("parameters"))
      for (const yaml::Entry& entry : map->entries) entries_[entry.key] = &entry;
  }

  void define_all() {
    const yaml::Node* map = scope_.document->root.find("parameters");
    if (!map) return;
    if (!map->is_map())
      return report_.add(scope_.at(map->mark), "parameters", "must be a map of name: value");
    for (const yaml::Entry& entry : map->entries) define(entry.key);
  }

 private:
  void define(const std::string& name) {
    const auto found = entries_.find(name);
    if (found == entries_.end() || scope_.parameters.defined(name) || failed_.contains(name)) return;
    const yaml::Entry& entry = *found->second;
    if (!is_name(name) || name == "time" || name == "pi" || name == "e")
      return fail(entry,
                  "is no name for a parameter; use letters, digits and '_' ('time', 'pi' and 'e' have a "
                  "meaning of their own)");
    if (const auto circle = std::find(open_.begin(), open_.end(), name); circle != open_.end())
      return fail(entry,
                  fmt::format("depends on itself: {} -> {}", fmt::join(circle, open_.end(), " -> "), name));
    if (open_.size() >= longest_chain)
      return fail(entry,
                  fmt::format("is reached from '{}' through more than {} parameters that use each other; "
                              "write what others use above them",
                              open_.front(), longest_chain));
    open_.push_back(name);
    define_what_it_uses(entry.value);
    open_.pop_back();
    if (failed_.contains(name)) return;
    if (auto value = evaluate(entry)) {
      scope_.parameters.define(name, std::move(*value), last_index());
    } else {
      failed_.insert(name);
      scope_.parameters.define(name, {{1.0}, {}, "", true});
    }
  }

  /// Returns the index of the last added parameter.
  int last_index() const { return static_cast<int>(report_.diagram().parameters.size()) - 1; }

  void fail(const yaml::Entry& entry, const yaml::Message& message) {
    if (failed_.insert(entry.key).second) report_.add(scope_.at(entry.mark), entry.key, message);
    scope_.parameters.define(entry.key, {{1.0}, {}, "", true});
  }

  static const yaml::Node& definition(const yaml::Entry& entry) {
    const yaml::Node* value = entry.value.is_map() ? entry.value.find("value") : nullptr;
    return value ? *value : entry.value;
  }

  /// Defines every name of this file that occurs as a word in the text; that may include unneeded ones.
  void define_what_it_uses(const yaml::Node& node, bool in_matrix = false) {
    for (const yaml::Node& item : node.items) define_what_it_uses(item, in_matrix || has_number(node));
    for (const yaml::Entry& entry : node.entries)
      if (entry.key != "doc") define_what_it_uses(entry.value, is_bound(entry.key));
    if (!node.is_scalar() || !may_use_others(node, in_matrix)) return;
    std::string word;
    for (char c : node.text + " ") {
      if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
        word += c;
      } else {
        if (entries_.contains(word)) define(word);
        word.clear();
      }
    }
  }

  /// True where names can be parameters; words and texts contain none.
  static bool may_use_others(const yaml::Node& node, bool only_numbers) {
    return only_numbers || node.text.starts_with('=') || node.text.starts_with('$');
  }

  static bool has_number(const yaml::Node& list) {
    return std::ranges::any_of(list.items, [](const yaml::Node& item) {
      return item.is_list() || unit::parse_quantity(item.text).has_value();
    });
  }

  static bool is_bound(const std::string& key) { return std::ranges::count(bound_keys, key) > 0; }

  /// Checks the keys of a parameter given as a map; returns false without a value.
  bool holds_value(const yaml::Entry& entry, const std::string& full) {
    if (!entry.value.is_map()) return true;
    HeadReading(full, scope_, report_).check(entry.value, parameter_form().of.back());
    return entry.value.find("value") != nullptr;
  }

  std::optional<WrittenValue> evaluate(const yaml::Entry& entry) {
    const std::string full = scope_.prefix + entry.key;
    if (!holds_value(entry, full)) {
      settings_.offer(full);
      return std::nullopt;
    }
    ParameterUses own;
    ValueReader reader(scope_.parameters, report_, scope_.index, &own);
    Definition made{entry.key, scope_.index, {stripped(entry.value), scope_.index, scope_.index},
                    {},        {},           own};
    made.text.node = reader.with_formulas(made.text.node, false);
    auto written = reader.read(made.text.node, full);
    made.uses = std::move(own);
    settings_.offer(full);
    if (written) made.dimension = written->dimension;
    if (written) made.each = written->each;
    const bool set = replace(entry, full, made, written);
    if (!written) return std::nullopt;
    made.bounds = bounds_of(entry.value);
    if (!have_units(made.bounds, entry.value, full)) return std::nullopt;
    for (yaml::Entry& bound : made.bounds) bound.value = reader.with_formulas(bound.value, true);
    if (!accepts(made, scope_.parameters, *written, value_origin_, full, made.uses, report_))
      return std::nullopt;
    list(full, entry, *written, made.text.node).set = set;
    report_.bindings().definitions.push_back(std::move(made));
    return written;
  }

  /// Returns a definition reduced to {value: .., unit: ..}.
  static yaml::Node stripped(const yaml::Node& node) {
    if (!node.is_map()) return node;
    yaml::Node result = node;
    std::erase_if(result.entries,
                  [](const yaml::Entry& entry) { return entry.key != "value" && entry.key != "unit"; });
    return result;
  }

  static std::vector<yaml::Entry> bounds_of(const yaml::Node& node) {
    std::vector<yaml::Entry> bounds;
    for (const std::string& key : bound_keys)
      if (const yaml::Node* limit = node.is_map() ? node.find(key) : nullptr)
        bounds.push_back({key, {}, *limit});
    return bounds;
  }

  /// Refuses bounds without unit beside a value in a unit other than SI: 10 beside 5 mm would be 10 m.
  bool have_units(const std::vector<yaml::Entry>& bounds, const yaml::Node& definition,
                  const std::string& full) {
    if (bounds.empty()) return true;
    const yaml::Node* unit = definition.find("unit");
    const std::string written = unit ? unit->text : unit_as_written(*definition.find("value"));
    for (const yaml::Entry& bound : bounds)
      if (auto fault = bare_number(bound.value.text, written, "the value")) {
        report_.add(scope_.at(bound.value.mark), full + "." + bound.key, std::move(*fault));
        return false;
      }
    return true;
  }

  /// Reads the values that the using file and the call give in place of the file's own. Returns true if the
  /// call gave one.
  bool replace(const yaml::Entry& entry, const std::string& full, Definition& made,
               std::optional<WrittenValue>& written) {
    value_origin_ = scope_.at(definition(entry).mark);
    const auto read = [&](const yaml::Node& node, const Scope& names, const Origin& origin) {
      value_origin_ = origin;
      made.uses.clear();
      const ValueReader reader(names.parameters, report_, origin.scope, &made.uses);
      made.text = {reader.with_formulas(node, false), names.index, origin.scope};
      written = reader.read(made.text.node, full);
      if (written) note_giver(*written, made, full, origin);
    };
    if (const auto given = overrides_.values.find(entry.key); given != overrides_.values.end())
      read(*given->second, *overrides_.from, overrides_.from->at(given->second->mark));
    Settings::Entry* setting = settings_.take(full);
    if (setting) read(setting->document.root, scope_, setting->origin);
    return setting != nullptr;
  }

  /// Returns the text of a value; that of a list reads back to the same numbers.
  static std::string text_of(const yaml::Node& node, const WrittenValue& written) {
    const yaml::Node* value = node.is_map() ? node.find("value") : &node;
    if (!value || !value->is_list()) return written.text;
    return yaml::yaml_line(node.find("unit") ? node : *value);
  }

  /// Adds a parameter to those of the diagram. `node` is the text of its value.
  DiagramParameter& list(const std::string& full, const yaml::Entry& entry, const WrittenValue& written,
                         const yaml::Node& node) {
    const yaml::Node* doc = entry.value.find("doc");
    const yaml::Node* assumed = entry.value.find("assumed");
    const HeadReading read(full, scope_, report_);
    DiagramParameter& listed = report_.diagram().parameters.emplace_back(DiagramParameter{
        full, text_of(node, written), written.value, written.dimension, "", false, false, written.each});
    if (doc) yaml::below(read, "doc").take(*doc, {}, listed.doc);
    if (assumed) yaml::below(read, "assumed").take(*assumed, yaml::form::truth(), listed.assumed);
    return listed;
  }

  Scope& scope_;
  const Overrides& overrides_;
  Settings& settings_;
  Report& report_;
  std::map<std::string, const yaml::Entry*> entries_;
  std::vector<std::string> open_;  ///< definitions in progress, outermost first
  std::set<std::string> failed_;
  Origin value_origin_;
};

}  // namespace

Settings::Settings(const std::vector<Setting>& settings, Report& report) {
  for (const Setting& setting : settings) {
    const std::string& source = setting.written;
    auto& scopes = report.diagram().scopes;
    scopes.push_back({source, "", {-1, {}}});
    const Origin origin{static_cast<int>(scopes.size()) - 1, setting.mark};
    try {
      yaml::Document document = yaml::parse_document(setting.value, source);
      // The location of a setting is the whole setting, not a column of its text.
      document.root.mark = setting.mark;
      entries_[setting.name] = {std::move(document), origin, false};
    } catch (const yaml::Error& error) {
      report.add(origin, setting.name, error.faults().front().message);
    }
  }
}

Settings::Entry* Settings::take(const std::string& full_name) {
  if (entries_.empty()) return nullptr;
  const auto found = entries_.find(full_name);
  if (found == entries_.end()) return nullptr;
  found->second.used = true;
  return &found->second;
}

void Settings::offer(const std::string& full_name) {
  if (!entries_.empty()) offered_.push_back(full_name);
}

bool Settings::set_some(const std::string& key) const {
  return std::ranges::any_of(entries_, [&](const auto& entry) { return entry.first.ends_with("." + key); });
}

std::vector<std::string> Settings::keys_of(const std::string& prefix) const {
  std::vector<std::string> keys;
  for (const auto& [name, entry] : entries_)
    if (name.starts_with(prefix) && name.find('.', prefix.size()) == std::string::npos)
      keys.push_back(name.substr(prefix.size()));
  return keys;
}

void Settings::report_unused(Report& report) const {
  for (const auto& [name, entry] : entries_) {
    if (entry.used) continue;
    yaml::Message cure = yaml::did_you_mean(name, offered_);
    if (cure.empty() && !offered_.empty()) cure = yaml::nearest_or_all(name, offered_, "there are");
    report.add(entry.origin, "", fmt::format("there is no parameter '{}'", name) + cure);
  }
}

void define_parameters(Scope& scope, const Overrides& overrides, Settings& settings, Report& report) {
  Definitions(scope, overrides, settings, report).define_all();
}

}  // namespace stepwire::diagram
