// Merge of three versions of a diagram. Problem: a merge of lines puts together what does not fit, and
// refuses what does. Idea: the versions are read as facts. Names are made equal first: a rename of one side
// is applied to the other two, in the facts and in the texts. Then each fact is merged by itself: where only
// `theirs` differs from `base`, the text of `ours` gets the value of `theirs` by an edit of its syntax tree.
// Where both differ in different ways, the fact is a conflict. The merged text is read again, and has to mean
// exactly the merged facts. Cost: a few walks through the files.
#include "engine/app/difference/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "engine/app/difference/difference_text.hpp"
#include "engine/app/difference/fact_edits.hpp"
#include "engine/app/difference/matching.hpp"
#include "engine/app/difference/order.hpp"
#include "engine/app/difference/rearrange.hpp"
#include "engine/app/difference/renames.hpp"
#include "engine/app/difference/revision.hpp"
#include "engine/app/difference/text_renames.hpp"
#include "engine/app/language/analysis.hpp"
#include "engine/app/language/tree_edits.hpp"
#include "engine/base/yaml/yaml_text.hpp"

namespace stepwire::difference {
namespace {

constexpr const char* section_of_conflicts = "conflicts";

const Fact& no_fact() {
  static const Fact none{.kind = Fact::Kind::map, .canonical = "{}"};
  return none;
}

std::string canonical_of(const Fact* fact) {
  return fact ? fact->canonical : "";
}

std::string joined_path(const std::string& path, const std::string& name) {
  const bool is_section = path == "blocks" || path == "parameters" || path.empty();
  return is_section ? name : name.empty() ? path : path + "." + name;
}

/// Three versions of one fact; nullptr where a version has none.
struct Versions {
  const Fact *base, *ours, *theirs;

  bool all_are(Fact::Kind kind) const {
    return ours && theirs && ours->kind == kind && theirs->kind == kind && (!base || base->kind == kind);
  }
};

/// Merge of the facts of three versions into the text of one.
class FactMerge {
 public:
  FactMerge(FactEdits& edits, std::vector<Conflict>& conflicts) : edits_(edits), conflicts_(conflicts) {}

  /// Merges a map, and returns the merged facts.
  Fact map(const Versions& of, const std::string& path) {
    const Fact& base = of.base ? *of.base : no_fact();
    const PartsByKey in_base(base), in_ours(*of.ours), in_theirs(*of.theirs);
    Fact merged = *of.ours;
    merged.parts.clear();
    for (const Fact& part : of.ours->parts) {
      const std::string key = unmarked(part.key);
      keep(merged, one({in_base.find(key), &part, in_theirs.find(key)}, *of.ours, path));
    }
    for (const Fact& part : of.theirs->parts)
      if (const std::string key = unmarked(part.key); !in_ours.find(key))
        keep(merged, one({in_base.find(key), nullptr, &part}, *of.ours, path));
    join_parts(merged);
    return merged;
  }

 private:
  static void keep(Fact& merged, std::optional<Fact> part) {
    if (part) merged.parts.push_back(std::move(*part));
  }

  /// True where one side changes a list of wires of a block and the other one another key of it, such as the
  /// signs of a sum. Merged key by key, values that belong to wires by their places would be those of others.
  static bool splits_a_list(const Versions& of) {
    if (!of.base || !of.ours || !of.theirs || names_in(of.ours->key, NameKind::block).empty()) return false;
    const auto changes = [&](const Fact& side, bool lists) {
      return std::ranges::any_of(side.parts, [&](const Fact& part) {
        const Fact* old = of.base->find(unmarked(part.key));
        const bool is_list = part.is_wire && part.kind == Fact::Kind::sequence;
        return is_list == lists && (!old || old->canonical != part.canonical);
      });
    };
    return (changes(*of.ours, true) && changes(*of.theirs, false)) ||
           (changes(*of.ours, false) && changes(*of.theirs, true));
  }

