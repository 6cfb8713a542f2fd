#include "engine/app/language/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "engine/app/language/part_files.hpp"
#include "engine/app/language/signal_list.hpp"
#include "engine/app/language/unit_list.hpp"
#include "engine/app/reference/key_words.hpp"
#include "engine/app/reference/sheet_text.hpp"
#include "engine/app/reference/words.hpp"

namespace stepwire::language {

namespace {

using Form = yaml::Key::Form;
using CompletionKind = Completion::Kind;

std::string detail_of(const yaml::Key& key) {
  std::string text = reference::form_text(key.form == Form::section ? yaml::Key{.form = Form::tree} : key);
  if (key.form == Form::section) text = key.refers;
  if (!key.unit.empty()) text += fmt::format(" [{}]", key.unit);
  if (key.required) return text + ", required";
  return key.otherwise.empty() ? text : fmt::format("{}, default {}", text, key.otherwise);
}

class Completing {
 public:
  Completing(DiagramFiles& files, const Analysis& analysis, const std::string& file, WritingPlace cursor)
      : files_(files), analysis_(analysis), file_(file), cursor_(std::move(cursor)) {}

  std::vector<Completion> all() {
    for (const yaml::Key* form : cursor_.keys) keys(*form);
    for (const yaml::Key* form : cursor_.values) value(*form);
    const auto order = [](const Completion& one) { return std::tuple(one.rank, one.label); };
    std::ranges::stable_sort(found_, {}, order);
    const auto same = [](const Completion& a, const Completion& b) {
      return a.label == b.label && a.kind == b.kind;
    };
    found_.erase(std::unique(found_.begin(), found_.end(), same), found_.end());
    return std::move(found_);
  }

 private:
  void add(std::string label, CompletionKind kind, std::string detail, std::string doc, int rank = 0) {
    std::string text = label;
    found_.push_back(
        {std::move(label), kind, std::move(text), cursor_.word, std::move(detail), std::move(doc), rank});
  }

  void keys(const yaml::Key& form) {
    if (form.form == Form::names) return names(form.names);
    for (const yaml::Key& key : form.of) {
      if (key.name.empty() || (cursor_.map && cursor_.map->find(key.name))) continue;
      add(key.name, CompletionKind::key, detail_of(key), reference::escaped(key.doc),
          key.required || !key.choice.empty() ? 0 : 1);
      found_.back().text += ": ";
    }
    for (const yaml::Key& key : form.rest) names(key.names);
  }

  void value(const yaml::Key& form) {
    if (cursor_.key == "block" && !cursor_.block.empty()) return types();
    if (cursor_.key == "diagram" && !cursor_.block.empty()) return files();
    if (const std::string number = number_before(); !number.empty()) return units(wanted_unit(form));
    if (cursor_.before.starts_with('=')) return parameters(std::nullopt, "");
    words(form);
    names(form.names);
    if (form.form == Form::source) wires(form);
    if (form.form == Form::expression || form.form == Form::series) recorded(form);
    const bool takes_number = form.form == Form::number || form.form == Form::value ||
                              form.form == Form::source || form.form == Form::computed ||
                              form.form == Form::whole;
    if (takes_number || dollar()) parameters(wanted_unit(form), "$");
  }

  bool dollar() const {
    const auto text = files_.texts().text(file_);
    return cursor_.word.from > 0 && (*text)[cursor_.word.from - 1] == '$';
  }

  /// Returns a number that is followed by a blank and lacks a unit, or the text of a drawn expression that
  /// ends in " in".
  std::string number_before() const {
    const std::string& text = cursor_.before;
    const std::size_t space = text.rfind(' ');
    if (space == std::string::npos) return "";
    if (text.substr(0, space).ends_with(" in")) return text;
    const std::size_t begin = text.find_last_of(" ,[(+-*/", space == 0 ? 0 : space - 1);
    const std::string last = text.substr(begin == std::string::npos ? 0 : begin + 1, space - (begin + 1));
    return unit::parse_quantity(last) && !unit::parse_quantity(last)->dimension ? last : "";
  }

  void words(const yaml::Key& form) {
    for (const yaml::Key::Word& word : form.words)
      add(word.word, CompletionKind::word, "", reference::escaped(word.doc));
  }

  void types() {
    for (const BlockType* type : files_.registry().types())
      add(type->name, CompletionKind::type, type->folder, reference::escaped(type->doc));
  }

  void files() {
    for (const PartFile& part : part_files(files_, file_)) {
      add(part.path, CompletionKind::file, part.title, "");
      found_.back().range = cursor_.scalar;
    }
  }

  void names(yaml::Key::Names what) {
    if (what == yaml::Key::Names::signal && !is_source())
      signals(signals_of(analysis_, files_, file_, true), {});
    if (what == yaml::Key::Names::block) blocks();
    if (what == yaml::Key::Names::parameter) all_parameters();
    if (what == yaml::Key::Names::unit) units(std::nullopt);
  }

