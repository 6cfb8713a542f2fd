#pragma once

#include <functional>
#include <set>
#include <string>

#include "tests/random/dice.hpp"
#include "tests/random/sketch.hpp"

namespace stepwire::random {

/// Diagrams that compute the same as another one, by construction.

/// The blocks of these names in a part of their own. A bus, and a block that reads one as a whole, stays
/// outside and is taken out of `moved`.
Sketch with_part(const Sketch& sketch, std::set<std::string>& moved, const std::string& name,
                 const std::string& file);
/// The blocks in another order of lines.
Sketch shuffled(const Sketch& sketch, Dice& dice);
/// Every block "n3" as "renamed_n3", in the order of names turned around.
Sketch renamed(const Sketch& sketch);
std::string renamed_word(const std::string& word);
/// Further blocks that nothing else reads.
Sketch with_unrelated(const Sketch& sketch);

/// Calls `other` for each reference ("n3", "n3.y", "n3.2") to one of these blocks in a text, and puts what it
/// returns there.
std::string with_references(const std::string& text, const std::set<std::string>& names,
                            const std::function<std::string(const std::string&)>& other);

/// The value of a key of the head; nullptr where it is left out.
const std::string* find_head(const Sketch& sketch, const std::string& name);

}  // namespace stepwire::random
