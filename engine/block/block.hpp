#pragma once

// What the header of a block needs. How blocks are declared and configured is for their .cpp files: see
// declare.hpp.
#include "engine/signal/clock.hpp"
#include "engine/signal/input.hpp"
#include "engine/signal/notice.hpp"
#include "engine/signal/numbers.hpp"
#include "engine/signal/per_element.hpp"
#include "engine/signal/signal.hpp"
#include "engine/signal/text.hpp"

namespace stepwire {

class Configure;
struct Outline;

template <class Block>
class Declare;

}  // namespace stepwire