  /// Merges one key of a map. Returns std::nullopt where the merged map has no such key.
  std::optional<Fact> one(const Versions& of, const Fact& owner, const std::string& path) {
    const Fact& named = of.ours ? *of.ours : *of.theirs;
    const std::string name = joined_path(path, unmarked(named.key));
    const std::string base = canonical_of(of.base), ours = canonical_of(of.ours),
                      theirs = canonical_of(of.theirs);
    if (theirs == base || theirs == ours) return of.ours ? std::optional(*of.ours) : std::nullopt;
    if (ours != base && (has_two_types(of) || splits_a_list(of))) return conflict(of, name);
    if (has_two_types(of)) return taken(of, owner);
    if (of.all_are(Fact::Kind::map) && edits_.is_map(*of.ours)) return map(of, name);
    if (of.all_are(Fact::Kind::map) && is_short_beside_map(of)) return from_short_form(of, name);
    if (of.all_are(Fact::Kind::set)) return set(of, name);
    const bool is_same_length = of.ours && of.theirs && of.base &&
                                of.ours->parts.size() == of.theirs->parts.size() &&
                                of.ours->parts.size() == of.base->parts.size();
    if (of.all_are(Fact::Kind::sequence) && is_same_length && edits_.is_list(*of.ours))
      return sequence(of, name);
    if (ours == base) return taken(of, owner);
    return conflict(of, name);
  }

  /// True where ours is a short form, such as `k: 4`, and theirs a map in its text: `k: {value: 3, doc: of
  /// it}`.
  static bool is_short_beside_map(const Versions& of) {
    return of.ours->node && !of.ours->node->is_map() && of.theirs->node && of.theirs->node->is_map();
  }

  /// Merges a short form of ours: it gets the text of theirs with the values of the merge.
  Fact from_short_form(const Versions& of, const std::string& path) {
    FactEdits unused(edits_);  // a short form takes no part
    Fact merged = FactMerge(unused, conflicts_).map(of, path);
    yaml::Node node = *of.theirs->node;
    std::erase_if(node.entries, [&](const yaml::Entry& entry) {
      const Fact* stated = of.theirs->find(entry.key);
      return stated && !merged.find(entry.key);
    });
    for (const Fact& part : merged.parts) {
      const std::string key = unmarked(part.key);
      const Fact *of_ours = of.ours->find(key), *of_theirs = of.theirs->find(key);
      if (!of_ours || !of_ours->node || canonical_of(of_theirs) == part.canonical) continue;
      const auto there = std::ranges::find(node.entries, key, &yaml::Entry::key);
      if (there != node.entries.end())
        there->value = *of_ours->node;
      else
        node.entries.push_back({key, {}, *of_ours->node});
    }
    edits_.replace(*of.ours, Fact{.written = yaml::yaml_line(node)});
    return merged;
  }

  /// True for a block that is of another type in each version.
  static bool has_two_types(const Versions& of) {
    if (!of.ours || !of.theirs || names_in(of.ours->key, NameKind::block).empty()) return false;
    return of.ours->is_map() && of.theirs->is_map() && type_of(*of.ours) != type_of(*of.theirs);
  }

  /// Takes the version of theirs.
  std::optional<Fact> taken(const Versions& of, const Fact& owner) {
    if (!of.theirs) {
      edits_.remove(owner, *of.ours);
      return std::nullopt;
    }
    if (of.ours)
      edits_.replace(*of.ours, *of.theirs);
    else
      edits_.add(owner, *of.theirs);
    return *of.theirs;
  }

  std::optional<Fact> conflict(const Versions& of, const std::string& name) {
    const auto written = [&](const Fact* fact) {
      return fact ? fact->written : of.base ? "removed" : "absent";
    };
    conflicts_.push_back({name, of.base ? of.base->written : "absent", written(of.ours), written(of.theirs)});
    return of.ours ? std::optional(*of.ours) : std::nullopt;
  }

  Fact sequence(const Versions& of, const std::string& path) {
    Fact merged = *of.ours;
    for (std::size_t i = 0; i < merged.parts.size(); ++i) {
      const Versions item{&of.base->parts[i], &of.ours->parts[i], &of.theirs->parts[i]};
      if (auto part = one(item, *of.ours, fmt::format("{}.{}", path, i + 1)))
        merged.parts[i] = std::move(*part);
    }
    join_parts(merged);
    return merged;
  }

