#include "engine/app/simulink/import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/simulink/placeholder.hpp"
#include "engine/app/simulink/plain_text.hpp"
#include "engine/app/simulink/read_model.hpp"
#include "engine/app/simulink/repair.hpp"
#include "engine/app/simulink/unit_text.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::simulink {
namespace {

namespace fs = std::filesystem;

constexpr int max_rounds = 30;  // checks of the written diagram, each after repairs

std::size_t count_blocks(const System& system) {
  std::size_t count = system.blocks.size();
  for (const Block& block : system.blocks)
    if (block.system) count += count_blocks(*block.system);
  return count;
}

/// One import, step by step.
class Importer {
 public:
  Importer(const ImportCall& call, const Registry& registry)
      : registry_(registry), model_(read_model(call.model)), flat_(model_, result_.notes) {
    result_.model = call.model;
    main_ = call.out;
    folder_ = fs::path(call.out).stem().string() + "-parts";
    for (const std::string& note : model_.notes) result_.notes.push_back({NoteKind::differs, "", note});
    result_.blocks = result_.translated = count_blocks(model_.root);
  }

  ImportResult run() {
    Head head = read_head(flat_, result_.notes);
    collected_.step = head.step;
    collected_.widths = &widths_;
    locates_ = head.locates_events;
    name_files();
    for (std::size_t i = 0; i < flat_.blocks().size(); ++i) translate(i);
    record_outports();
    fit_step(head, collected_, result_.notes);
    UnitTexts texts(flat_, head, collected_);
    texts.join_units();
    write_placeholders();
    note_variables();
    note_names();
    settle(texts, head);
    write(texts);
    remove_repeated_notes();
    return std::move(result_);
  }

 private:
  /// Keeps the first of equal sentences; a wire is followed more than once.
  void remove_repeated_notes() {
    std::set<std::tuple<NoteKind, std::string, std::string>> known;
    std::erase_if(result_.notes, [&](const Note& note) {
      return !known.emplace(note.kind, note.block, note.sentence).second;
    });
  }

  std::string free_file(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !files_.insert(lower_case(name)).second; ++i) name = fmt::format("{}_{}", wanted, i);
    return name + ".yaml";
  }

  /// Returns the path of a part as a unit writes it.
  std::string reference(const Unit* user, const std::string& file) const {
    return user && user->parent ? file : folder_ + "/" + file;
  }

  std::string path_of(const std::string& reference) const {
    const std::string file = fs::path(reference).filename().string();
    return (fs::path(main_).parent_path() / folder_ / file).string();
  }

  void name_files() {
    for (auto& unit : flat_.units())
      unit->file =
          unit->parent ? reference(unit->parent, free_file(valid_name(unit->title).substr(0, 100))) : main_;
  }

  void translate(std::size_t index) {
    BlockWriter write(flat_, index, collected_, result_.notes);
    const std::size_t known = result_.notes.size();
    try {
      const Translation* translation = translation_of(model_, write.block());
      if (!translation) throw Untranslated("there is no counterpart");
      translation->write(write);
      write.check_common(locates_);
    } catch (const Untranslated& reason) {
      result_.notes.resize(known);
      write.start_again();
      add_placeholder(write, index, reason.what());
    } catch (const ValueError& reason) {
      result_.notes.resize(known);
      write.start_again();
      add_placeholder(write, index, std::string("a parameter ") + reason.what());
    }
  }

  void add_placeholder(BlockWriter& write, std::size_t index, const std::string& reason) {
    const std::string path = flat_.blocks()[index].path;
    const std::string file = free_file(valid_name(path).substr(0, 100));
    const std::string used = reference(&write.unit(), file);
    use_placeholder(write, used);
    missing_.push_back({index, path_of(used), reason});
    const std::string library = on_one_line(write.text("SourceBlock"));
    result_.notes.push_back(
        {NoteKind::placeholder, path,
         fmt::format("{}{} is not translated: {}; write its blocks in {}", write.block().type,
                     library.empty() ? "" : " " + library, reason, path_of(used))});
    --result_.translated;
  }

  void write_placeholders() {
    const ElementsRead read = elements_read(flat_);
    for (const Missing& one : missing_)
      placeholders_[one.path] = placeholder_text(BlockWriter(flat_, one.index, collected_, result_.notes),
                                                 one.reason, one.index, read);
  }

  void record_outports() {
    Instance& root = flat_.root();
    for (const auto& [port, block] : root.outports) {
      const std::string name = root.unit->take_name(valid_name(block->name));
      if (name != block->name)
        result_.notes.push_back(
            {NoteKind::differs, block->name, fmt::format("is recorded under the name '{}'", name)});
      collected_.recorded.push_back({root.unit, flat_.source(root, *block, "in:1"), name, ""});
    }
    for (Collected::Recorded& one : collected_.recorded)
      if (!one.name.empty() && one.scope.empty())
        one.name = names_.emplace(one.name, one.name).second ? one.name : root.unit->take_name(one.name);
    for (const std::string& name : root.unit->inputs)
      if (!name.empty())
        result_.notes.push_back({NoteKind::differs, name, "is an input of the model, and is 0 in a run"});
  }

