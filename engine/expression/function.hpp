#pragma once

#include <span>
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

/// The value of a function of the language; the values are as many as it takes.
double call_function(std::string_view name, std::span<const double> values);

/// Replaces what a parser knows by the functions and signs of the language.
void define_language(mu::Parser& parser);

}  // namespace stepwire
