#include "engine/diagram/definitions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/diagram/keys.hpp"

namespace stepwire {

namespace {

const std::vector<std::string> definition_keys = {"value", "unit",  "doc",      "assumed",
                                                  "above", "below", "at_least", "at_most"};

constexpr std::size_t longest_chain = 1000;  // of parameters that each use one further down

/// Evaluates definitions on demand, so that they may stand in any order.
class Definitions {
 public:
  Definitions(Scope& scope, const Overrides& overrides, Settings& settings, Report& report)
      : scope_(scope), overrides_(overrides), settings_(settings), report_(report) {
    if (const Node* map = scope.document->root.find("parameters"))
      for (const Entry& entry : map->entries) entries_[entry.key] = &entry;
  }

  void define_all() {
    const Node* map = scope_.document->root.find("parameters");
    if (!map) return;
    if (!map->is_map())
      return report_.add(scope_.at(map->mark), "parameters", "must be a map of name: value");
    for (const Entry& entry : map->entries) define(entry.key);
  }

 private:
  void define(const std::string& name) {
    const auto found = entries_.find(name);
    if (found == entries_.end() || scope_.parameters.defined(name) || failed_.contains(name)) return;
    const Entry& entry = *found->second;
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
      scope_.parameters.define(name, std::move(*value));
    } else {
      failed_.insert(name);
      scope_.parameters.define(name, {{1.0}, {}, "", true});
    }
  }

  void fail(const Entry& entry, const std::string& message) {
    if (failed_.insert(entry.key).second) report_.add(scope_.at(entry.mark), entry.key, message);
    scope_.parameters.define(entry.key, {{1.0}, {}, "", true});
  }

  static const Node& definition(const Entry& entry) {
    const Node* value = entry.value.is_map() ? entry.value.find("value") : nullptr;
    return value ? *value : entry.value;
  }

  /// Every name of this file that occurs in the text as a word; that is more than is needed at worst.
  void define_what_it_uses(const Node& node) {
    for (const Node& item : node.items) define_what_it_uses(item);
    for (const Entry& entry : node.entries)
      if (entry.key != "doc") define_what_it_uses(entry.value);
    if (!node.is_scalar() || (!node.text.starts_with('=') && !node.text.starts_with('$'))) return;
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

  std::optional<WrittenValue> evaluate(const Entry& entry) {
    const std::string full = scope_.prefix + entry.key;
    if (entry.value.is_map()) {
      const bool other_key = refuse_unknown_keys(entry.value, definition_keys, full, scope_, report_);
      if (!entry.value.find("value")) {
        if (!other_key)
          report_.add(scope_.at(entry.value.mark), full, "'value' is missing, as {value: 2 kg}");
        settings_.offer(full);
        return std::nullopt;
      }
    }
    ValueReader reader(scope_.parameters, report_, scope_.index);
    auto written = reader.read(stripped(entry.value), full);
    settings_.offer(full);
    const auto file_dimension = written ? written->dimension : std::nullopt;
    const bool set = replace(entry, full, written);
    if (!written) return std::nullopt;
    if (!written->dimension) written->dimension = file_dimension;
    const std::string complaint = unit_complaint(written->dimension, file_dimension);
    if (!complaint.empty()) {
      report_.add(value_origin_, full, fmt::format("{} {}", written->text, complaint));
      written->dimension = file_dimension;  // so that it is not told again at every use
    }
    if (!in_range(entry, *written, full)) return std::nullopt;
    list(full, entry, *written, set);
    return written;
  }

  /// The definition without what is said about it, as {value: .., unit: ..}.
  static Node stripped(const Node& node) {
    if (!node.is_map()) return node;
    Node result = node;
    std::erase_if(result.entries,
                  [](const Entry& entry) { return entry.key != "value" && entry.key != "unit"; });
    return result;
  }

  bool replace(const Entry& entry, const std::string& full, std::optional<WrittenValue>& written) {
    value_origin_ = scope_.at(definition(entry).mark);
    if (const auto given = overrides_.values.find(entry.key); given != overrides_.values.end()) {
      ValueReader reader(overrides_.from->parameters, report_, overrides_.from->index);
      value_origin_ = overrides_.from->at(given->second->mark);
      written = reader.read(*given->second, full);
    }
    if (Settings::Entry* setting = settings_.take(full)) {
      ValueReader reader(scope_.parameters, report_, setting->origin.scope);
      value_origin_ = setting->origin;
      written = reader.read(setting->document.root, full);
      return true;
    }
    return false;
  }

  bool in_range(const Entry& entry, const WrittenValue& written, const std::string& full) {
    if (!entry.value.is_map()) return true;
    const auto holds = [&](const char* key, auto compare) {
      const Node* bound = entry.value.find(key);
      if (!bound) return true;
      const auto limit = read_bound(*bound, written, full + "." + key);
      if (!limit) return false;
      if (all_of_numbers(written.value, [&](double number) { return compare(number, *limit); })) return true;
      const char* words = std::string_view(key) == "at_least"  ? "at least"
                          : std::string_view(key) == "at_most" ? "at most"
                                                               : key;
      report_.add(value_origin_, full,
                  fmt::format("{} is not allowed; it must be {} {}", written.text, words, bound->text));
      return false;
    };
    return holds("above", std::greater<>()) && holds("at_least", std::greater_equal<>()) &&
           holds("below", std::less<>()) && holds("at_most", std::less_equal<>());
  }

  std::optional<double> read_bound(const Node& bound, const WrittenValue& written,
                                   const std::string& subject) {
    const ValueReader reader(scope_.parameters, report_, scope_.index);
    const auto limit = reader.read(bound, subject);
    if (!limit) return std::nullopt;
    const double* number = std::get_if<double>(&limit->value.content);
    const std::string complaint = number ? unit_complaint(limit->dimension, written.dimension)
                                         : std::string("is no number, and a bound is one");
    if (complaint.empty()) return *number;
    report_.add(scope_.at(bound.mark), subject, fmt::format("'{}' {}", limit->text, complaint));
    return std::nullopt;
  }

  template <class Check>
  static bool all_of_numbers(const Value& value, const Check& check) {
    if (const auto* number = std::get_if<double>(&value.content)) return check(*number);
    if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
      return std::all_of(vector->begin(), vector->end(), check);
    const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content);
    return !matrix || std::all_of(matrix->data(), matrix->data() + matrix->size(), check);
  }

  void list(const std::string& full, const Entry& entry, const WrittenValue& written, bool set) {
    const Node* doc = entry.value.find("doc");
    const Node* assumed = entry.value.find("assumed");
    report_.diagram().parameters.push_back(
        {full, written.text, written.value, written.dimension,
         doc ? read_text(*doc, full + ".doc", scope_, report_) : "",
         assumed && read_flag(*assumed, full + ".assumed", scope_, report_), set});
  }

  Scope& scope_;
  const Overrides& overrides_;
  Settings& settings_;
  Report& report_;
  std::map<std::string, const Entry*> entries_;
  std::vector<std::string> open_;  ///< what is being defined, the outermost first
  std::set<std::string> failed_;
  Origin value_origin_;
};

}  // namespace

void define_parameters(Scope& scope, const Overrides& overrides, Settings& settings, Report& report) {
  Definitions(scope, overrides, settings, report).define_all();
}

}  // namespace stepwire
