// Renames. Problem: a name that only the old file has and one that only the new file has may be one thing.
// Idea: each such name has features, which are the facts of its definition and the facts that use it, with
// the name itself replaced by '*' and other names without a partner by '?'. Two names that alone have the
// same features become a rename, and the features of their neighbours are computed again with it. A chain of
// renamed blocks is thus found from its known end. Without such names, two of which each is the most similar
// one of the other by itself are taken if they share half of their features, neighbours of known ones first.
// Names that are alike in all of this have nothing but their order; of many such names those are left out
// whose number differs. Cost: one walk through both files, and for each pair its neighbours. Names without
// equal ones are compared each with each, a few times.
#include "engine/app/difference/renames.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace stepwire::difference {
namespace {

constexpr double least_similarity = 0.5;
constexpr std::size_t many_names = 100;    // from which on order alone makes no pair
constexpr int comparisons_of_many = 20;    // each with each
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

  const OpenName& at(std::size_t index) const { return names_[index]; }
  std::size_t count() const { return names_.size(); }
  std::size_t index_of(const Name& name) const { return index_.at(name); }

  /// Closes names that have found a partner, and gives them its name. Returns the names whose features have
  /// changed by it.
  std::set<std::size_t> close(const NewNames& pairs) {
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
    return neighbours;
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

/// Open names of both files, by their features.
class Twins {
 public:
  Twins(const Unmatched& before, const Unmatched& after) : sides_{&before, &after} {
    for (std::size_t side = 0; side < 2; ++side) {
      places_[side].assign(sides_[side]->count(), all_.end());
      for (std::size_t i = 0; i < sides_[side]->count(); ++i) add(side, i);
    }
  }

  void remove(std::size_t side, std::size_t index) {
    const Place place = std::exchange(places_[side][index], all_.end());
    if (place == all_.end()) return;
    place->second[side].erase(index);
    note(place);
  }
  /// Finds the place of a name whose features have changed.
  void move(std::size_t side, std::size_t index) {
    remove(side, index);
    add(side, index);
  }

  /// Returns the pairs of names that alone have their features.
  NewNames take_unique() {
    NewNames pairs;
    for (const Place place : std::exchange(unique_, {}))
      if (is_pair(place)) add_pairs(place, pairs);
    return pairs;
  }
  /// Returns pairs, in the order of the files, of the first names that are as many in both.
  NewNames in_order() const {
    NewNames pairs;
    for (const Place place : places_[0]) {
      if (place == end_) continue;
      if (place->second[0].size() != place->second[1].size()) continue;
      add_pairs(place, pairs);
      break;
    }
    return pairs;
  }

 private:
  using Key = std::pair<std::size_t, Features>;
  using Members = std::array<std::set<std::size_t>, 2>;
  using Place = std::map<Key, Members>::iterator;

  static bool is_pair(Place place) { return place->second[0].size() == 1 && place->second[1].size() == 1; }
  void note(Place place) {
    if (is_pair(place)) unique_.push_back(place);
  }
  void add(std::size_t side, std::size_t index) {
    const OpenName& name = sides_[side]->at(index);
    if (name.features.empty()) return;
    const Place place = all_.try_emplace({name.group, name.features}).first;
    place->second[side].insert(index);
    places_[side][index] = place;
    note(place);
  }
  void add_pairs(Place place, NewNames& pairs) const {
    auto other = place->second[1].begin();
    for (const std::size_t index : place->second[0])
      pairs[sides_[0]->at(index).name] = sides_[1]->at(*other++).name.second;
  }

  std::array<const Unmatched*, 2> sides_;
  std::map<Key, Members> all_;
  const Place end_ = all_.end();
  std::array<std::vector<Place>, 2> places_;  ///< of each name; end_ for a closed one
  std::vector<Place> unique_;                 ///< those that had one name of each file
};

/// Comparison of open names of both files, each with each.
class Comparison {
 public:
  using Names = std::vector<const OpenName*>;

  Comparison(Names before, Names after, const FeatureNumbers& numbers)
      : before_(std::move(before)), after_(std::move(after)), similarities_(after_, numbers) {
    of_before_.resize(before_.size());
    of_after_.resize(after_.size());
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const std::vector<double> similar = similarities_.of(*before_[i]);
      for (std::size_t k = 0; k < similar.size(); ++k) {
        of_before_[i].look(similar[k], k);
        of_after_[k].look(similar[k], i);
      }
    }
  }

  /// Returns the pairs of which each is the most similar one of the other by itself.
  NewNames mutual() const {
    NewNames pairs;
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const Best& best = of_before_[i];
      if (best.is_one() && of_after_[best.who].is_one() && of_after_[best.who].who == i)
        pairs[before_[i]->name] = after_[best.who]->name.second;
    }
    return pairs;
  }
  /// Returns the first of the most similar pairs.
  NewNames first() const {
    const auto most = std::ranges::max_element(of_before_, {}, &Best::similarity);
    if (most == of_before_.end() || most->similarity < least_similarity) return {};
    return {
        {before_[static_cast<std::size_t>(most - of_before_.begin())]->name, after_[most->who]->name.second}};
  }

