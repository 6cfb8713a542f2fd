#include "engine/base/fmi/library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "engine/base/subprocess/fork.hpp"

namespace stepwire::fmi {

namespace {

// A guarded call, since code compiled with -ffast-math sets flush-to-zero on loading.
void* load(const std::string& file, CallNote& note) {
  const std::lock_guard lock(subprocess::loader_mutex());
  const ForeignCall call(note, "the loading of its binary");
  return dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
}

}  // namespace

Library::Library(const std::string& file, CallNote& note) : note_(note), handle_(load(file, note)) {
  if (!handle_) throw UnitError(fmt::format("its binary cannot be loaded: {}", dlerror()));
}

Library::~Library() {
  const std::lock_guard lock(subprocess::loader_mutex());
  const ForeignCall call(note_, "the unloading of its binary");
  dlclose(handle_);
}

void* Library::address_if_there(const char* name) const {
  return dlsym(handle_, name);
}

void* Library::address(const char* name) const {
  void* found = address_if_there(name);
  if (!found) throw UnitError(fmt::format("its binary has no function {}", name));
  return found;
}

}  // namespace stepwire::fmi
