#pragma once

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace stepwire::parallel {

/// Begins threads that work beside the calling one, so that there are `wanted` with it; fewer where the
/// system gives no more.
std::vector<std::jthread> begin_threads(std::size_t wanted, const std::function<void()>& work);

/// Does the work on so many threads at once (0: one for each core). What it throws is thrown again. `begun` is
/// called with the number of threads that the system has given, on the calling one, before that works as well.
void on_threads(unsigned threads, const std::function<void()>& work,
                const std::function<void(std::size_t)>& begun = {});

/// Does task(0) to task(count - 1), on so many threads (0: all cores). What a task throws is thrown again.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task);

}  // namespace stepwire::parallel
