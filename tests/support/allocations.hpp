#pragma once

namespace stepwire {

/// How often this thread has asked for memory so far, by new or by malloc. Programs that link
/// tests_allocations count.
long allocations();

}  // namespace stepwire
