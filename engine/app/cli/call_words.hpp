#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stepwire::cli {

/// An option or a positional word of a verb, as its verb declares it.
struct OptionWords {
  std::vector<std::string> names;    ///< with their dashes: "-o", "--out"; the bare name of a positional
  std::string value;                 ///< what its value is called: "TEXT"; empty for a flag
  std::vector<std::string> choices;  ///< all values that it takes; empty where these are not listed
  std::string about;
  bool required = false, repeated = false;
};

/// A verb with its words. The program as a whole has no name.
struct VerbWords {
  std::string name, about, footer;
  std::vector<OptionWords> positionals, options;
};

/// What the program takes before a verb.
VerbWords program_words(const CLI::App& program);

/// All verbs of the program, in the order of their declaration.
std::vector<VerbWords> verb_words(const CLI::App& program);

}  // namespace stepwire::cli
