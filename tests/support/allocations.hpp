#pragma once

namespace stepwire {

/// Returns the number of allocations of this thread so far, by new or by malloc. They are counted in programs
/// that link tests_allocations.
long allocations();

}  // namespace stepwire
