#pragma once

#include <string>
#include <vector>

namespace stepwire::reference {

/// Option or positional argument of a verb, as declared.
struct OptionWords {
  std::vector<std::string> names;    ///< with dashes: "-o", "--out"; without for a positional argument
  std::string value;                 ///< word for the value in the help, "TEXT"; empty for a flag
  std::vector<std::string> choices;  ///< allowed values; empty if there is no closed list
  std::string about;
  bool required = false, repeated = false;
};

/// Verb with its options and arguments. The program itself has an empty name.
struct VerbWords {
  std::string name, about, footer;
  std::vector<OptionWords> positionals, options;
};

}  // namespace stepwire::reference
