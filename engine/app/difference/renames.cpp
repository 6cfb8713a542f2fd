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
constexpr std::size_t many_names = 100;    // from which on several pairs are taken at once
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

/// Similarity of each name of one file with each name of the other.
class Similarities {
 public:
  Similarities(const Unmatched& before, const Unmatched& after) : before_(before), after_(after) {
    for (std::size_t i = 0; i < after.names().size(); ++i) {
      totals_.push_back(total(after.features(after.names()[i])));
      for (const auto& [feature, count] : after.features(after.names()[i]))
        users_[feature].emplace_back(i, count);
    }
  }

  /// Returns the similarities of one name with all names of the other file.
  std::vector<double> of(const Name& name) const {
    std::vector<double> similar(totals_.size(), 0.0);
    for (const auto& [feature, count] : before_.features(name))
      if (const auto users = users_.find(feature); users != users_.end())
        for (const auto& [other, other_count] : users->second)
          similar[other] += weight_of(feature) * std::min(count, other_count);
    const double own = total(before_.features(name));
    for (std::size_t i = 0; i < similar.size(); ++i) {
      const Name& other = after_.names()[i];
      const bool fits = name.first == other.first && before_.type(name) == after_.type(other);
      const double all = std::max(own, totals_[i]);
      similar[i] = fits && all > 0.0 ? similar[i] / all : 0.0;
    }
    return similar;
  }

 private:
  const Unmatched &before_, &after_;
  std::vector<double> totals_;
  std::map<std::string, std::vector<std::pair<std::size_t, int>>> users_;
};

/// Returns the most similar pair. Of many names all pairs of the greatest similarity are returned. The list
/// is empty if no pair is similar enough.
NewNames best_pairs(const Unmatched& before, const Unmatched& after) {
  const Similarities similarities(before, after);
  NewNames best;
  std::set<std::size_t> taken;
  double most = least_similarity;
  for (const Name& name : before.names()) {
    const std::vector<double> similar = similarities.of(name);
    for (std::size_t i = 0; i < similar.size(); ++i) {
      if (similar[i] < most || (similar[i] == most && taken.contains(i))) continue;
      const bool is_further = !best.empty() && similar[i] == most;
      if (is_further && (before.names().size() < many_names || best.contains(name))) continue;
      if (!is_further) best.clear(), taken.clear();
      most = similar[i];
      best[name] = after.names()[i].second;
      taken.insert(i);
    }
  }
  return best;
}

}  // namespace

NewNames find_renames(const Fact& before, const Fact& after) {
  NewNames found;
  Fact now = before;
  for (;;) {
    const NewNames pairs = best_pairs(Unmatched(now, after), Unmatched(after, now));
    if (pairs.empty()) break;
    for (const auto& [name, to] : pairs) found[name] = to;
    rename(now, pairs);
  }
  return found;
}

}  // namespace stepwire::difference
