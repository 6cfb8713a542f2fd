// The module for MPI, which the program loads for the option --mpi alone.
#include "engine/base/messages/mpi/mpi_messages.hpp"

extern "C" stepwire::messages::Messages* stepwire_open_mpi() {
  return stepwire::mpi::join().release();
}
