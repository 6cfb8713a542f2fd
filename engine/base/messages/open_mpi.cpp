#include <dlfcn.h>
#include <fmt/format.h>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/messages/messages.hpp"

namespace stepwire::messages {

/// Loads the module for the rest of the process. RTLD_GLOBAL is needed because plugins of MPI search the
/// global symbols.
std::unique_ptr<Messages> open_mpi() {
  const std::string file = io::resource("mpi") + "/libstepwire_mpi.so";
  void* const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE);
  using Open = Messages* (*)();
  const auto open = module ? reinterpret_cast<Open>(::dlsym(module, "stepwire_open_mpi")) : nullptr;
  if (!open) throw io::EnvironmentError(fmt::format("the module for MPI cannot be loaded: {}", ::dlerror()));
  return std::unique_ptr<Messages>(open());
}

}  // namespace stepwire::messages
