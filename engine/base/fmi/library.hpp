#pragma once

#include <string>

#include "engine/base/fmi/unit_error.hpp"

namespace stepwire::fmi {

/// A binary that is loaded.
class Library {
 public:
  /// Throws UnitError with the linker's reason.
  explicit Library(const std::string& file);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  /// Sets a pointer to the function of a name; throws UnitError where there is none.
  template <class Function>
  void find(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(address(name));
  }

 private:
  void* address(const char* name) const;

  void* handle_;
};

}  // namespace stepwire::fmi