 private:
  struct Best {
    double similarity = 0.0;
    std::size_t who = 0, count = 0;

    void look(double similar, std::size_t other) {
      if (similar > similarity) *this = {similar, other, 0};
      count += similar == similarity ? 1 : 0;
    }
    bool is_one() const { return count == 1 && similarity >= least_similarity; }
  };

  Names before_, after_;
  Similarities similarities_;
  std::vector<Best> of_before_, of_after_;
};

/// Search for renames in two files.
class Search {
 public:
  Search(const Fact& before, const Fact& after)
      : before_(before, after, numbers_), after_(after, before, numbers_), twins_(before_, after_) {}

  NewNames run() {
    int left = comparisons_of_many;
    for (NewNames pairs = twins_.take_unique();; pairs = twins_.take_unique()) {
      if (pairs.empty()) pairs = compared(left);
      if (pairs.empty()) return std::move(found_);
      close(pairs);
    }
  }

 private:
  NewNames compared(int& left) {
    if (NewNames pairs = near_pairs(); !pairs.empty()) return pairs;
    const bool has_many = before_.names().size() >= many_names;
    if (has_many && left-- <= 0) return {};
    const Comparison comparison(before_.names(), after_.names(), numbers_);
    NewNames pairs = comparison.mutual();
    if (pairs.empty()) pairs = has_many ? twins_.in_order() : comparison.first();
    return pairs;
  }
  /// Compares the neighbours of the last pairs.
  NewNames near_pairs() {
    Comparison::Names before, after;
    for (const std::size_t name : std::exchange(near_[0], {}))
      if (before_.at(name).is_open) before.push_back(&before_.at(name));
    for (const std::size_t name : std::exchange(near_[1], {}))
      if (after_.at(name).is_open) after.push_back(&after_.at(name));
    if (before.empty() || after.empty()) return {};
    return Comparison(std::move(before), std::move(after), numbers_).mutual();
  }

  void close(const NewNames& pairs) {
    NewNames partners;
    for (const auto& [name, to] : pairs) {
      const Name partner{name.first, to};
      found_[name] = partners[partner] = to;
      twins_.remove(0, before_.index_of(name));
      twins_.remove(1, after_.index_of(partner));
    }
    move(0, before_.close(pairs));
    move(1, after_.close(partners));
  }

  void move(std::size_t side, const std::set<std::size_t>& names) {
    for (const std::size_t name : names) twins_.move(side, name);
    near_[side].insert(names.begin(), names.end());
  }

  FeatureNumbers numbers_;
  Unmatched before_, after_;
  Twins twins_;
  std::array<std::set<std::size_t>, 2> near_;  ///< neighbours of pairs that were not compared since
  NewNames found_;
};

}  // namespace

NewNames find_renames(const Fact& before, const Fact& after) {
  return Search(before, after).run();
}

}  // namespace stepwire::difference
