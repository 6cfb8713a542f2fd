#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace stepwire::yaml {

/// Description of a key of the file format, one row of a table. The reader, the schema and the reference page
/// are made from it. Without a name it describes the items of a list or the values of arbitrary names.
struct Key {
  /// Form of the value.
  enum class Form {
    text,        ///< Any scalar; a number or true counts as text.
    string,      ///< A name or a path.
    truth,       ///< The word true or false.
    word,        ///< One of `words`.
    whole,       ///< A whole number from `least` to `most`.
    number,      ///< A number in `unit` or a bare one, from `least` to `most`; `$name` or `= expression`.
    computed,    ///< Such a number, or an expression of numbers and `$name`.
    expression,  ///< An expression of recorded columns.
    series,      ///< An expression of recorded columns in a unit, optionally with a label.
    source,      ///< The source of a port.
    value,       ///< A number with its unit, a list, a word, a truth value or `= expression`.
    nothing,     ///< No value, the key alone.
    list,        ///< A list of `least` to `most` items.
    names,       ///< A map of at least `least` arbitrary names that match `pattern`.
    keys,        ///< A map of the keys in `of`.
    either,      ///< One of the forms in `of`.
    section,     ///< The section or definition that `refers` names.
    tree         ///< A value that only the explanation describes.
  };
  struct Word {
    std::string word, doc{};
  };
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::string name{};
  std::string doc{};  ///< explanation, one sentence
  Form form = Form::text;
  std::vector<Key> of{};    ///< Keys of a map; form of an item of a list or of names; alternatives.
  std::vector<Key> rest{};  ///< Of a map: the form of any other name; empty if no other name is allowed.
  std::vector<Word> words{};
  double least = -unlimited, most = unlimited;
  bool above = false;     ///< Excludes `least` itself.
  std::string unit{};     ///< Unit, "s"; empty for a pure number or any unit.
  std::string pattern{};  ///< Pattern of names; empty for any.
  std::string refers{};   ///< Name of a section or definition.
  /// Kind of names that its texts refer to, or its keys for a map of names.
  enum class Names { nothing, signal, block, parameter, unit } names = Names::nothing;
  std::string noun{};       ///< of a map, for messages: "a claim"
  std::string example{};    ///< of its value, or of a section
  std::string otherwise{};  ///< the default, for documentation
  bool required = false;
  std::string choice{};               ///< a map has exactly one key of such a group: "reduction"
  std::vector<std::string> beside{};  ///< it is allowed only with one of these keys

  /// Returns the key of a map; nullptr if it is missing.
  const Key* find(const std::string& key) const;
};

/// Return the allowed words of a key, and the names of the keys of a map.
std::vector<std::string> words_of(const Key& key);
std::vector<std::string> names_of(const std::vector<Key>& keys);

/// Factory functions of forms.
struct form {
  using Form = Key::Form;

  static Key of(Form form) { return {.form = form}; }
  static Key text() { return of(Form::text); }
  static Key string() { return of(Form::string); }
  static Key expression() { return of(Form::expression); }
  static Key series() { return of(Form::series); }
  static Key signal() { return naming(Key::Names::signal, text()); }
  static Key block() { return naming(Key::Names::block, text()); }
  static Key parameter() { return naming(Key::Names::parameter, string()); }
  static Key unit() { return naming(Key::Names::unit, text()); }
  static Key tree() { return of(Form::tree); }
  static Key truth() { return {.form = Form::truth, .words = {{"false"}, {"true"}}}; }
  static Key words(std::vector<Key::Word> words) { return {.form = Form::word, .words = std::move(words)}; }
  static Key word(std::vector<std::string> words);
  static Key whole(double least, double most = Key::unlimited) {
    return {.form = Form::whole, .least = least, .most = most};
  }
  static Key number(std::string unit = "") { return {.form = Form::number, .unit = std::move(unit)}; }
  static Key computed(std::string unit = "") { return {.form = Form::computed, .unit = std::move(unit)}; }
  static Key above_zero(Key number);
  static Key list(Key item, double least = 0, double most = Key::unlimited) {
    return {.form = Form::list, .of = {std::move(item)}, .least = least, .most = most};
  }
  static Key pair(Key item) { return list(std::move(item), 2, 2); }
  static Key either(std::vector<Key> forms) { return {.form = Form::either, .of = std::move(forms)}; }
  static Key one_or_list(const Key& item) { return either({item, list(item, 1)}); }
  static Key names(Key item, double least = 0, std::string pattern = "") {
    return {.form = Form::names, .of = {std::move(item)}, .least = least, .pattern = std::move(pattern)};
  }
  static Key keys(std::string noun, std::string example, std::vector<Key> keys) {
    return {
        .form = Form::keys, .of = std::move(keys), .noun = std::move(noun), .example = std::move(example)};
  }
  /// Returns a form whose texts, or keys for a map, name elements of the diagram.
  static Key naming(Key::Names what, Key form) {
    form.names = what;
    return form;
  }
  static Key section(std::string name) { return {.form = Form::section, .refers = std::move(name)}; }
};

/// Return an existing key with a further property.
template <class AnyKey>
AnyKey needed(AnyKey key) {
  key.required = true;
  key.otherwise.clear();
  return key;
}
template <class AnyKey>
AnyKey one_of(std::string choice, AnyKey key) {
  key.choice = std::move(choice);
  return key;
}
template <class AnyKey>
AnyKey beside(std::vector<std::string> keys, AnyKey key) {
  key.beside = std::move(keys);
  return key;
}
template <class AnyKey>
AnyKey otherwise(std::string text, AnyKey key) {
  key.otherwise = std::move(text);
  return key;
}

/// Returns a form with a name and an explanation.
Key key(std::string name, std::string doc, Key form = {});
/// Returns a form with an example of its value.
Key like(std::string example, Key form);

}  // namespace stepwire::yaml