  bool is_source() const {
    return std::ranges::any_of(cursor_.values,
                               [](const yaml::Key* form) { return form->form == Form::source; });
  }

  void wires(const yaml::Key& form) {
    signals(signals_of(analysis_, files_, file_, false), wanted_unit(form));
  }

  void recorded(const yaml::Key& form) {
    const bool stop = cursor_.key == "stop_when";
    signals(stop ? signals_of(analysis_, files_, file_, true) : recorded_of(analysis_),
            stop ? std::nullopt : wanted_unit(form));
  }

  void signals(const std::vector<KnownSignal>& known, const std::optional<unit::Dimension>& wanted) {
    for (const KnownSignal& signal : known) {
      const std::string unit = signal.dimension ? unit::si_name(*signal.dimension) : "unit not known";
      add(signal.name, CompletionKind::signal, fmt::format("{}, {}", signal.what, unit), "",
          rank(signal.dimension, wanted));
    }
  }

  /// Ranks a signal: fitting units first, then unknown ones, then others.
  static int rank(const std::optional<unit::Dimension>& has, const std::optional<unit::Dimension>& wanted) {
    if (!has || !wanted) return 1;
    return *has == *wanted ? 0 : 2;
  }

  /// Returns the unit of the value at the cursor; std::nullopt if unknown.
  std::optional<unit::Dimension> wanted_unit(const yaml::Key& form) const {
    if (!cursor_.block.empty())
      if (const auto inferred = unit_of_input(analysis_, cursor_.block, cursor_.key)) return inferred;
    const yaml::Key* key = &form;
    for (const yaml::Key* map : maps_around())
      if (const yaml::Key* found = map->find(cursor_.key)) key = found;
    const auto unit = key->unit.empty() ? std::nullopt : unit::parse_unit(key->unit);
    return unit ? std::optional(unit->dimension) : std::nullopt;
  }

  FormList maps_around() const {
    if (cursor_.block.empty() || !cursor_.map) return {};
    Forms& forms = files_.forms(file_);
    const yaml::Key& head = *forms.root().front();
    return forms.maps({&head.find("blocks")->of.front()}, *cursor_.map);
  }

  void parameters(const std::optional<unit::Dimension>& wanted, const std::string& sign) {
    const auto tree = files_.tree(file_);
    const yaml::Node* all = tree ? tree->root.find("parameters") : nullptr;
    for (std::size_t i = 0; all && i < all->entries.size(); ++i) {
      const std::string& name = all->entries[i].key;
      const diagram::DiagramParameter* known = parameter_of(analysis_, name);
      add((dollar() ? "" : sign) + name, CompletionKind::parameter, known ? known->text : "",
          known ? reference::escaped(known->doc) : "", rank(known ? known->dimension : std::nullopt, wanted));
    }
  }

  void all_parameters() {
    if (!analysis_.draft) return;
    for (const diagram::DiagramParameter& one : analysis_.draft->diagram.parameters)
      if (one.name.starts_with(analysis_.prefix)) {
        add(one.name.substr(analysis_.prefix.size()), CompletionKind::parameter, one.text,
            reference::escaped(one.doc));
        if (!cursor_.keys.empty()) found_.back().text += ": ";
      }
  }

  void blocks() {
    const auto tree = files_.tree(file_);
    const yaml::Node* all = tree ? tree->root.find("blocks") : nullptr;
    for (std::size_t i = 0; all && i < all->entries.size(); ++i)
      add(all->entries[i].key, CompletionKind::signal, "block", "");
  }

  void units(const std::optional<unit::Dimension>& wanted) {
    for (const KnownUnit& unit : units_of(wanted)) {
      add(unit.name, CompletionKind::unit, unit.of, "");
      found_.back().range = unit_range();
    }
  }

  /// Returns the text after the last blank, because a unit such as N*m/s is more than a name.
  TextRange unit_range() const {
    const std::size_t blank = cursor_.before.rfind(' ');
    const std::size_t length =
        blank == std::string::npos ? cursor_.before.size() : cursor_.before.size() - blank - 1;
    const std::size_t at = cursor_.scalar.from + cursor_.before.size();
    return {at - std::min(length, at), cursor_.word.to};
  }

  DiagramFiles& files_;
  const Analysis& analysis_;
  const std::string& file_;
  const WritingPlace cursor_;
  std::vector<Completion> found_;
};

}  // namespace

std::vector<Completion> complete(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                                 std::size_t offset) {
  auto cursor = writing_place(files, file, offset);
  if (!cursor) return {};
  return Completing(files, analysis, file, std::move(*cursor)).all();
}

}  // namespace stepwire::language
