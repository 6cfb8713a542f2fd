#include <stepwire/registry.hpp>

#include "drag.hpp"

void register_blocks(stepwire::Registry& registry) {
  registry.add<yard::Drag>("yard");
}
