#pragma once

#include <string_view>

namespace mu {
class Parser;
}

namespace stepwire {

/// How many values a function takes.
struct Arity {
  int least = 1;
  int most = 1;
};

/// The arity of a function of the language; nullptr if there is none of that name.
const Arity* find_function(std::string_view name);

/// Replaces what a parser knows by the functions and signs of the language.
void define_language(mu::Parser& parser);

}  // namespace stepwire