  using Partners = std::map<const Fact*, const Fact*>;
  static const Fact* partner_of(const Partners& partners, const Fact* item) {
    const auto found = partners.find(item);
    return found == partners.end() ? nullptr : found->second;
  }

  Fact set(const Versions& of, const std::string& path) {
    Fact none{.kind = Fact::Kind::set};
    const Fact& base = of.base ? *of.base : none;
    const Matches ours = matches_of(base, *of.ours), theirs = matches_of(base, *of.theirs);
    const Partners of_ours(ours.pairs.begin(), ours.pairs.end()),
        of_theirs(theirs.pairs.begin(), theirs.pairs.end());
    Fact merged = *of.ours;
    merged.parts.clear();
    for (const Fact* item : ours.added) merged.parts.push_back(*item);
    for (const Fact& item : base.parts)
      keep(merged,
           item_of_set({&item, partner_of(of_ours, &item), partner_of(of_theirs, &item)}, *of.ours, path));
    std::set<std::string> added;
    for (const Fact* item : ours.added) added.insert(item->canonical);
    for (const Fact* item : theirs.added) {
      if (added.contains(item->canonical)) continue;
      edits_.add_item(*of.ours, *item);
      merged.parts.push_back(*item);
    }
    join_parts(merged);
    return merged;
  }

  std::optional<Fact> item_of_set(const Versions& of, const Fact& owner, const std::string& path) {
    const std::string name = path + " '" + label_of(*of.base) + "'";
    const std::string base = canonical_of(of.base), ours = canonical_of(of.ours),
                      theirs = canonical_of(of.theirs);
    if (theirs == base || theirs == ours) return of.ours ? std::optional(*of.ours) : std::nullopt;
    if (of.all_are(Fact::Kind::map) && edits_.is_map(*of.ours)) return map(of, name);
    if (ours != base) return conflict(of, name);
    if (of.theirs) {
      edits_.replace(*of.ours, *of.theirs);
      return *of.theirs;
    }
    edits_.remove_item(owner, *of.ours);
    return std::nullopt;
  }

  FactEdits& edits_;
  std::vector<Conflict>& conflicts_;
};

/// One side of a merge.
struct Side {
  Texts texts;
  FileFacts facts;
};

/// Merge of three texts of one file.
class Merge {
 public:
  Merge(const Registry& registry, const std::string& path) : registry_(registry), path_(path) {}

  Merged run(const std::string& base, const std::string& ours, const std::string& theirs) {
    read(base_, base);
    read(ours_, ours);
    read(theirs_, theirs);
    Merged result;
    try {
      equalise_names();
      result = merged(base, ours, theirs);
    } catch (const language::EditRefused& refusal) {
      result = {.text = ours, .conflicts = {}, .faults = {}};
      if (!ours.ends_with('\n')) result.text += '\n';
      result.conflicts.push_back({fmt::format("the whole file ({})", refusal.what()), "the common ancestor",
                                  changes(base, ours), changes(base, theirs)});
    }
    if (!result.conflicts.empty()) add_conflicts(result);
    return result;
  }

 private:
  Merged merged(const std::string& base, const std::string& ours, const std::string& theirs) {
    Merged merged;
    merged.conflicts = conflicts_;
    FactEdits edits(*ours_.facts.source, *theirs_.facts.source);
    const Fact wanted = merged_facts(edits, merged.conflicts);
    note_missing(wanted, merged.conflicts);
    note_elements(merged.conflicts);
    const auto by_lines = merged.conflicts.empty() ? text_by_lines(wanted, base, ours, theirs) : std::nullopt;
    merged.text = by_lines ? *by_lines : edits.text();
    require_meaning(wanted, merged.text);
    keep_orders(wanted, merged);
    if (merged.conflicts.empty()) merged.faults = new_faults(merged.text, ours);
    return merged;
  }

