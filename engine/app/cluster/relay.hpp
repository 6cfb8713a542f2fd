#pragma once

#include "engine/base/messages/messages.hpp"
#include "engine/base/messages/worker_process.hpp"

namespace stepwire::cluster {

/// Hands on what process 0 and the worker of this process send to each other, and says when the worker died,
/// until process 0 has all end. So a worker may die, and the processes of the call stay together.
void relay(messages::Messages& messages, messages::WorkerProcess& worker);

}  // namespace stepwire::cluster
