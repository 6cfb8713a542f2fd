#include "engine/base/fmi/calls.hpp"

#include "engine/base/fmi/calls_of.hpp"

namespace stepwire::fmi {

std::unique_ptr<Calls> instantiate(const Package& package, Mode mode, const std::string& name,
                                   CallNote& note) {
  return package.description().version == 2 ? instance_of_2(package, mode, name, note)
                                            : instance_of_3(package, mode, name, note);
}

const Interface& interface_of(const Description& description, Mode mode) {
  return mode == Mode::co_simulation ? description.co_simulation : description.model_exchange;
}

}  // namespace stepwire::fmi
