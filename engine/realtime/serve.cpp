#include "engine/realtime/serve.hpp"

#include <thread>

namespace stepwire {

Served serve_in_real_time(Loop& loop, std::int64_t deadlines, const ThreadPolicy& policy,
                          std::optional<int> cpu) {
  Served served;
  std::thread thread([&] {
    const RealTimeThread real_time(policy, cpu);
    served = {real_time.refused(), RealTimeThread::policy_in_force()};
    loop.serve(deadlines);
  });
  thread.join();
  return served;
}

}  // namespace stepwire
