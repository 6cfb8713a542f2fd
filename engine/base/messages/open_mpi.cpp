#include <dlfcn.h>
#include <fmt/format.h>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/messages/messages.hpp"

namespace stepwire::messages {

/// The module stays loaded until the process ends; the parts of MPI, which it loads by themselves, look for
/// its symbols among those of all.
std::unique_ptr<Messages> open_mpi() {
  const std::string folder = io::find_resource("mpi");
  if (folder.empty())
    throw io::EnvironmentError(
        "this program was built without MPI; './stepwire setup mpi' in its checkout adds it, with the Debian "
        "packages libopenmpi-dev and openmpi-bin");
  void* const module =
      ::dlopen((folder + "/libstepwire_mpi.so").c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE);
  using Open = Messages* (*)();
  const auto open = module ? reinterpret_cast<Open>(::dlsym(module, "stepwire_open_mpi")) : nullptr;
  if (!open) throw io::EnvironmentError(fmt::format("the module for MPI cannot be loaded: {}", ::dlerror()));
  return std::unique_ptr<Messages>(open());
}

}  // namespace stepwire::messages
