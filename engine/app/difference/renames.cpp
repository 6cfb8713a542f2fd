// Renames. Problem: a name that only the old file has and one that only the new file has may be one thing.
// Idea: each such name has features, which are the facts of its definition and the facts that use it, with
// the name itself replaced by '*' and other names without a partner by '?'. A pair is as similar as the part
// of features that it shares. The most similar pair becomes a rename, the features are computed again with
// it, and so on until no pair shares half of its features. A chain of renamed blocks is thus found from its
// known end. Cost: one walk through both files. A round computes the features of the neighbours of new pairs
// again. Names of equal features are found by a search; the others are compared each with each.
#include "engine/app/difference/renames.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <ranges>
#include <set>
#include <string>
#include <unordered_map>

namespace stepwire::difference {
namespace {

constexpr double least_similarity = 0.5;
constexpr std::size_t many_names = 100;    // from which on several pairs are taken at once
constexpr int rounds_of_many = 8;          // after which each of many names takes its most similar one
constexpr double weight_of_unknown = 0.5;  // of a feature with a name that has no partner yet

using Name = std::pair<NameKind, std::string>;
using Definitions = std::vector<std::pair<Name, const Fact*>>;

/// Numbers of features with their counts, sorted.
using Features = std::vector<std::pair<std::size_t, int>>;

constexpr std::array<std::pair<NameKind, const char*>, 4> sections{{{NameKind::block, "blocks"},
                                                                    {NameKind::parameter, "parameters"},
                                                                    {NameKind::input, "inputs"},
                                                                    {NameKind::output, "outputs"}}};

/// Returns the definitions of a file in their order.
Definitions definitions(const Fact& root) {
  Definitions all;
  for (const auto& [kind, section] : sections)
    if (const Fact* map = root.find(section))
      for (const Fact& one : map->parts) all.push_back({{kind, unmarked(one.key)}, &one});
  return all;
}

/// Numbers of the features of both files.
class FeatureNumbers {
 public:
  std::size_t of(const std::string& feature) {
    const auto [found, is_new] = numbers_.emplace(feature, weights_.size());
    if (is_new) weights_.push_back(weight_of(feature));
    return found->second;
  }
  double weight(std::size_t feature) const { return weights_[feature]; }
  double total(const Features& features) const {
    double sum = 0.0;
    for (const auto& [feature, count] : features) sum += weight(feature) * count;
    return sum;
  }

 private:
  /// A type alone makes no two blocks the same one: all pairs that are compared share it.
  static double weight_of(const std::string& feature) {
    if (feature.starts_with("/blocks/") && feature.find('*') < feature.find("/block=") &&
        feature.find("/block=") < feature.find('='))
      return 0.0;
    return feature.find('?') == std::string::npos ? 1.0 : weight_of_unknown;
  }

  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<double> weights_;
};

/// Name without a partner.
struct OpenName {
  Name name;
  std::size_t group = 0;             ///< Number of its kind and type.
  std::vector<std::size_t> lines{};  ///< Facts that contain it.
  Features features{};
  bool is_open = true;
};

/// Names of one file without a partner in the other one, with their features.
class Unmatched {
 public:
  Unmatched(const Fact& root, const Fact& other, FeatureNumbers& numbers) : numbers_(numbers) {
    std::set<Name> known;
    for (const auto& [name, fact] : definitions(other)) known.insert(name);
    for (const auto& [name, fact] : definitions(root)) {
      if (known.contains(name) || !index_.emplace(name, names_.size()).second) continue;
      const std::string type = name.first == NameKind::block ? type_of(*fact) : "";
      const std::size_t group = numbers.of(std::to_string(static_cast<int>(name.first)) + " " + type);
      names_.push_back({.name = name, .group = group});
    }
    if (!names_.empty()) walk(root, "");
    for (OpenName& one : names_) count_features(one);
  }

