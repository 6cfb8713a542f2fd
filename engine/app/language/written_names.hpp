#pragma once

#include <string>
#include <vector>

#include "engine/app/language/forms.hpp"
#include "engine/app/language/text_places.hpp"

namespace stepwire::language {

/// A name as a file has it, perhaps with dots: where, and what it can be the name of.
struct WrittenName {
  enum class Sense {
    signal,     ///< of a block, port or swept parameter: rig.x
    parameter,  ///< of a parameter: $mass, mass in "= mass*2", rig.mass in a sweep
    block,      ///< the key of a block, where it is defined
    input,      ///< the key of a port, where it is defined
    output,
    defined,    ///< the key of a parameter, where it is defined
    inside,     ///< of a block or part, also inside of parts, or of a signal
    part_key,   ///< a key of a part: the name of its input or parameter
    block_key,  ///< a key of a block
    type,       ///< a kind of block
    file        ///< the file of a part
  };
  TextRange range;
  std::string name;
  Sense sense;
  std::string block;  ///< in whose map it stands
};

/// All names of a diagram file in the order of the text. `text` is what the document was read from.
std::vector<WrittenName> written_names(const yaml::Document& document, std::string_view text, Forms& forms);

/// A name in an expression: where it stands in that text, and whether it is one of a parameter, behind a '$'.
struct NameInText {
  TextRange range;
  bool parameter = false;
};

/// May it stand in a name? A letter, a digit or '_'.
bool is_name_character(char c);

/// The names of an expression as it is written, also of one that is wrong. Units behind numbers are none.
std::vector<NameInText> names_in_expression(std::string_view text);

}  // namespace stepwire::language
