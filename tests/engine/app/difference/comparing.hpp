#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/app/difference/difference.hpp"

namespace stepwire::difference {

/// All blocks of the library.
const Registry& every_block();

/// Files as {path, text}.
using GivenFiles = std::vector<std::pair<std::string, std::string>>;

/// Differences of two texts, and of parts that are given beside them.
Difference compared(const std::string& before, const std::string& after, const GivenFiles& old_parts = {},
                    const GivenFiles& new_parts = {});

/// Lines of the differences, without places, names of files and sections: "~ a.gain: 1 -> 2 (2 times)".
std::vector<std::string> lines(const Difference& difference);
/// The same of two texts.
std::vector<std::string> lines(const std::string& before, const std::string& after);

/// All diagram files of the repository.
std::vector<std::string> all_diagrams();

/// A small diagram: a loop of four blocks with a parameter, a record, a figure and two claims.
extern const std::string loop_yaml;

/// Returns a text with one piece replaced, which it has to contain.
std::string with(std::string text, const std::string& from, const std::string& to);

}  // namespace stepwire::difference