  /// Returns the names that are open, in the order of the file.
  std::vector<const OpenName*> names() const {
    std::vector<const OpenName*> open;
    for (const OpenName& one : names_)
      if (one.is_open) open.push_back(&one);
    return open;
  }

  /// Closes names that have found a partner, and gives them its name.
  void close(const NewNames& pairs) {
    std::set<std::size_t> lines, neighbours;
    for (const auto& [name, to] : pairs) {
      OpenName& one = names_[index_.at(name)];
      one.is_open = false;
      lines.insert(one.lines.begin(), one.lines.end());
    }
    for (const std::size_t line : lines) {
      for (const std::size_t name : open_names(lines_[line])) neighbours.insert(name);
      lines_[line] = renamed(lines_[line], pairs);
    }
    for (const std::size_t name : neighbours) count_features(names_[name]);
  }

 private:
  /// Returns the open names in a text, each once.
  std::set<std::size_t> open_names(const std::string& text) const {
    std::set<std::size_t> found;
    for (const auto& [kind, section] : sections)
      for (const std::string& name : names_in(text, kind))
        if (const auto one = index_.find({kind, name}); one != index_.end() && names_[one->second].is_open)
          found.insert(one->second);
    return found;
  }

  /// Replaces open names by '?', and one of them by '*'.
  std::string masked(const std::string& text, const Name& self) const {
    NewNames hidden;
    for (const std::size_t name : open_names(text))
      hidden[names_[name].name] = names_[name].name == self ? "*" : "?";
    return renamed(text, hidden);
  }

  void walk(const Fact& fact, const std::string& path) {
    for (const Fact& part : fact.parts) walk(part, path + "/" + part.key);
    if (!fact.parts.empty()) return;
    std::string line = path + "=" + fact.canonical;
    const std::set<std::size_t> used = open_names(line);
    if (used.empty()) return;
    for (const std::size_t name : used) names_[name].lines.push_back(lines_.size());
    lines_.push_back(std::move(line));
  }

  void count_features(OpenName& one) {
    std::map<std::size_t, int> counts;
    for (const std::size_t line : one.lines) ++counts[numbers_.of(masked(lines_[line], one.name))];
    one.features.assign(counts.begin(), counts.end());
  }

  FeatureNumbers& numbers_;
  std::vector<OpenName> names_;
  std::map<Name, std::size_t> index_;
  std::vector<std::string> lines_;
};

/// Similarity of each open name of one file with each of the other.
class Similarities {
 public:
  Similarities(const std::vector<const OpenName*>& after, const FeatureNumbers& numbers)
      : after_(after), numbers_(numbers) {
    for (std::size_t i = 0; i < after.size(); ++i) {
      totals_.push_back(numbers.total(after[i]->features));
      groups_.push_back(after[i]->group);
      for (const auto& [feature, count] : after[i]->features) users_[feature].emplace_back(i, count);
    }
  }

  /// Returns the similarities of one name with all names of the other file.
  std::vector<double> of(const OpenName& name) const {
    std::vector<double> similar(totals_.size(), 0.0);
    for (const auto& [feature, count] : name.features)
      if (const auto users = users_.find(feature); users != users_.end())
        for (const auto& [other, other_count] : users->second)
          similar[other] += numbers_.weight(feature) * std::min(count, other_count);
    const double own = numbers_.total(name.features);
    for (std::size_t i = 0; i < similar.size(); ++i) {
      if (similar[i] == 0.0) continue;
      const bool fits = name.group == groups_[i];
      similar[i] = fits ? similar[i] / std::max(own, totals_[i]) : 0.0;
    }
    return similar;
  }

 private:
  const std::vector<const OpenName*>& after_;
  const FeatureNumbers& numbers_;
  std::vector<double> totals_;
  std::vector<std::size_t> groups_;
  std::unordered_map<std::size_t, std::vector<std::pair<std::size_t, int>>> users_;
};

/// One round of the search.
class Round {
 public:
  Round(const Unmatched& before, const Unmatched& after, const FeatureNumbers& numbers)
      : before_(before.names()), after_(after.names()), numbers_(numbers) {}

