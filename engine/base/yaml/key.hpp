#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace stepwire::yaml {

/// A key of a file as a row of a table: its reader, the schema and the reference page come from it. Without a
/// name it is what stands in a list, or behind any name.
struct Key {
  /// What stands behind it.
  enum class Form {
    text,        ///< a number or true is text, too
    string,      ///< a name, or a path
    truth,       ///< true or false
    word,        ///< one of `words`
    whole,       ///< a whole number from `least` to `most`
    number,      ///< in `unit` or a bare one, from `least` to `most`; `$name` or `= expression`
    computed,    ///< the same, or an expression of numbers and `$name`
    expression,  ///< of what was recorded
    series,      ///< the same in a unit, perhaps with a label
    source,      ///< what feeds a port
    value,       ///< a number with its unit, a list, a word, truth or `= expression`
    nothing,     ///< the key alone
    list,        ///< of `least` to `most` items
    names,       ///< map of any names, at least `least`, that are as `pattern` has them
    keys,        ///< map of the keys in `of`
    either,      ///< one of the forms in `of`
    section,     ///< what the section or definition `refers` describes
    tree         ///< what only the explanation describes
  };
  struct Word {
    std::string word, doc{};
  };
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::string name{};
  std::string doc{};  ///< what it is, in a sentence
  Form form = Form::text;
  std::vector<Key> of{};    ///< keys of a map; the item of a list or of names; forms to choose from
  std::vector<Key> rest{};  ///< of a map: the form under any other name; empty: there is none
  std::vector<Word> words{};
  double least = -unlimited, most = unlimited;
  bool above = false;     ///< `least` itself is not allowed
  std::string unit{};     ///< "s"; empty: a pure number, or any unit
  std::string pattern{};  ///< of names; empty: any
  std::string refers{};   ///< name of a section or definition
  /// What its texts name, or its keys where it is a map of names: nothing, or what the diagram has.
  enum class Names { nothing, signal, block, parameter, unit } names = Names::nothing;
  std::string noun{};       ///< of a map, for messages: "a claim"
  std::string example{};    ///< of its value, or of a section
  std::string otherwise{};  ///< what counts where the file does not have it
  bool required = false;
  std::string choice{};               ///< exactly one key of the same choice stands in a map: "reduction"
  std::vector<std::string> beside{};  ///< it stands beside one of these keys only

  /// The key of a map, or nullptr.
  const Key* find(const std::string& key) const;
};

/// The words that may stand there, or the names of the keys of a map.
std::vector<std::string> words_of(const Key& key);
std::vector<std::string> names_of(const std::vector<Key>& keys);

/// Forms of values, from which keys are made.
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
  /// A form whose texts name something of the diagram; of a map its keys.
  static Key naming(Key::Names what, Key form) {
    form.names = what;
    return form;
  }
  static Key section(std::string name) { return {.form = Form::section, .refers = std::move(name)}; }
};

/// A key that is there, with more said of it.
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

/// A form with a name and an explanation.
Key key(std::string name, std::string doc, Key form = {});
/// A form with what its value looks like.
Key like(std::string example, Key form);

}  // namespace stepwire::yaml
