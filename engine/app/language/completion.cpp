#include "engine/app/language/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <optional>
#include <tuple>

#include "engine/app/language/diagram_files.hpp"
#include "engine/app/language/signal_list.hpp"
#include "engine/app/reference/key_words.hpp"
#include "engine/app/reference/sheet_text.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::language {
namespace {

/// Unit as written in files, and the name of its quantity.
struct KnownUnit {
  std::string name, of;
};

/// Returns the most common units in engineering, with their quantities.
const std::vector<KnownUnit>& usual() {
  static const std::vector<KnownUnit> all{{"s", "time"},
                                          {"ms", "time"},
                                          {"us", "time"},
                                          {"min", "time"},
                                          {"m", "length"},
                                          {"mm", "length"},
                                          {"cm", "length"},
                                          {"um", "length"},
                                          {"kg", "mass"},
                                          {"g", "mass"},
                                          {"N", "force"},
                                          {"mN", "force"},
                                          {"kN", "force"},
                                          {"N m", "torque"},
                                          {"N mm", "torque"},
                                          {"J", "energy"},
                                          {"W", "power"},
                                          {"kW", "power"},
                                          {"m/s", "speed"},
                                          {"mm/s", "speed"},
                                          {"m/s^2", "acceleration"},
                                          {"rad", "angle"},
                                          {"deg", "angle"},
                                          {"rad/s", "angular speed"},
                                          {"deg/s", "angular speed"},
                                          {"Hz", "frequency"},
                                          {"kHz", "frequency"},
                                          {"N/m", "stiffness"},
                                          {"N/mm", "stiffness"},
                                          {"N s/m", "damping"},
                                          {"N/s", "rate of a force"},
                                          {"N m/rad", "torsional stiffness"},
                                          {"A", "current"},
                                          {"mA", "current"},
                                          {"V", "voltage"},
                                          {"mV", "voltage"},
                                          {"ohm", "resistance"},
                                          {"kohm", "resistance"},
                                          {"H", "inductance"},
                                          {"mH", "inductance"},
                                          {"F", "capacitance"},
                                          {"uF", "capacitance"},
                                          {"T", "flux density"},
                                          {"Wb", "magnetic flux"},
                                          {"Pa", "pressure"},
                                          {"kPa", "pressure"},
                                          {"bar", "pressure"},
                                          {"K", "temperature"},
                                          {"degC", "temperature"},
                                          {"%", "ratio"},
                                          {"kg m^2", "moment of inertia"},
                                          {"m^2", "area"},
                                          {"m^3", "volume"},
                                          {"m^3/s", "flow"},
                                          {"kg/m^3", "density"},
                                          {"V s/rad", "motor constant"}};
  return all;
}

/// Returns common units of a dimension, or of all if it is unknown. The SI unit is always included for a
/// known dimension.
std::vector<KnownUnit> units_of(const std::optional<unit::Dimension>& dimension) {
  if (!dimension) return usual();
  std::vector<KnownUnit> fitting;
  for (const KnownUnit& unit : usual())
    if (const auto parsed = unit::parse_unit(unit.name); parsed && parsed->dimension == *dimension)
      fitting.push_back(unit);
  const std::string si = unit::si_name(*dimension);
  if (*dimension != unit::Dimension{} && std::ranges::find(fitting, si, &KnownUnit::name) == fitting.end())
    fitting.push_back({si, "SI"});
  return fitting;
}

/// Diagram file that can be used as a part.
struct PartFile {
  std::string path;  ///< relative to the folder of the using file
  std::string title;
};

/// Returns the value in the line of a top-level key, without parsing the file.
std::string line_of(std::string_view text, const std::string& key) {
  const std::size_t at = text.starts_with(key) ? 0 : text.find("\n" + key);
  if (at == std::string_view::npos) return "";
  const std::size_t begin = at + key.size() + (text[at] == '\n' ? 1 : 0);
  const std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string_view::npos ? " " : std::string(line.substr(first));
}

/// Returns the files with outputs among all known files, except the user itself.
std::vector<PartFile> part_files(DiagramFiles& files, const std::string& user) {
  std::vector<PartFile> parts;
  const auto folder = std::filesystem::path(user).parent_path();
  for (const std::string& file : files.paths()) {
    if (file == user) continue;
    const auto text = files.texts().text(file);
    if (line_of(*text, "stepwire:").empty() || line_of(*text, "outputs:").empty()) continue;
    parts.push_back(
        {std::filesystem::path(file).lexically_relative(folder).string(), line_of(*text, "title:")});
  }
  return parts;
}

/// Context of the cursor in a text that need not be valid YAML.
struct WritingPlace {
  /// Document of the text with a name inserted at the cursor; it owns `map`.
  std::shared_ptr<const yaml::Document> document;
  FormList keys;                    ///< Maps of which a key is possible here; may be empty.
  FormList values;                  ///< Possible forms of the value.
  const yaml::Node* map = nullptr;  ///< Map that contains the key or value; nullptr if none.
  std::string key;                  ///< Key of the value.
  std::string block;                ///< Name of the enclosing block.
  std::string before;               ///< Text of the scalar before the cursor.
  TextRange word;                   ///< Name around the cursor, with its dots.
  TextRange scalar;                 ///< Whole scalar without quotes.
};

/// Improbable name, inserted at the cursor before parsing.
constexpr std::string_view probe = "zzcursorzz";

bool is_in_name(char c) {
  return is_name_character(c) || c == '.';
}

/// Returns the closing brackets for those that are open at the end of a text.
std::string closing_brackets(std::string_view text) {
  std::string open;
  char before = '\n', quote = 0;  // last nonblank character; quote character of the current string, or 0
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const bool starts_value = std::string_view("\n:,[{-").find(before) != std::string_view::npos;
    if (quote) {
      if (c == '\\' && quote == '"') ++at;
      if (c == quote) quote = 0;
    } else if ((c == '"' || c == '\'') && starts_value) {
      quote = c;
    } else if (c == '#' && (at == 0 || std::isspace(static_cast<unsigned char>(text[at - 1])))) {
      at = std::min(text.find('\n', at), text.size()) - 1;
    } else if ((c == '[' || c == '{') && (starts_value || !open.empty())) {
      open += c == '[' ? ']' : '}';
    } else if (!open.empty() && c == open.back()) {
      open.pop_back();
    }
    if (c == '\n' || !std::isspace(static_cast<unsigned char>(c))) before = c;
  }
  return {open.rbegin(), open.rend()};
}

