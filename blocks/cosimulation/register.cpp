#include "blocks/cosimulation/register.hpp"

#include "blocks/cosimulation/fmu_types.hpp"
#include "engine/model/block/typed_by_file.hpp"

namespace stepwire {

void register_cosimulation(Registry& registry) {
  registry.add(any_fmu_type());
  note_typed_by_file("Fmu", fmu_type);
}

}  // namespace stepwire
