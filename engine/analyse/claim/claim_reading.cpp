#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/claim_words.hpp"
#include "engine/analyse/query/number.hpp"

namespace stepwire {
namespace {

using Keys = std::vector<std::string>;

const Keys claim_keys{"that",   "where",    "final",    "max",     "min",       "mean",     "rms",
                      "spread", "fraction", "count",    "at",      "rising",    "fit",      "equals",
                      "within", "at_most",  "at_least", "between", "disagrees", "each_run", "offset"};
const Keys comparison_keys{"equals", "at_most", "at_least", "between"};

std::string section_of(Claim::Kind kind) {
  return kind == Claim::Kind::invariant ? "invariants" : "claims";
}

/// Reads one claim; faults are gathered, so that what it returns after a fault is of no use.
class Reader {
 public:
  Reader(const Node& node, Claim::Kind kind, const Names& names, Faults& faults)
      : node_(node), names_(names), faults_(faults), section_(section_of(kind)), subject_(section_) {
    claim_.kind = kind;
  }

  Claim read() {
    claim_.place = {names_.file, node_.mark};
    for (const auto& entry : node_.entries) {
      if (std::find(claim_keys.begin(), claim_keys.end(), entry.key) != claim_keys.end()) continue;
      add_unknown_key(entry, claim_keys, "a claim", names_, section_, faults_);
      has_unknown_key_ = true;
    }
    if (const Node* that = node_.find("that"))
      claim_.that = read_text(*that, names_, section_ + ".that", faults_);
    else
      fault(node_.mark, section_, "a claim says in 'that' what it states");
    read_disagreement();
    if (const Node* where = node_.find("where")) claim_.where = formula(*where, section_ + ".where");
    read_reduction();
    read_options();
    read_comparison();
    finish();
    return std::move(claim_);
  }

 private:
  void fault(Mark mark, const std::string& subject, const std::string& message) {
    faults_.add({{names_.file, mark}, subject, message, {}});
  }

  std::optional<Formula> formula(const Node& node, const std::string& subject) {
    return read_formula(node, names_, subject, faults_);
  }

  void read_disagreement() {
    const Node* why = node_.find("disagrees");
    if (why == nullptr) return;
    if (claim_.kind == Claim::Kind::invariant)
      return fault(why->mark, section_ + ".disagrees",
                   "an invariant always holds; what a source says stands under 'claims'");
    claim_.disagrees = read_text(*why, names_, section_ + ".disagrees", faults_);
  }

  /// The one entry of the claim whose key is in `keys`; a fault where there is none or a second.
  const Entry* only_one(const Keys& keys, const std::string& what) {
    const Entry* found = nullptr;
    for (const auto& entry : node_.entries) {
      if (std::find(keys.begin(), keys.end(), entry.key) == keys.end()) continue;
      if (found != nullptr)
        fault(entry.mark, section_,
              fmt::format("both '{}' and '{}'; a claim has one {}", found->key, entry.key, what));
      else
        found = &entry;
    }
    if (found == nullptr && !has_unknown_key_)  // which may be what is missing, misspelt
      fault(node_.mark, section_, fmt::format("a claim needs one {}: {}", what, fmt::join(keys, ", ")));
    return found;
  }

  void read_reduction() {
    const Entry* entry = only_one(reduction_names(), "reduction");
    if (entry == nullptr) return;
    subject_ = section_ + "." + entry->key;
    claim_.reduction = reduction_named(entry->key);
    switch (claim_.reduction) {
      case Reduction::at:
        read_at(entry->value);
        break;
      case Reduction::rising:
        read_pair(entry->value, {"value", "over"}, "{value: ..., over: ...}");
        break;
      case Reduction::fit:
        read_fit(entry->value);
        break;
      default:
        add_value(&entry->value);
    }
  }

  void read_options() {
    claim_.each_run = claim_.reduction == Reduction::final || claim_.reduction == Reduction::at;
    if (const Node* each = node_.find("each_run")) {
      if (each->text != "true" && each->text != "false")
        fault(each->mark, section_ + ".each_run", fmt::format("'{}' is neither true nor false", each->text));
      claim_.each_run = claim_.each_run || each->text == "true";
    }
    const Node* offset = node_.find("offset");
    if (offset == nullptr) return;
    if (offset->text != "free" || claim_.reduction != Reduction::fit)
      fault(offset->mark, section_ + ".offset",
            "is 'offset: free', beside 'fit' only: the mean difference is not counted as an error");
    claim_.free_offset = true;
  }

  void add_value(const Node* node) {
    auto value = formula(*node, subject_);
    if (!value) return;
    const bool counts = claim_.reduction == Reduction::fraction || claim_.reduction == Reduction::count;
    if (counts && value->dimension && *value->dimension != Dimension{})
      return fault(node->mark, subject_,
                   fmt::format("'{}' is in {} and no condition; write what has to hold, such as '{} > 0'",
                               node->text, si_name(*value->dimension), node->text));
    claim_.values.push_back(std::move(*value));
  }

  void read_pair(const Node& node, const Keys& keys, const std::string& example) {
    bool has_unknown_key = false;
    for (const auto& entry : node.entries) {
      if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
      add_unknown_key(entry, keys, "it", names_, subject_, faults_);
      has_unknown_key = true;
    }
    for (const auto& key : keys) {
      const Node* value = node.find(key);
      if (value == nullptr && has_unknown_key) return;
      if (value == nullptr)
        return fault(node.mark, subject_, fmt::format("'{}' is missing: {}", key, example));
      if (key == "time")
        read_time(*value);
      else
        add_value(value);
    }
  }