/// Returns trial texts with a name at the cursor, one of which may be valid YAML. They are unchanged, with
/// the name as a key, with brackets closed at the end of the line, and without the text that follows.
std::vector<std::string> probed_texts(std::string_view text, std::size_t offset) {
  const std::string start = std::string(text.substr(0, offset)) + std::string(probe);
  const std::size_t line = std::min(text.find('\n', offset), text.size());
  const std::string rest(text.substr(offset, line - offset)), below(text.substr(line));
  const std::string close = closing_brackets(text.substr(0, offset)),
                    close_line = closing_brackets(text.substr(0, line));
  return {start + rest + below,  start + ": " + rest + below,   start + rest + close_line + below,
          start + close + below, start + ": x" + close + below, start + "\"" + close + below,
          start + close + "\n",  start + ": x" + close + "\n"};
}

class Search {
 public:
  Search(Forms& forms, WritingPlace& cursor) : forms_(forms), cursor_(cursor) {}

  bool find(const yaml::Node& node, const FormList& forms) {
    if (node.is_scalar()) return in_scalar(node, forms);
    for (const yaml::Node& item : node.items)
      if (find(item, forms_.items(forms))) return true;
    for (const yaml::Entry& entry : node.entries)
      if (in_entry(node, entry, forms)) return true;
    return false;
  }

 private:
  bool in_scalar(const yaml::Node& node, const FormList& forms) {
    const std::size_t at = node.text.find(probe);
    if (at == std::string::npos) return false;
    cursor_.before = node.text.substr(0, at);
    cursor_.values = forms_.scalars(forms);
    static const yaml::Node nothing;  // the name may be the first key of a map
    if (!node.quoted && node.text == probe) cursor_.keys = forms_.maps(forms, nothing);
    return true;
  }

  bool in_entry(const yaml::Node& map, const yaml::Entry& entry, const FormList& forms) {
    const bool is_key = entry.key.find(probe) != std::string::npos;
    const FormList below = is_key ? FormList{} : forms_.under(forms, map, entry.key);
    const bool is_block =
        std::ranges::any_of(below, [](const yaml::Key* form) { return is_block_form(*form); });
    const std::string outer = cursor_.block;
    if (is_block) cursor_.block = entry.key;
    if (is_key) {
      cursor_.before = entry.key.substr(0, entry.key.find(probe));
      cursor_.keys = forms_.maps(forms, map);
    } else if (!find(entry.value, below)) {
      cursor_.block = outer;
      return false;
    }
    if (!cursor_.map) {
      cursor_.map = &map;
      cursor_.key = is_key ? "" : entry.key;
    }
    return true;
  }

  Forms& forms_;
  WritingPlace& cursor_;
};

TextRange word_around(std::string_view text, std::size_t offset) {
  TextRange word{offset, offset};
  while (word.from > 0 && is_in_name(text[word.from - 1])) --word.from;
  while (word.to < text.size() && is_in_name(text[word.to])) ++word.to;
  return word;
}

/// Returns the context of an offset; std::nullopt if no trial text is valid YAML.
/// Problem: the text around a cursor is seldom valid YAML. Idea: a probe name is inserted at the cursor, and
/// several trial texts are parsed, for example with the open brackets closed. The probe is found in the first
/// valid tree, and its ancestors determine the possible forms. Cost: at most eight parses.
std::optional<WritingPlace> writing_place(DiagramFiles& files, const std::string& file, std::size_t offset) {
  const auto text = files.texts().text(file);
  for (const std::string& probed : probed_texts(*text, std::min(offset, text->size()))) {
    try {
      WritingPlace cursor;
      cursor.document = std::make_shared<const yaml::Document>(yaml::parse_document(probed, file));
      Forms& forms = files.forms(file);
      if (!Search(forms, cursor).find(cursor.document->root, forms.root())) continue;
      cursor.word = word_around(*text, offset);
      cursor.scalar = {offset - std::min(offset, cursor.before.size()), cursor.word.to};
      return cursor;
    } catch (const yaml::Error&) {  // another trial text may be valid
    }
  }
  return std::nullopt;
}

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
