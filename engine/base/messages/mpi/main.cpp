// Entry point of the module for MPI, which the program loads only for the option --mpi.
#include "engine/base/messages/mpi/mpi_messages.hpp"

extern "C" stepwire::messages::Messages* stepwire_open_mpi() {
  return stepwire::mpi::join().release();
}