  /// Returns what one side changed, in lines that are joined.
  std::string changes(const std::string& base, const std::string& side) const {
    Texts before, after;
    before.give(path_, base);
    after.give(path_, side);
    Comparer comparer(registry_, before, after);
    comparer.compare(path_, path_, false);
    std::vector<std::string> lines;
    for (const FileDifference& file : comparer.result().files)
      for (const Change& change : file.changes) lines.push_back(line_of(change));
    return lines.empty() ? "unchanged" : fmt::format("{}", fmt::join(lines, "; "));
  }

  void read(Side& side, const std::string& text) {
    side.texts.give(path_, text);
    side.facts = FactReader(registry_, side.texts).read(path_);
    if (const Fact* open = side.facts.root.find(section_of_conflicts))
      throw yaml::Error(yaml::Fault{{path_, open->mark},
                                    section_of_conflicts,
                                    "has conflicts of an earlier merge; resolve them first",
                                    {}});
  }

  /// Applies the renames of each side to the two other versions.
  void equalise_names() {
    NewNames by_ours = find_renames(base_.facts.root, ours_.facts.root);
    NewNames by_theirs = find_renames(base_.facts.root, theirs_.facts.root);
    NewNames for_base = by_theirs, for_ours, for_theirs;
    for (const auto& [name, to] : by_ours) for_base[name] = to;
    for (const auto& [name, to] : by_theirs)
      if (!by_ours.contains(name)) for_ours[name] = to;
    for (const auto& [name, to] : by_ours) {
      const auto other = by_theirs.find(name);
      if (other == by_theirs.end()) {
        for_theirs[name] = to;
      } else if (other->second != to) {
        for_theirs[{name.first, other->second}] = to;
        conflicts_.push_back({"name of " + name.second, name.second, to, other->second});
      }
    }
    apply(base_, for_base);
    apply(ours_, for_ours);
    apply(theirs_, for_theirs);
  }

  void apply(Side& side, const NewNames& names) {
    if (names.empty()) return;
    const auto text = with_new_names(registry_, side.texts, path_, names);
    if (!text)
      throw language::EditRefused(fmt::format("'{}' cannot be renamed to '{}' in all versions",
                                              names.begin()->first.second, names.begin()->second));
    side.texts = side.texts.with(path_, *text);
    side.facts = FactReader(registry_, side.texts).read(path_);
  }

  Fact merged_facts(FactEdits& edits, std::vector<Conflict>& conflicts) const {
    return FactMerge(edits, conflicts).map({&base_.facts.root, &ours_.facts.root, &theirs_.facts.root}, "");
  }

  /// Returns the merge of lines, with the comments of both sides, where it means the merged facts.
  std::optional<std::string> text_by_lines(const Fact& wanted, const std::string& base,
                                           const std::string& ours, const std::string& theirs) const {
    try {
      const MergedLines lines = merged_lines(base, ours, theirs);
      const bool is_right = lines.is_clean && means(wanted, lines.text);
      return is_right ? std::optional(lines.text) : std::nullopt;
    } catch (const yaml::Error&) {  // git is missing
      return std::nullopt;
    }
  }

  /// Returns the texts of ours with another text of the file, which is parsed once for several calls.
  Texts& with_text(const std::string& text) const {
    if (!merged_ || merged_->read(path_).text != text) merged_ = ours_.texts.with(path_, text);
    return *merged_;
  }

  bool means(const Fact& wanted, const std::string& text) const {
    try {
      return meaning_of(FactReader(registry_, with_text(text)).read(path_).root) == meaning_of(wanted);
    } catch (const yaml::Error&) {
      return false;
    }
  }

  /// Adds a conflict for each name that is used and that one side has removed.
  void note_missing(const Fact& wanted, std::vector<Conflict>& conflicts) const {
    for (const auto& [kind, section] : {std::pair{NameKind::block, "blocks"},
                                        {NameKind::parameter, "parameters"},
                                        {NameKind::input, "inputs"}}) {
      const Fact* found = wanted.find(section);
      const PartsByKey defined(found ? *found : no_fact());
      std::set<std::string> missing;
      for (const std::string& name : names_in(wanted.canonical, kind))
        if (!defined.find(name)) missing.insert(name);
      for (const std::string& name : missing) conflicts.push_back(conflict_of(section, name));
    }
  }

