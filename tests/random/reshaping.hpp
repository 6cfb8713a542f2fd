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
/// New name of a block "n3": "z997_n3", with the order of the names turned around.
std::string renamed_word(const std::string& word);
/// New name of a block "n3": "n_n3", with the names in their order.
std::string word_of_same_order(const std::string& word);
/// Every block under another name.
using OtherWord = std::string (*)(const std::string& word);
Sketch renamed(const Sketch& sketch, OtherWord other_word);
/// Further blocks that nothing else reads.
Sketch with_unrelated(const Sketch& sketch);

/// Calls `other` for each reference ("n3", "n3.y", "n3.2") to one of these blocks in a text, and puts what it
/// returns there.
std::string with_references(const std::string& text, const std::set<std::string>& names,
                            const std::function<std::string(const std::string&)>& other);

/// The value of a key of the head; nullptr where it is left out.
const std::string* find_head(const Sketch& sketch, const std::string& name);

}  // namespace stepwire::random
