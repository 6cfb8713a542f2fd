#pragma once

// Base header of blocks. Only their .cpp files need the declaration and configuration, see declare.hpp.
#include "engine/model/block/crossings.hpp"
#include "engine/model/signal/clock.hpp"
#include "engine/model/signal/diagnostic.hpp"
#include "engine/model/signal/input.hpp"
#include "engine/model/signal/numbers.hpp"
#include "engine/model/signal/per_element.hpp"
#include "engine/model/signal/signal.hpp"
#include "engine/model/signal/text.hpp"

namespace stepwire {

class Configure;
struct Outline;

template <class Block>
class Declare;

}  // namespace stepwire
