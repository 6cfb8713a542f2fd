#include "engine/base/fmi/library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

namespace stepwire::fmi {

Library::Library(const std::string& file) : handle_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (!handle_) throw UnitError(fmt::format("its binary cannot be loaded: {}", dlerror()));
}

Library::~Library() {
  dlclose(handle_);
}

void* Library::address(const char* name) const {
  void* found = dlsym(handle_, name);
  if (!found) throw UnitError(fmt::format("its binary has no function {}", name));
  return found;
}

}  // namespace stepwire::fmi