  void read_at(const Node& node) { read_pair(node, {"time", "value"}, "{time: 2 s, value: ...}"); }

  void read_time(const Node& node) {
    const auto time = read_number(node, names_, subject_, faults_);
    if (!time) return;
    check_dimension(*time, Dimension{{0, 0, 1}}, "time", node, names_, subject_, faults_);
    claim_.time = time->value;
    time_text_ = time->text;
  }

  void read_fit(const Node& node) {
    if (!node.is_list() || node.items.size() != 2)
      return fault(node.mark, subject_, "fit takes [MODEL, MEASURED]");
    for (const auto& item : node.items) add_value(&item);
    if (claim_.values.size() != 2) return;
    const auto &model = claim_.values[0].dimension, &measured = claim_.values[1].dimension;
    if (model && measured && *model != *measured)
      fault(node.mark, subject_,
            fmt::format("'{}' is in {}, but '{}' is in {}", claim_.values[0].text, si_name(*model),
                        claim_.values[1].text, si_name(*measured)));
  }

  std::optional<double> number(const Node& node, const std::string& key) {
    const std::string subject = section_ + "." + key;
    auto read = read_number(node, names_, subject, faults_);
    if (!read) return std::nullopt;
    if (claim_.reduction == Reduction::fit && read->unit == "%") return 100.0 * read->value;
    check_dimension(*read, reduced_dimension(claim_), "the claim's value", node, names_, subject, faults_);
    if (claim_.comparison.unit.empty()) claim_.comparison.unit = read->unit;
    return read->value;
  }

  void read_comparison() {
    const Entry* entry = only_one(comparison_keys, "comparison");
    if (entry == nullptr) return;
    Comparison& comparison = claim_.comparison;
    const auto index = std::find(comparison_keys.begin(), comparison_keys.end(), entry->key);
    comparison.kind = static_cast<Comparison::Kind>(index - comparison_keys.begin());
    if (comparison.kind == Comparison::Kind::between) return read_between(entry->value);
    comparison.low = number(entry->value, entry->key).value_or(0.0);
    static const Keys signs{"=", "<=", ">="};
    comparison.text =
        fmt::format("{} {}", signs[static_cast<std::size_t>(comparison.kind)], entry->value.text);
    read_within();
  }

  void read_between(const Node& node) {
    if (!node.is_list() || node.items.size() != 2)
      return fault(node.mark, section_ + ".between", "between takes two numbers: [3.1 N, 3.3 N]");
    const auto low = number(node.items[0], "between"), high = number(node.items[1], "between");
    if (low && high && *low > *high)
      fault(node.mark, section_ + ".between",
            fmt::format("{} is above {}; the smaller number comes first", node.items[0].text,
                        node.items[1].text));
    claim_.comparison.low = low.value_or(0.0);
    claim_.comparison.high = high.value_or(0.0);
    claim_.comparison.text = fmt::format("between {} and {}", node.items[0].text, node.items[1].text);
    read_within();
  }

  void read_within() {
    const Node* node = node_.find("within");
    if (node == nullptr) return;
    Comparison& comparison = claim_.comparison;
    if (comparison.kind != Comparison::Kind::equals)
      return fault(node->mark, section_ + ".within", "'within' goes with 'equals' only");
    const auto read = read_number(*node, names_, section_ + ".within", faults_);
    if (!read) return;
    const bool relative = read->unit == "%";
    if (!relative)
      check_dimension(*read, reduced_dimension(claim_), "the claim's value", *node, names_,
                      section_ + ".within", faults_);
    comparison.within = relative ? read->value * std::abs(comparison.low) : read->value;
    comparison.text += " within " + node->text;
    if (relative && comparison.low == 0.0)
      fault(node->mark, section_ + ".within",
            fmt::format("{} of 0 is 0; give a tolerance with the unit of the value", node->text));
    if (comparison.within < 0.0) fault(node->mark, section_ + ".within", "a tolerance is not negative");
  }

  void finish() {
    std::vector<const Formula*> all;
    for (const auto& value : claim_.values) all.push_back(&value);
    if (claim_.where) all.push_back(&*claim_.where);
    claim_.recording = common_recording(all, names_, node_, subject_, faults_);
    claim_.check = check_text(claim_, time_text_);
  }

  const Node& node_;
  const Names& names_;
  Faults& faults_;
  Claim claim_;
  std::string section_, subject_, time_text_;
  bool has_unknown_key_ = false;
};

}  // namespace

std::vector<Claim> read_claims(const Node& node, Claim::Kind kind, const Names& names, Faults& faults) {
  std::vector<Claim> claims;
  const std::string section = section_of(kind), example = "{that: ..., final: ..., equals: ...}";
  if (!node.is_list()) {
    faults.add({{names.file, node.mark}, section, fmt::format("{} are a list: - {}", section, example), {}});
    return claims;
  }
  for (const auto& item : node.items) {
    if (item.is_map())
      claims.push_back(Reader(item, kind, names, faults).read());
    else
      faults.add({{names.file, item.mark}, section, fmt::format("a claim is a map: {}", example), {}});
  }
  return claims;
}

}  // namespace stepwire