  /// Adds a conflict for each element of a joined vector, such as v.2 of a Mux, that one side names anew
  /// while the other one exchanges what is joined. The number of the element is then that of another signal.
  void note_elements(std::vector<Conflict>& conflicts) const {
    const Fact* blocks = base_.facts.root.find("blocks");
    if (!blocks) return;
    const auto blocks_of = [](const Side& side) {
      const Fact* found = side.facts.root.find("blocks");
      return PartsByKey(found ? *found : no_fact());
    };
    const PartsByKey ours = blocks_of(ours_), theirs = blocks_of(theirs_);
    for (const Fact& block : blocks->parts) {
      const std::string name = unmarked(block.key), type = type_of(block);
      if (type != "Mux" && type != "Concatenate" && type != "Stack") continue;
      const Versions inputs{inputs_of(&block), inputs_of(ours.find(name)), inputs_of(theirs.find(name))};
      note_elements_of(name, inputs, inputs.ours, theirs_, conflicts);
      note_elements_of(name, inputs, inputs.theirs, ours_, conflicts);
    }
  }

  /// Adds conflicts for one side, which joins other signals, and the elements that the other one names.
  void note_elements_of(const std::string& name, const Versions& inputs, const Fact* joining,
                        const Side& naming, std::vector<Conflict>& conflicts) const {
    const Fact* other = joining == inputs.ours ? inputs.theirs : inputs.ours;
    const std::string joined = canonical_of(joining);
    if (joined == canonical_of(inputs.base) || joined == canonical_of(other)) return;
    const auto written = [](const Fact* of) { return of ? of->written : "removed"; };
    std::set<std::string> named;
    add_elements(naming.facts.root, &base_.facts.root, name, named);
    for (const std::string& element : named)
      conflicts.push_back({element, written(inputs.base), written(inputs.ours), written(inputs.theirs)});
  }

  /// Adds the elements of a block in what differs from the base.
  static void add_elements(const Fact& fact, const Fact* base, const std::string& name,
                           std::set<std::string>& named) {
    if (base && base->canonical == fact.canonical) return;
    if (fact.parts.empty()) named.merge(elements_in(fact.canonical, name));
    std::unordered_map<std::string, const Fact*> old_parts;
    const auto text_of = [](const Fact& part) { return part.key.empty() ? part.canonical : part.key; };
    for (std::size_t i = 0; base && i < base->parts.size(); ++i)
      old_parts.emplace(text_of(base->parts[i]), &base->parts[i]);
    for (const Fact& part : fact.parts) {
      const auto found = old_parts.find(text_of(part));
      const Fact* before = found == old_parts.end() ? nullptr : found->second;
      add_elements(part, before, name, named);
    }
  }

  /// Returns the list of wires of a block; nullptr without one.
  static const Fact* inputs_of(const Fact* block) {
    for (std::size_t i = 0; block && i < block->parts.size(); ++i)
      if (block->parts[i].is_wire) return &block->parts[i];
    return nullptr;
  }

  /// Returns the elements of a block in a canonical text: "v.2", and "v.y.2" where its output is named.
  static std::set<std::string> elements_in(const std::string& canonical, const std::string& name) {
    const std::string mark = marked(NameKind::block, name);
    std::set<std::string> elements;
    for (std::size_t at = canonical.find(mark); at != std::string::npos; at = canonical.find(mark, at + 1)) {
      const std::size_t begin = at + mark.size();
      const std::size_t end = canonical.find_first_not_of(
          "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_.0123456789", begin);
      const std::string rest = canonical.substr(begin, end - begin);
      if (rest.find_first_of("0123456789") != std::string::npos) elements.insert(name + rest);
    }
    return elements;
  }

