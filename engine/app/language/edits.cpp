#include "engine/app/language/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "engine/app/language/block_edits.hpp"
#include "engine/app/language/known_faults.hpp"
#include "engine/app/language/section_edits.hpp"
#include "engine/app/language/tree_edits.hpp"
#include "engine/app/language/tree_place.hpp"
#include "engine/app/language/wire_edits.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::language {

namespace {

std::optional<std::size_t> index_in(const std::string& text, std::size_t count) {
  std::size_t index = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), index);
  const bool is_whole = wrong == std::errc() && end == text.data() + text.size();
  return is_whole && index >= 1 && index <= count ? std::optional(index - 1) : std::nullopt;
}

/// Returns the value under "gain" or "gain.2" of a map; nullptr if there is no such key.
const yaml::Node* value_under(const yaml::Node& map, const std::string& name) {
  if (const yaml::Node* value = map.find(name)) return value;
  const std::size_t dot = name.rfind('.');
  const yaml::Node* list = dot == std::string::npos ? nullptr : value_under(map, name.substr(0, dot));
  const auto index = list ? index_in(name.substr(dot + 1), list->items.size()) : std::nullopt;
  return index ? &list->items[*index] : nullptr;
}

[[noreturn]] void refuse_name(const std::string& name) {
  throw EditRefused(fmt::format("this file has no '{}'", text::visible(name)));
}

/// Replaces the value of a name, or adds the key to its block.
void set_value(TreeEdits& edits, const yaml::Document& document, const SetValue& set) {
  if (const yaml::Entry* block = DiagramFiles::block_at_start(document, set.name);
      block && set.name.size() > block->key.size()) {
    const std::string key = set.name.substr(block->key.size() + 1);
    if (const yaml::Node* value = value_under(block->value, key)) return edits.replace(*value, set.text);
    if (key.find('.') != std::string::npos)
      throw EditRefused(fmt::format("'{}' has no '{}' in this file", block->key, text::visible(key)));
    return edits.add(block->value, key, set.text);
  }
  const yaml::Entry* parameter = DiagramFiles::entry(document, "parameters", set.name);
  if (parameter && parameter->value.is_map()) {
    const yaml::Node* value = parameter->value.find("value");
    return value ? edits.replace(*value, set.text) : edits.add(parameter->value, "value", set.text);
  }
  if (parameter) return edits.replace(parameter->value, set.text);
  const yaml::Node* head = document.root.find(set.name);
  if (!head || !head->is_scalar()) refuse_name(set.name);
  edits.replace(*head, set.text);
}

void set_value_at(TreeEdits& edits, const TreePlace& place, const SetValueAt& set) {
  if (!place.scalar) throw EditRefused("no value stands here");
  edits.replace(*place.scalar, set.text);
}

/// Returns the position of a name's definition.
std::size_t place_of_definition(DiagramFiles& files, const std::string& file, const std::string& name) {
  using Kind = Meaning::Kind;
  for (const Kind kind : {Kind::block, Kind::parameter, Kind::input, Kind::output})
    if (const auto place = files.definition({file, kind, name})) return place->range.from;
  refuse_name(name);
}

/// Throws a fault as EditRefused, without its place, which is in a trial text.
[[noreturn]] void refuse_for(const yaml::Fault& fault) {
  const std::string words = fault.message.text();
  throw EditRefused(text::visible(fault.subject.empty() ? words : fault.subject + ": " + words));
}

/// Visitor that computes the splices of an edit.
class Editor {
 public:
  Editor(DiagramFiles& files, const std::string& file)
      : files_(files), file_(file), document_(read()), text_(files.texts().text(file)) {}

  Edited operator()(const SetValue& set) {
    TreeEdits edits(*text_, *document_);
    set_value(edits, *document_, set);
    return done(edits);
  }
  Edited operator()(const SetValueAt& set) {
    const auto place = tree_place(files_, file_, set.offset);
    if (!place) throw EditRefused("no value stands here");
    TreeEdits edits(*text_, *place->document);
    set_value_at(edits, *place, set);
    return done(edits);
  }
  Edited operator()(const Rename& edit) {
    Edited result;
    result.changes = rename(files_, file_, place_of_definition(files_, file_, edit.name), edit.to);
    return result;
  }
  Edited operator()(const Connect& edit) {
    TreeEdits edits(*text_, *document_);
    connect(edits, files_, file_, *document_, edit);
    check_units(files_, analyse(files_, file_, Depth::draft), file_, edit);
    Edited result = done(edits);
    if (!result.faults.empty()) refuse_for(result.faults.front());
    return result;
  }
  Edited operator()(const Disconnect& edit) {
    TreeEdits edits(*text_, *document_);
    disconnect(edits, *document_, edit);
    return done(edits);
  }
  Edited operator()(const Remove& edit) {
    TreeEdits edits(*text_, *document_);
    remove(edits, files_, file_, *document_, edit);
    return done(edits);
  }
  Edited operator()(const Insert& edit) {
    TreeEdits edits(*text_, *document_);
    const std::string name = insert(edits, files_, file_, *document_, edit);
    Edited result = done(edits);
    result.name = name;
    if (!edit.inputs.empty()) refuse_wires(result.faults, (*this)(Insert{edit.type, edit.name}).faults);
    return result;
  }
  Edited operator()(const AddItem& edit) {
    TreeEdits edits(*text_, *document_);
    edits.add_below(document_->root, edit.section, "", edit.text);
    return done(edits);
  }
  Edited operator()(const CutLoop& edit) {
    TreeEdits edits(*text_, *document_);
    const std::string name = cut_loop(edits, *document_, edit);
    Edited result = done(edits);
    result.name = name;
    return result;
  }

 private:
  std::shared_ptr<const yaml::Document> read() {
    try {
      return files_.texts().document(file_);
    } catch (const yaml::Error& error) {
      throw EditRefused(std::string("mend the file first: ") + error.what());
    }
  }

  Edited done(const TreeEdits& edits) {
    Edited result;
    result.changes[file_] = edits.checked();
    result.faults = KnownFaults(files_, file_).added_by(result.changes);
    return result;
  }

  /// Throws if the wires of an inserted block cause a fault. Faults of the block alone are allowed, since it
  /// may be incomplete.
  static void refuse_wires(const std::vector<yaml::Fault>& with, const std::vector<yaml::Fault>& without) {
    for (const yaml::Fault& fault : with) {
      const bool is_of_block = std::ranges::any_of(without, [&](const yaml::Fault& one) {
        return one.subject == fault.subject && one.message.text() == fault.message.text();
      });
      if (!is_of_block) refuse_for(fault);
    }
  }

  DiagramFiles& files_;
  const std::string& file_;
  std::shared_ptr<const yaml::Document> document_;
  std::shared_ptr<const std::string> text_;
};

}  // namespace

Edited edited(DiagramFiles& files, const std::string& file, const Edit& edit) {
  return std::visit(Editor(files, file), edit);
}

}  // namespace stepwire::language
