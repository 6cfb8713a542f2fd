#include "blocks/register.hpp"

#include "blocks/continuous/register.hpp"
#include "blocks/cosimulation/register.hpp"
#include "blocks/discrete/register.hpp"
#include "blocks/haptics/register.hpp"
#include "blocks/hardware/register.hpp"
#include "blocks/logic/register.hpp"
#include "blocks/math/register.hpp"
#include "blocks/nonlinear/register.hpp"
#include "blocks/operators/register.hpp"
#include "blocks/plants/register.hpp"
#include "blocks/routing/register.hpp"
#include "blocks/sinks/register.hpp"
#include "blocks/sources/register.hpp"

namespace stepwire {

Registry blocks() {
  Registry registry;
  register_sources(registry);
  register_math(registry);
  register_continuous(registry);
  register_discrete(registry);
  register_nonlinear(registry);
  register_logic(registry);
  register_routing(registry);
  register_sinks(registry);
  register_haptics(registry);
  register_operators(registry);
  register_plants(registry);
  register_hardware(registry);
  register_cosimulation(registry);
  return registry;
}

}  // namespace stepwire