  void note_variables() {
    Workspace& workspace = flat_.workspace();
    for (const std::string& name : workspace.with_read(flat_.units()[0]->variables))
      if (workspace.variable(name).value.is_missing)
        result_.notes.push_back(
            {NoteKind::missing, "",
             fmt::format("'{}' has no value in the file; give it one under 'parameters'", name)});
  }

  /// Reports names that differ from those of the model by more than blanks.
  void note_names() {
    for (const FlatBlock& block : flat_.blocks()) {
      if (block.path.empty()) continue;
      std::string plain = block.path;
      std::ranges::replace(plain, '/', '.');
      std::ranges::replace(plain, ' ', '_');
      if (plain != block.name && !block.in->unit->parent)
        result_.notes.push_back({NoteKind::renamed, block.path, fmt::format("is called {}", block.name)});
    }
  }

  /// Checks the diagram as `check` does, and repairs units and loops, as long as that helps.
  void settle(UnitTexts& texts, const Head& head) {
    std::vector<yaml::Fault> faults;
    for (int round = 0; round < max_rounds; ++round) {
      faults = faults_of(texts);
      bool is_changed = false;
      for (const yaml::Fault& fault : faults) is_changed = repair(fault, texts, head) || is_changed;
      if (!is_changed) break;
    }
    for (const yaml::Fault& fault : faults)
      result_.notes.push_back(
          {NoteKind::fault, "", fmt::format("{}: {}", fault.subject, fault.message.text())});
  }

  bool repair(const yaml::Fault& fault, UnitTexts& texts, const Head& head) {
    const std::string text = fault.text();
    if (text.find("lgebraic loop") != text.npos && head.solves_loops && !texts.solves_loops) {
      result_.notes.push_back({NoteKind::differs, "", "has an algebraic loop, which is solved at each step"});
      return texts.solves_loops = true;
    }
    if (fault.subject.starts_with("figure") && texts.has_figure) {
      texts.has_figure = false;
      return true;
    }
    for (auto& unit : flat_.units()) {
      const auto found = checked_.find(file_of(*unit));
      if (found != checked_.end() && same(found->first, fault.place.file) &&
          free_unit(flat_, *unit, found->second, fault))
        return true;
    }
    return false;
  }

  std::string file_of(const Unit& unit) const { return unit.parent ? path_of(unit.file) : main_; }

  static bool same(const std::string& a, const std::string& b) {
    return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
  }

  std::vector<yaml::Fault> faults_of(const UnitTexts& texts) {
    checked_ = placeholders_;
    for (const auto& unit : flat_.units()) checked_[file_of(*unit)] = texts.text(*unit, Purpose::check);
    session::LoadOptions options;
    options.reader = [&](const std::string& path, const yaml::DocumentLimits& limits) {
      for (const auto& [file, text] : checked_)
        if (same(file, path))
          return std::make_shared<const yaml::Document>(yaml::parse_document(text, path, limits));
      return std::make_shared<const yaml::Document>(yaml::read_document(path, limits));
    };
    try {
      session::load_model(registry_, main_, options);
    } catch (const yaml::Error& error) {
      return error.faults();
    }
    return {};
  }

  void write(const UnitTexts& texts) {
    for (const auto& unit : flat_.units()) {
      const std::string file = file_of(*unit);
      io::write_file(file, texts.text(*unit, Purpose::file));
      result_.files.push_back(file);
    }
    for (const auto& [file, text] : placeholders_) {
      io::write_file(file, text);
      result_.files.push_back(file);
    }
  }

  /// A block that is not translated.
  struct Missing {
    std::size_t index;
    std::string path, reason;
  };

  const Registry& registry_;
  std::vector<Missing> missing_;
  ImportResult result_;
  Model model_;
  FlatModel flat_;
  Widths widths_{flat_};
  Collected collected_;
  bool locates_ = false;
  std::string main_, folder_;
  std::set<std::string> files_;
  std::map<std::string, std::string> placeholders_, checked_, names_;
};

}  // namespace

ImportResult import_model(const ImportCall& call, const Registry& registry) {
  return Importer(call, registry).run();
}

std::string translations_markdown() {
  std::string table = "| Simulink | here |\n|---|---|\n";
  for (const Translation& one : translations())
    table += fmt::format("| {} | {} |\n", one.type, one.counterpart);
  return table;
}

}  // namespace stepwire::simulink
