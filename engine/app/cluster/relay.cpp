#include "engine/app/cluster/relay.hpp"

#include <unistd.h>

#include <cstdint>

#include "engine/app/cluster/item_messages.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"

namespace stepwire::cluster {
namespace {

constexpr std::chrono::seconds between_signs{10};

class Relay {
 public:
  Relay(messages::Messages& messages, messages::WorkerProcess& worker)
      : messages_(messages), worker_(worker) {
    messages::ByteWriter writer;
    all(writer, kind::hello, own_process, this_host());
    messages_.send(0, writer.take());
  }

  void go_on() {
    bool goes_on = true;
    while (goes_on) {
      from_worker();
      if (const auto message = messages_.receive(std::chrono::milliseconds{1})) goes_on = to_worker(*message);
      note_alive();
    }
    worker_.end();
    messages_.send(0, std::string(1, kind::bye));
  }

 private:
  void from_worker() {
    try {
      while (connected_) {
        const auto bytes = worker_.other().receive({});
        if (!bytes) return;
        messages_.send(0, *bytes);
      }
    } catch (const io::EnvironmentError&) {
      connected_ = false;
    }
    if (const auto how = worker_.death()) messages_.send(0, kind::died + *how);
  }

  /// False after the end message.
  bool to_worker(const messages::Message& message) {
    if (message.bytes.starts_with(kind::end)) return false;
    try {
      if (connected_) worker_.other().send(message.bytes);
    } catch (const io::EnvironmentError&) {  // The worker has died; from_worker() reports it.
    }
    return true;
  }

  void note_alive() {
    if (std::chrono::steady_clock::now() - noted_ < between_signs) return;
    noted_ = std::chrono::steady_clock::now();
    messages_.send(0, std::string(1, kind::alive));
  }

  messages::Messages& messages_;
  messages::WorkerProcess& worker_;
  const std::int64_t own_process = ::getpid();
  bool connected_ = true;
  std::chrono::steady_clock::time_point noted_ = std::chrono::steady_clock::now();
};

}  // namespace

void relay(messages::Messages& messages, messages::WorkerProcess& worker) {
  Relay(messages, worker).go_on();
}

}  // namespace stepwire::cluster
