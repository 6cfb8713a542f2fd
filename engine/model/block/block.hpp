#pragma once

// What the header of a block needs. How blocks are declared and configured is for their .cpp files: see
// declare.hpp.
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
