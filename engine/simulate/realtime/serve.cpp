#include "engine/simulate/realtime/serve.hpp"

#include <exception>
#include <thread>

namespace stepwire::realtime {

Served serve_in_real_time(Loop& loop, std::int64_t deadlines, const ThreadPolicy& policy,
                          std::optional<int> cpu) {
  Served served;
  std::exception_ptr failure;
  std::thread thread([&] {
    try {
      const RealTimeThread real_time(policy, cpu);
      served = {real_time.refused(), RealTimeThread::policy_in_force()};
      loop.serve(deadlines);
    } catch (...) {
      failure = std::current_exception();
    }
  });
  thread.join();
  if (failure) std::rethrow_exception(failure);
  return served;
}

}  // namespace stepwire::realtime