  bool has_many() const { return before_.size() >= many_names; }

  /// Returns the most similar pair. Of many names all pairs of the greatest similarity are returned. The list
  /// is empty if no pair is similar enough.
  NewNames best_pairs() const {
    NewNames equal = equal_pairs();
    return equal.empty() ? similar_pairs() : equal;
  }

  /// Returns a partner for each name that has a similar one, the most similar pairs first.
  NewNames all_pairs() const {
    const Similarities similarities(after_, numbers_);
    std::vector<std::pair<double, const OpenName*>> order;
    for (const OpenName* name : before_) {
      const std::vector<double> similar = similarities.of(*name);
      order.emplace_back(similar.empty() ? 0.0 : std::ranges::max(similar), name);
    }
    std::ranges::stable_sort(order, std::greater{}, [](const auto& one) { return one.first; });
    NewNames pairs;
    std::vector<bool> is_taken(after_.size(), false);
    for (const auto& [most, name] : order) {
      std::vector<double> similar = similarities.of(*name);
      for (std::size_t i = 0; i < similar.size(); ++i)
        if (is_taken[i]) similar[i] = 0.0;
      const auto best = std::ranges::max_element(similar);
      if (best == similar.end() || *best < least_similarity) continue;
      const auto other = static_cast<std::size_t>(best - similar.begin());
      is_taken[other] = true;
      pairs[name->name] = after_[other]->name.second;
    }
    return pairs;
  }

 private:
  /// Returns pairs that share all features; of few names the first one.
  NewNames equal_pairs() const {
    std::map<std::pair<std::size_t, Features>, std::vector<const OpenName*>> others;
    for (const OpenName* other : std::ranges::reverse_view(after_))
      if (!other->features.empty()) others[{other->group, other->features}].push_back(other);
    NewNames pairs;
    for (const OpenName* name : before_) {
      const auto found = others.find({name->group, name->features});
      if (found == others.end() || found->second.empty()) continue;
      pairs[name->name] = found->second.back()->name.second;
      found->second.pop_back();
      if (!has_many()) break;
    }
    return pairs;
  }

  NewNames similar_pairs() const {
    const Similarities similarities(after_, numbers_);
    NewNames best;
    std::vector<bool> is_taken(after_.size(), false);
    double most = least_similarity;
    for (const OpenName* name : before_) {
      const std::vector<double> similar = similarities.of(*name);
      for (std::size_t i = 0; i < similar.size(); ++i) {
        if (similar[i] < most || (similar[i] == most && is_taken[i])) continue;
        const bool is_further = !best.empty() && similar[i] == most;
        if (is_further && (!has_many() || best.contains(name->name))) continue;
        if (!is_further) best.clear(), is_taken.assign(after_.size(), false);
        most = similar[i];
        best[name->name] = after_[i]->name.second;
        is_taken[i] = true;
      }
    }
    return best;
  }

  std::vector<const OpenName*> before_, after_;
  const FeatureNumbers& numbers_;
};

}  // namespace

NewNames find_renames(const Fact& before, const Fact& after) {
  FeatureNumbers numbers;
  Unmatched old_names(before, after, numbers), new_names(after, before, numbers);
  NewNames found;
  for (int round = 1;; ++round) {
    const Round now(old_names, new_names, numbers);
    const NewNames pairs = now.has_many() && round > rounds_of_many ? now.all_pairs() : now.best_pairs();
    if (pairs.empty()) return found;
    NewNames partners;
    for (const auto& [name, to] : pairs) found[name] = to, partners[{name.first, to}] = to;
    old_names.close(pairs);
    new_names.close(partners);
  }
}

}  // namespace stepwire::difference
