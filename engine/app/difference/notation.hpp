#pragma once

#include <optional>

#include "engine/app/language/written_names.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/block/spec.hpp"

namespace stepwire::difference {

// Short and long notations of one value, from the forms of its key.

/// Returns the list form where a value may be an item or a list of such items; nullptr otherwise.
const yaml::Key* one_or_list(const language::FormList& forms);

/// True for a list of sections (claims, figures) or recorded signals, whose order has no meaning.
bool is_set(const yaml::Key& list);

/// Section that may be written as the value of its only required key: `mass: 2 kg` for {value: 2 kg}.
struct ShortSection {
  const yaml::Key* required = nullptr;  ///< Nullptr for `name:` without a value.
  const yaml::Key* value = nullptr;     ///< Form of the short value, if the key has none.
};
std::optional<ShortSection> short_section(const language::FormList& forms);

/// True for a key whose map has names of signals or parameters as keys.
bool names_a_signal(const language::FormList& map_forms, const std::string& key);

/// True where a key defines a parameter or an input.
bool defines(const language::FormList& forms, const std::string& section);

/// Returns the numbers of {value: [1, 2], unit: N} with the unit behind each.
std::optional<yaml::Node> numbers_with_unit(const yaml::Node& map, const language::FormList& forms);

/// Returns the value of a parameter's map with its unit behind each number.
std::optional<yaml::Node> merged_unit(const yaml::Node& map, const language::FormList& forms);

/// Returns the name in `solver: {name: rodas}` where the name alone means the same; nullptr for other maps, and
/// for solvers that control their error in a map alone.
const yaml::Node* only_solver(const yaml::Node& map, const language::FormList& forms);

/// Properties of a scalar that follow from its possible forms.
struct ScalarForms {
  bool is_plain_text = false;  ///< a title, word or path
  bool is_value = false;       ///< a number, word or formula
  bool is_source = false;
  bool is_signal = false;
  bool in_unit = false;                     ///< may end in " in mm"
  std::optional<unit::Dimension> demanded;  ///< of a number
};
ScalarForms scalar_forms(const language::FormList& scalars, const std::optional<unit::Dimension>& demanded);

/// True for a parameter of a block that is a text, and no formula.
bool is_text(const ParameterSpec& spec);

bool is_truth(const std::string& text);

}  // namespace stepwire::difference
