#pragma once

#include <memory>

#include "engine/base/messages/messages.hpp"

namespace stepwire::mpi {

/// Joins the processes of mpirun; may be called once in a process.
std::unique_ptr<messages::Messages> join();

}  // namespace stepwire::mpi
