#pragma once

#include <map>
#include <string>

#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::fmu {

/// Returns the files of the unit of a diagram that is given as text, and writes NAME.yaml into the folder.
std::map<std::string, std::string> unit_files(const Scratch& folder, const std::string& name,
                                              const std::string& yaml, int version);

/// The same as NAME.fmu in the folder; its path.
std::string exported(const Scratch& folder, const std::string& name, const std::string& yaml,
                     int version = 3);

/// Loaded binary of the unit of a diagram. It stays loaded until the process ends.
class Binary {
 public:
  Binary(const std::string& name, const std::string& yaml, int version);

  const std::string& token() const { return token_; }
  /// Returns the function of this name; a missing one fails the test.
  template <class Function>
  Function* find(const char* name) const {
    return reinterpret_cast<Function*>(address(name));
  }

 private:
  void* address(const char* name) const;

  void* library_;
  std::string token_;
};

/// True if there is a compiler; warns otherwise.
bool there_is_a_compiler();

}  // namespace stepwire::fmu
