#pragma once

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace stepwire::parallel {

/// Starts threads that run `work` beside the calling one, up to the given total with it. Starts fewer where
/// the system refuses.
std::vector<std::jthread> begin_threads(std::size_t wanted, const std::function<void()>& work);

/// Runs `work` on several threads at once (0: one for each core) and rethrows its exceptions. Calls `begun`
/// on the calling thread with the number of started threads, before that thread works as well.
void on_threads(unsigned threads, const std::function<void()>& work,
                const std::function<void(std::size_t)>& begun = {});

/// Runs task(0) to task(count - 1) on several threads (0: all cores) and rethrows their exceptions.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task);

}  // namespace stepwire::parallel
