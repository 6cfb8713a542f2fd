#include "engine/base/parallel/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>

namespace stepwire::parallel {

std::vector<std::jthread> begin_threads(std::size_t wanted, const std::function<void()>& work) {
  std::vector<std::jthread> threads;
  try {
    while (threads.size() + 1 < wanted) threads.emplace_back(work);
  } catch (const std::system_error&) {  // the system refuses more threads: the existing ones do the work
  }
  return threads;
}

void on_threads(unsigned threads, const std::function<void()>& work,
                const std::function<void(std::size_t)>& begun) {
  std::mutex mutex;
  std::exception_ptr failure;
  const auto caught = [&] {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
    }
  };
  {
    const std::vector<std::jthread> others =
        begin_threads(threads ? threads : std::max(1u, std::thread::hardware_concurrency()), caught);
    if (begun) begun(others.size() + 1);
    caught();
  }
  if (failure) std::rethrow_exception(failure);
}

void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  const auto wanted = threads ? threads : std::max(1u, std::thread::hardware_concurrency());
  on_threads(static_cast<unsigned>(std::min<std::size_t>(wanted, std::max<std::size_t>(count, 1))), [&] {
    for (std::size_t i = next++; i < count; i = next++) task(i);
  });
}

}  // namespace stepwire::parallel
