#pragma once

#include <cstddef>
#include <functional>

namespace stepwire {

/// Does task(0) to task(count - 1), on so many threads (0: all cores). What a task throws is thrown again.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task);

}  // namespace stepwire
