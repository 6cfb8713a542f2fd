// Renames. Problem: a name that only the old file has and one that only the new file has may be one thing.
// Idea: each such name has features, which are the facts of its definition and the facts that use it, with
// the name itself replaced by '*' and other names without a partner by '?'. A pair is as similar as the part
// of features that it shares. The most similar pair becomes a rename, the features are computed again with
// it, and so on until no pair shares half of its features. A chain of renamed blocks is thus found from its
// known end. Cost: a walk through both files for each rename.
#include "engine/app/difference/renames.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace stepwire::difference {
namespace {

constexpr double least_similarity = 0.5;
constexpr double weight_of_unknown = 0.5;  // of a feature with a name that has no partner yet

using Name = std::pair<NameKind, std::string>;
using Features = std::map<std::string, int>;

constexpr std::array<std::pair<NameKind, const char*>, 4> sections{{{NameKind::block, "blocks"},
                                                                    {NameKind::parameter, "parameters"},
                                                                    {NameKind::input, "inputs"},
                                                                    {NameKind::output, "outputs"}}};

/// Returns the definitions of a file in their order.
std::vector<std::pair<Name, const Fact*>> definitions(const Fact& root) {
  std::vector<std::pair<Name, const Fact*>> all;
  for (const auto& [kind, section] : sections)
    if (const Fact* map = root.find(section))
      for (const Fact& one : map->parts) all.push_back({{kind, unmarked(one.key)}, &one});
  return all;
}

/// Names of one file without a partner in the other one, with their features.
class Unmatched {
 public:
  Unmatched(const Fact& root, const Fact& other) {
    std::set<Name> known;
    for (const auto& [name, fact] : definitions(other)) known.insert(name);
    for (const auto& [name, fact] : definitions(root))
      if (!known.contains(name)) {
        order_.push_back(name);
        types_[name] = name.first == NameKind::block ? type_of(*fact) : "";
        features_[name];
      }
    if (!order_.empty()) walk(root, "");
  }

  const std::vector<Name>& names() const { return order_; }
  const std::string& type(const Name& name) const { return types_.at(name); }
  const Features& features(const Name& name) const { return features_.at(name); }

 private:
  bool is_unmatched(const Name& name) const { return features_.contains(name); }

  /// Replaces names without a partner, and one of them by '*'.
  std::string masked(const std::string& canonical, const Name& self) const {
    std::string text = canonical;
    for (const auto& [kind, section] : sections) {
      NewNames hidden;
      for (const std::string& name : names_in(canonical, kind))
        if (is_unmatched({kind, name})) hidden[{kind, name}] = Name{kind, name} == self ? "*" : "?";
      text = renamed(text, hidden);
    }
    return text;
  }

  void walk(const Fact& fact, const std::string& path) {
    for (const Fact& part : fact.parts) walk(part, path + "/" + part.key);
    if (!fact.parts.empty()) return;
    const std::string line = path + "=" + fact.canonical;
    for (const auto& [kind, section] : sections)
      for (const std::string& name : names_in(line, kind)) {
        const Name self{kind, name};
        if (is_unmatched(self) && noted_.emplace(&fact, self).second) ++features_[self][masked(line, self)];
      }
  }

  std::vector<Name> order_;
  std::map<Name, std::string> types_;
  std::map<Name, Features> features_;
  std::set<std::pair<const Fact*, Name>> noted_;
};

double weight_of(const std::string& feature) {
  return feature.find('?') == std::string::npos ? 1.0 : weight_of_unknown;
}

double total(const Features& features) {
  double sum = 0.0;
  for (const auto& [feature, count] : features) sum += weight_of(feature) * count;
  return sum;
}

double similarity(const Features& a, const Features& b) {
  double shared = 0.0;
  for (const auto& [feature, count] : a)
    if (const auto found = b.find(feature); found != b.end())
      shared += weight_of(feature) * std::min(count, found->second);
  const double all = std::max(total(a), total(b));
  return all > 0.0 ? shared / all : 0.0;
}

/// Returns the most similar pair; std::nullopt if no pair is similar enough.
std::optional<std::pair<Name, Name>> best_pair(const Unmatched& before, const Unmatched& after) {
  std::optional<std::pair<Name, Name>> best;
  double most = least_similarity;
  for (const Name& old_name : before.names())
    for (const Name& new_name : after.names()) {
      if (old_name.first != new_name.first || before.type(old_name) != after.type(new_name)) continue;
      const double similar = similarity(before.features(old_name), after.features(new_name));
      if (similar < most || (best && similar == most)) continue;
      most = similar;
      best = {old_name, new_name};
    }
  return best;
}

}  // namespace

NewNames find_renames(const Fact& before, const Fact& after) {
  NewNames found;
  Fact now = before;
  while (const auto pair = best_pair(Unmatched(now, after), Unmatched(after, now))) {
    found[pair->first] = pair->second.second;
    rename(now, {{pair->first, pair->second.second}});
  }
  return found;
}

}  // namespace stepwire::difference