  Conflict conflict_of(const std::string& section, const std::string& name) const {
    const auto written = [&](const Side& side) -> std::string {
      const Fact* map = side.facts.root.find(section);
      const Fact* fact = map ? map->find(name) : nullptr;
      return fact ? fact->written : "removed";
    };
    return {name, written(base_), written(ours_), written(theirs_)};
  }

  void require_meaning(const Fact& wanted, const std::string& text) {
    if (!means(wanted, text))
      throw language::EditRefused("the merged text would not mean what both versions say; merge it by hand");
  }

  /// Returns the orders that a text does not have as one side changed them, or that both changed. Facts
  /// leave out the order of maps.
  std::vector<LostOrder> lost_orders_of(const std::string& text) const {
    const auto orders = [](const DiagramText& of) { return orders_of(of.document.root); };
    return lost_orders(orders(*base_.facts.source), orders(*ours_.facts.source),
                       orders(*theirs_.facts.source), orders(with_text(text).read(path_)));
  }

  /// Gives the merged text the order of the side that changed it. Adds a conflict where both did.
  void keep_orders(const Fact& wanted, Merged& merged) const {
    for (const LostOrder& one : lost_orders_of(merged.text)) {
      if (!one.wanted) continue;
      const std::string text = rearranged(with_text(merged.text).read(path_), one.place, *one.wanted);
      if (means(wanted, text)) merged.text = text;
    }
    const auto written = [](const std::vector<std::string>& names) {
      return names.empty() ? std::string("absent") : fmt::format("{}", fmt::join(names, ", "));
    };
    for (const LostOrder& one : lost_orders_of(merged.text))
      merged.conflicts.push_back(
          {"order of " + one.place, written(one.base), written(one.ours), written(one.theirs)});
  }

  std::vector<yaml::Fault> faults_of(const std::string& text) const {
    language::DiagramFiles files(registry_);
    files.texts().open(path_, text);
    return language::analyse(files, path_).faults;
  }

  /// Returns the faults that `ours` does not have, also those that `theirs` brings, as a file cut short.
  std::vector<yaml::Fault> new_faults(const std::string& text, const std::string& ours) const {
    std::vector<yaml::Fault> faults = faults_of(text);
    if (faults.empty()) return faults;
    std::set<std::string> known;
    for (const yaml::Fault& fault : faults_of(ours)) known.insert(fault.subject + fault.message.text());
    std::erase_if(faults, [&](const yaml::Fault& fault) {
      return known.contains(fault.subject + fault.message.text());
    });
    return faults;
  }

  void add_conflicts(Merged& merged) const {
    merged.text += conflicts_text(merged.conflicts);
    try {
      yaml::parse_document(merged.text, path_);
    } catch (const yaml::Error&) {  // a file in brackets
      throw language::EditRefused("both versions change " + merged.conflicts.front().at +
                                  ", and the file has no room for the section 'conflicts'; merge it by hand");
    }
  }

  static std::string conflicts_text(const std::vector<Conflict>& conflicts) {
    std::string text = std::string(section_of_conflicts) + ":\n";
    for (const Conflict& one : conflicts) {
      yaml::Node node;
      node.kind = yaml::Node::Kind::map;
      for (const auto& [key, value] :
           {std::pair{"at", &one.at}, {"base", &one.base}, {"ours", &one.ours}, {"theirs", &one.theirs}}) {
        yaml::Node text_node;
        text_node.kind = yaml::Node::Kind::scalar;
        text_node.text = *value;
        node.entries.push_back({key, {}, std::move(text_node)});
      }
      text += "  - " + yaml::yaml_line(node) + "\n";
    }
    return text;
  }

  const Registry& registry_;
  const std::string& path_;
  Side base_, ours_, theirs_;
  std::vector<Conflict> conflicts_;
  mutable std::optional<Texts> merged_;  ///< With the last text of with_text().
};

}  // namespace

Merged merge(const Registry& registry, const std::string& path, const std::string& base,
             const std::string& ours, const std::string& theirs) {
  return Merge(registry, path).run(base, ours, theirs);
}

}  // namespace stepwire::difference
