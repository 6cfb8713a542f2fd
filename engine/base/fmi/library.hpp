#pragma once

#include <string>

#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/unit_error.hpp"

namespace stepwire::fmi {

/// A loaded binary. Loading and unloading run foreign code.
class Library {
 public:
  /// Loads a binary. Throws UnitError with the linker's reason.
  Library(const std::string& file, CallNote& note);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  /// Sets a pointer to the function of this name. Throws UnitError if it is missing.
  template <class Function>
  void find(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(address(name));
  }
  /// Sets a pointer to the function of this name; nullptr if it is missing.
  template <class Function>
  void find_if_there(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(address_if_there(name));
  }

 private:
  void* address(const char* name) const;
  void* address_if_there(const char* name) const;

  CallNote& note_;
  void* handle_;
};

}  // namespace stepwire::fmi
