#pragma once

#include "engine/base/messages/messages.hpp"
#include "engine/base/messages/worker_process.hpp"

namespace stepwire::cluster {

/// Forwards messages between process 0 and the worker of this process until process 0 sends the end message,
/// and reports the death of the worker. MPI would end the whole call with a process that dies. So the work
/// runs in a child process, whose death leaves the MPI processes intact.
void relay(messages::Messages& messages, messages::WorkerProcess& worker);

}  // namespace stepwire::cluster
