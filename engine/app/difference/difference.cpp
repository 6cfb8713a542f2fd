#include "engine/app/difference/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <unordered_map>

#include "engine/app/difference/matching.hpp"
#include "engine/app/difference/order.hpp"
#include "engine/app/difference/renames.hpp"

namespace stepwire::difference {
namespace {

using Kind = Change::Kind;

/// Returns new number over old number where both are plain numbers of one unit.
std::optional<double> ratio_of(const Fact& from, const Fact& to) {
  const auto unit_of = [](const Fact& fact) {
    const std::size_t at = fact.canonical.find('[');
    return at == std::string::npos ? "" : fact.canonical.substr(at);
  };
  if (!from.number || !to.number || *from.number == 0.0 || unit_of(from) != unit_of(to)) return std::nullopt;
  const double ratio = *to.number / *from.number;
  return std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
}

std::string joined(const std::string& path, const std::string& key) {
  return path.empty() ? key : key.empty() ? path : path + "." + key;
}

/// Returns the names of a section: of blocks with their types, of parameters with their values.
std::string content_of(const Fact& section) {
  std::vector<std::string> names;
  for (const Fact& item : section.parts) {
    const Fact* value = item.find("value");
    const std::string more = section.key == "blocks"       ? type_of(item)
                             : section.key == "parameters" ? (value ? value->written : item.written)
                                                           : "";
    names.push_back(unmarked(item.key) + (more.empty() ? "" : " (" + unmarked(more) + ")"));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

/// Comparison of one pair of files.
class Comparer::OfFiles {
 public:
  OfFiles(Comparer& comparer, const FileFacts& before, const FileFacts& after)
      : comparer_(comparer), before_(before), after_(after), old_(before.root) {}

  std::vector<Change> changes() {
    names_ = find_renames(before_.root, after_.root);
    rename(old_, names_);
    follow_parts();
    blocks();
    for (const Fact& part : after_.root.parts)
      if (part.key != "blocks") section(part.key);
    for (const Fact& part : old_.parts)
      if (part.key != "blocks" && !after_.root.find(part.key)) section(part.key);
    orders();
    return std::move(changes_);
  }

  /// Returns the files of parts that both use in one block.
  const std::vector<std::pair<std::string, std::string>>& parts() const { return parts_; }

 private:
  void add(Kind kind, const std::string& section, const std::string& name, const Fact* from, const Fact* to) {
    Change change{.kind = kind, .section = section, .name = unmarked(name)};
    if (from) change.from = from->written, change.before = from->mark;
    if (to) change.to = to->written, change.after = to->mark;
    if (from && to) change.ratio = ratio_of(*from, *to);
    if (from && to && change.from == change.to) name_other_meaning(change, *from, *to);
    if (section == "values") name_default(change, from ? *from : *to);
    changes_.push_back(std::move(change));
  }

  /// Adds the orders that have a meaning and differ.
  void orders() {
    const auto renamed = [&](const std::string& block) {
      const auto found = names_.find({NameKind::block, block});
      return found == names_.end() ? block : found->second;
    };
    const Orders before = orders_of(before_.source->document.root, renamed),
                 after = orders_of(after_.source->document.root);
    for (const ChangedOrder& one : changed_orders(before, after))
      changes_.push_back(
          {.section = "order", .name = "order of " + one.place, .from = one.before, .to = one.after});
  }

  /// Shows canonical texts where two files write a value alike and mean different things.
  static void name_other_meaning(Change& change, const Fact& from, const Fact& to) {
    change.from = unmarked(from.canonical);
    change.to = unmarked(to.canonical);
  }

  /// Shows the default in the place of a value that one file leaves out.
  static void name_default(Change& change, const Fact& fact) {
    if (change.kind != Kind::added && change.kind != Kind::removed) return;
    if (fact.otherwise.empty()) return;
    (change.kind == Kind::added ? change.from : change.to) = fact.otherwise + " (default)";
    change.kind = Kind::changed;
  }

  /// Applies the renames within parts to the file that uses them: keys of their blocks, and "rig.x".
  void follow_parts() {
    const Fact *before = old_.find("blocks"), *after = after_.root.find("blocks");
    if (!before || !after) return;
    const PartsByKey old_blocks(*before);
    NamesInside inside;
    for (const Fact& block : after->parts) {
      const Fact* old_block = old_blocks.find(unmarked(block.key));
      const auto files = old_block ? files_of_part(*old_block, block) : std::nullopt;
      if (files && !compared(*files).names.empty()) inside[block.key] = compared(*files).names;
    }
    if (!inside.empty()) rename_inside(old_, inside);
  }

  /// Two files of one part: names that are other ones, and whether their facts are equal.
  struct ComparedPart {
    NewNames names;
    bool are_equal = false;
  };
  const ComparedPart& compared(const std::pair<std::string, std::string>& files) {
    const auto known = compared_.find(files);
    if (known != compared_.end()) return known->second;
    const Fact before = comparer_.before_.read(files.first).root,
               after = comparer_.after_.read(files.second).root;
    return compared_[files] = {find_renames(before, after), before.canonical == after.canonical};
  }

  void renames(NameKind kind, const char* section) {
    const PartsByKey before(section_of(before_.root, section)), after(section_of(after_.root, section));
    for (const auto& [old_name, new_name] : names_) {
      if (old_name.first != kind) continue;
      Change change{.kind = Kind::renamed, .section = section, .name = old_name.second};
      change.from = old_name.second;
      change.to = new_name;
      if (const Fact* fact = before.find(old_name.second)) change.before = fact->mark;
      if (const Fact* fact = after.find(new_name)) change.after = fact->mark;
      changes_.push_back(std::move(change));
    }
  }

  static const Fact& section_of(const Fact& root, const char* section) {
    static const Fact none{.kind = Fact::Kind::map};
    const Fact* found = root.find(section);
    return found ? *found : none;
  }

  void blocks() {
    const Fact &before = section_of(old_, "blocks"), &after = section_of(after_.root, "blocks");
    const PartsByKey old_blocks(before), new_blocks(after);
    new_blocks_of(before, after, old_blocks, new_blocks);
    gone_blocks_of(before, after, old_blocks, new_blocks);
    renames(NameKind::block, "blocks");
    for (const Fact& block : after.parts)
      if (const Fact* old_block = old_blocks.find(unmarked(block.key))) same_block(*old_block, block);
  }

  void new_blocks_of(const Fact& before, const Fact& after, const PartsByKey& old_blocks,
                     const PartsByKey& new_blocks) {
    std::optional<Homes> homes;
    for (const Fact& block : after.parts) {
      if (old_blocks.find(unmarked(block.key))) continue;
      if (!homes)
        homes = homes_in_parts(before, new_blocks, comparer_.before_texts_, comparer_.before_, before_.file);
      if (const std::string home = take_home(*homes, block); !home.empty()) {
        moved(block, home, unmarked(block.key), nullptr, &block);
        continue;
      }
      add(Kind::added, "blocks", block.key, nullptr, &block);
      content_of_part(block);
    }
  }

  void gone_blocks_of(const Fact& before, const Fact& after, const PartsByKey& old_blocks,
                      const PartsByKey& new_blocks) {
    std::optional<Homes> homes;
    for (const Fact& block : before.parts) {
      if (new_blocks.find(unmarked(block.key))) continue;
      if (!homes)
        homes = homes_in_parts(after, old_blocks, comparer_.after_texts_, comparer_.after_, after_.file);
      if (const std::string home = take_home(*homes, block); !home.empty())
        moved(block, unmarked(block.key), home, &block, nullptr);
      else
        add(Kind::removed, "blocks", block.key, &block, nullptr);
    }
  }

  /// Adds a line for each section of a part that is new: names with types or values.
  void content_of_part(const Fact& block) {
    const Fact* path = block.find("diagram");
    if (!path || block.find("block")) return;
    const std::string file = comparer_.after_texts_.part_path(after_.file, path->canonical);
    if (!comparer_.after_texts_.find(file)) return;
    const Fact root = comparer_.after_.read(file).root;
    for (const char* key : {"blocks", "parameters", "inputs", "outputs"}) {
      const Fact* section = root.find(key);
      if (!section || section->parts.empty()) continue;
      Change change{.kind = Kind::added, .section = "new parts", .name = unmarked(block.key) + "." + key};
      change.to = content_of(*section);
      change.after = block.mark;
      changes_.push_back(std::move(change));
    }
  }

  void moved(const Fact& block, const std::string& from, const std::string& to, const Fact* before,
             const Fact* after) {
    Change change{.kind = Kind::moved, .section = "blocks", .name = unmarked(block.key)};
    change.from = from;
    change.to = to;
    if (before) change.before = before->mark;
    if (after) change.after = after->mark;
    changes_.push_back(std::move(change));
  }

  /// Blocks in parts by their type and values, under the names by which the file has them: "rig.spring".
  using Homes = std::unordered_map<std::string, std::vector<std::string>>;

  /// Takes the place of a block in a part: under its own name, else the first one; "" without any.
  static std::string take_home(Homes& homes, const Fact& block) {
    const auto found = homes.find(content_of_block(block));
    if (found == homes.end() || found->second.empty()) return "";
    const std::string end = "." + unmarked(block.key);
    auto place = std::ranges::find_if(found->second, [&](const auto& one) { return one.ends_with(end); });
    if (place == found->second.end()) place = found->second.begin();
    std::string home = std::move(*place);
    found->second.erase(place);
    return home;
  }

  /// Returns the blocks in the parts of a file that are unknown to the other side.
  static Homes homes_in_parts(const Fact& users, const PartsByKey& others, Texts& texts, FactReader& reader,
                              const std::string& file) {
    Homes homes;
    for (const Fact& user : users.parts) {
      const Fact* path = user.find("diagram");
      if (!path || user.find("block")) continue;
      const Fact* same = others.find(unmarked(user.key));
      if (same && type_of(*same) == type_of(user)) continue;
      const std::string part = texts.part_path(file, path->canonical);
      if (!texts.find(part)) continue;
      const FileFacts inside = reader.read(part);
      for (const Fact& one : section_of(inside.root, "blocks").parts)
        homes[content_of_block(one)].push_back(unmarked(user.key) + "." + unmarked(one.key));
    }
    return homes;
  }

  /// Returns the type and the values of a block, without its wires.
  static std::string content_of_block(const Fact& block) {
    std::set<std::string> values;
    for (const Fact& part : block.parts)
      if (!part.is_wire) values.insert(part.key + ": " + unmarked(part.canonical));
    return fmt::format("{} {{{}}}", type_of(block), fmt::join(values, ", "));
  }

  void same_block(const Fact& before, const Fact& after) {
    const std::string name = unmarked(after.key);
    note_part(before, after);
    is_other_type_ = type_of(before) != type_of(after);
    if (is_part(before) != is_part(after)) other_kind(before, after);
    if (is_other_type_)
      return keys_of_block(name, with_defaults(before, after, comparer_.after_),
                           with_defaults(after, before, comparer_.before_));
    keys_of_block(name, before, after);
  }

  void keys_of_block(const std::string& name, const Fact& before, const Fact& after) {
    for (const Fact& key : after.parts) {
      const Fact* old_key = before.find(unmarked(key.key));
      key_of_block(name, key.key, old_key, &key);
    }
    for (const Fact& key : before.parts)
      if (!after.find(unmarked(key.key))) key_of_block(name, key.key, &key, nullptr);
  }

  /// Returns a block with the values that are defaults of its type, since those of another type differ. Each
  /// value has the default of the other type.
  static Fact with_defaults(Fact block, const Fact& other, const FactReader& reader) {
    block.parts.insert(block.parts.end(), block.defaults.begin(), block.defaults.end());
    for (Fact& part : block.parts) part.otherwise = reader.default_of(other, unmarked(part.key));
    std::erase_if(block.parts, [&](const Fact& part) {
      return part.written == part.otherwise && !other.find(unmarked(part.key));
    });
    return block;
  }

  static bool is_part(const Fact& block) { return !block.find("block"); }

  /// Adds the change of a block into a part or bus, or the other way round.
  void other_kind(const Fact& before, const Fact& after) {
    Change change{.kind = Kind::changed, .section = "blocks", .name = unmarked(after.key)};
    change.from = type_of(before);
    change.to = type_of(after);
    change.before = before.mark;
    change.after = after.mark;
    changes_.push_back(std::move(change));
  }

  void key_of_block(const std::string& block, const std::string& key, const Fact* from, const Fact* to) {
    if (from && to && from->canonical == to->canonical) return;
    const bool is_type = key == "block" || key == "diagram";
    if (is_type && !(from && to)) return;  // a part in the place of a block, see other_kind()
    if (is_type && from && to && has_equal_parts_) return;
    if (is_other_type_ && from && to && from->written == to->written) return;
    const bool is_wire = (from && from->is_wire) || (to && to->is_wire);
    const std::string section = is_type ? "blocks" : is_wire ? "wires" : "values";
    difference(section, is_type ? block : joined(block, unmarked(key)), from, to);
  }

  void note_part(const Fact& before, const Fact& after) {
    has_equal_parts_ = false;
    const auto files = files_of_part(before, after);
    if (!files) return note_unfetched(before, after);
    const auto& [from, to] = *files;
    has_equal_parts_ = compared(*files).are_equal;
    parts_.emplace_back(from, to);  // parts of equal files may differ
  }

  /// Adds a line for a part of two commits of a repository of which one is not fetched.
  void note_unfetched(const Fact& before, const Fact& after) {
    const Fact *old_path = before.find("diagram"), *new_path = after.find("diagram");
    if (!old_path || !new_path) return;
    const auto from = diagram::use_of(before_.source->document.root, old_path->canonical);
    const auto to = diagram::use_of(after_.source->document.root, new_path->canonical);
    if (!from || !to || from->is_version_of(*to)) return;
    changes_.push_back({.section = "parts that are not compared",
                        .name = unmarked(after.key),
                        .from = old_path->written + " at " + from->rev,
                        .to = new_path->written + " at " + to->rev + ", as one of them is not fetched",
                        .before = before.mark,
                        .after = after.mark});
  }

  /// Returns the two files of a part; std::nullopt where one of the blocks is none, or its file is
  /// unreadable.
  std::optional<std::pair<std::string, std::string>> files_of_part(const Fact& before,
                                                                   const Fact& after) const {
    const Fact *old_path = before.find("diagram"), *new_path = after.find("diagram");
    if (!old_path || !new_path || before.find("block") || after.find("block")) return std::nullopt;
    const std::string from = comparer_.before_texts_.part_path(before_.file, old_path->canonical);
    const std::string to = comparer_.after_texts_.part_path(after_.file, new_path->canonical);
    if (!comparer_.before_texts_.find(from) || !comparer_.after_texts_.find(to)) return std::nullopt;
    name_use(before_.source->document.root, old_path->canonical, from);
    name_use(after_.source->document.root, new_path->canonical, to);
    return std::pair(from, to);
  }

  /// Keeps the name under which a file uses the fetched folder of a part.
  void name_use(const yaml::Node& root, const std::string& path, const std::string& part) const {
    const std::string folder = diagram::fetched_root(part);
    const auto use = diagram::use_of(root, path);
    if (use && !folder.empty()) comparer_.uses_.emplace(folder, use->name);
  }

  void section(const std::string& key) {
    const Fact *from = old_.find(key), *to = after_.root.find(key);
    if (key == "parameters") renames(NameKind::parameter, "parameters");
    if (key == "inputs") renames(NameKind::input, "inputs");
    if (key == "outputs") renames(NameKind::output, "outputs");
    if (from && to && from->canonical == to->canonical) return;
    const bool is_scalar = (from ? from : to)->kind == Fact::Kind::value;
    difference(is_scalar ? "head" : key, is_scalar ? key : "", from, to);
  }

  void difference(const std::string& section, const std::string& name, const Fact* from, const Fact* to) {
    if (from && to && from->canonical == to->canonical) return;
    if (from && to && from->kind == to->kind) {
      if (to->kind == Fact::Kind::map) return maps(section, name, *from, *to);
      if (to->kind == Fact::Kind::set) return sets(section, name, *from, *to);
      const bool is_same_length = to->parts.size() == from->parts.size() && to->parts.size() > 1;
      if (to->kind == Fact::Kind::sequence && is_same_length) return sequences(section, name, *from, *to);
    }
    if (!from || !to) {
      const Fact& one = from ? *from : *to;
      if (name.empty() && one.kind != Fact::Kind::value) return items(section, from, to);
    }
    add(!from ? Kind::added : !to ? Kind::removed : Kind::changed, section, name, from, to);
  }

  /// Adds each item of a section that only one file has.
  void items(const std::string& section, const Fact* from, const Fact* to) {
    const Fact& one = from ? *from : *to;
    for (const Fact& part : one.parts)
      add(from ? Kind::removed : Kind::added, section, part.key.empty() ? label_of(part) : part.key,
          from ? &part : nullptr, from ? nullptr : &part);
  }

  void maps(const std::string& section, const std::string& name, const Fact& from, const Fact& to) {
    const Fact *old_plot = from.find("plot"), *new_plot = to.find("plot");
    const bool is_other_plot = old_plot && new_plot && old_plot->canonical != new_plot->canonical;
    const PartsByKey old_parts(from), new_parts(to);
    for (const Fact& part : to.parts) {
      const Fact* old_part = old_parts.find(unmarked(part.key));
      if (is_other_plot && old_part && old_part->written == part.written) continue;  // read in another form
      difference(section, inner_name(section, name, part), old_part, &part);
    }
    for (const Fact& part : from.parts)
      if (!new_parts.find(unmarked(part.key)))
        difference(section, inner_name(section, name, part), &part, nullptr);
  }

  /// Leaves out the key of the value itself: "mass" for "mass.value".
  static std::string inner_name(const std::string& section, const std::string& name, const Fact& part) {
    const bool is_value = (section == "parameters" && part.key == "value") ||
                          (section == "outputs" && part.key == "signal") ||
                          (section == "record" && part.key == "signals");
    return is_value && !name.empty() ? name : joined(name, unmarked(part.key));
  }

  void sets(const std::string& section, const std::string& name, const Fact& from, const Fact& to) {
    const Matches found = matches_of(from, to);
    for (const Fact* one : found.added) add(Kind::added, section, joined(name, label_of(*one)), nullptr, one);
    for (const Fact* one : found.removed)
      add(Kind::removed, section, joined(name, label_of(*one)), one, nullptr);
    for (const auto& [a, b] : found.pairs) difference(section, joined(name, "'" + label_of(*a) + "'"), a, b);
  }

  void sequences(const std::string& section, const std::string& name, const Fact& from, const Fact& to) {
    for (std::size_t i = 0; i < to.parts.size(); ++i)
      difference(section, joined(name, fmt::format("{}", i + 1)), &from.parts[i], &to.parts[i]);
  }

  Comparer& comparer_;
  const FileFacts &before_, &after_;
  Fact old_;  ///< facts of the old file with the new names
  NewNames names_;
  std::vector<Change> changes_;
  std::vector<std::pair<std::string, std::string>> parts_;
  std::map<std::pair<std::string, std::string>, ComparedPart> compared_;
  bool is_other_type_ = false;    ///< the present block has another type
  bool has_equal_parts_ = false;  ///< the parts of the present block have equal facts
};

void Comparer::compare(const std::string& before, const std::string& after, bool parts) {
  if (!done_.emplace(before, after).second) return;
  const FileFacts old_facts = before_.read(before), new_facts = after_.read(after);
  if (parts) check_parts(old_facts, before_texts_), check_parts(new_facts, after_texts_);
  OfFiles files(*this, old_facts, new_facts);
  std::vector<Change> changes = files.changes();
  if (!changes.empty())
    result_.files.push_back({before, after, std::move(changes), fetched_name(before), fetched_name(after)});
  if (parts)
    for (const auto& [from, to] : std::vector(files.parts())) compare(from, to, true);
}

void Comparer::check_parts(const FileFacts& user, Texts& texts) {
  const Fact* blocks = user.root.find("blocks");
  for (std::size_t i = 0; blocks && i < blocks->parts.size(); ++i) {
    const Fact& block = blocks->parts[i];
    const Fact* path = block.find("block") ? nullptr : block.find("diagram");
    const std::string part = path ? texts.part_path(user.file, path->canonical) : "";
    if (part.empty()) continue;  // no part, or one that is not fetched
    try {
      texts.read(part);
    } catch (const yaml::Error& error) {
      faults_.push_back(error.faults().front());
      faults_.back().used_by.push_back({user.file, block.mark});
      if (faults_.back().place.mark.line == 0) faults_.back().message.cure.clear();  // it names a like file
    }
  }
}

const Difference& Comparer::result() const {
  if (!faults_.empty()) throw yaml::Error(faults_);
  return result_;
}

std::string Comparer::fetched_name(const std::string& file) const {
  constexpr std::size_t short_commit = 7;
  const std::string folder = diagram::fetched_root(file);
  const auto use = uses_.find(folder);
  if (use == uses_.end()) return "";
  return fmt::format("{}{} at {}", use->second, file.substr(folder.size()),
                     std::filesystem::path(folder).filename().string().substr(0, short_commit));
}

const char* word_of(Change::Kind kind) {
  static constexpr const char* words[] = {"added", "removed", "renamed", "moved", "changed"};
  return words[static_cast<std::size_t>(kind)];
}

}  // namespace stepwire::difference
