#include "engine/base/messages/mpi/mpi_messages.hpp"

#include <mpi.h>

#include <list>
#include <stdexcept>
#include <thread>

namespace stepwire::mpi {

using messages::Message;

namespace {

class MpiMessages : public messages::Messages {
 public:
  MpiMessages() {
    int provided = 0;
    require(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided));
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    require(MPI_Comm_rank(MPI_COMM_WORLD, &rank_));
    require(MPI_Comm_size(MPI_COMM_WORLD, &size_));
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void send(int to, std::string_view bytes) override {
    forget_sent();
    Sending& sending = sent_.emplace_back(Sending{std::string(bytes), MPI_REQUEST_NULL});
    require(MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()), MPI_BYTE, to, 0,
                      MPI_COMM_WORLD, &sending.request));
  }

  std::optional<Message> receive(std::chrono::milliseconds wait) override {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + wait;
    std::chrono::microseconds pause{0};
    while (true) {
      int is_there = 0;
      MPI_Status status;
      require(MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &is_there, &status));
      if (is_there) return take(status);
      if (Clock::now() >= end) return std::nullopt;
      std::this_thread::sleep_for(pause);
      if (pause < std::chrono::microseconds{500}) pause += std::chrono::microseconds{10};
    }
  }

  void finish() override {
    for (Sending& sending : sent_) require(MPI_Wait(&sending.request, MPI_STATUS_IGNORE));
    require(MPI_Finalize());
  }

  [[noreturn]] void abort(int status) override {
    MPI_Abort(MPI_COMM_WORLD, status);
    std::_Exit(status);
  }

 private:
  /// A message being sent; its bytes must not move until the request is complete.
  struct Sending {
    std::string bytes;
    MPI_Request request;
  };

  static void require(int code) {
    if (code == MPI_SUCCESS) return;
    char text[MPI_MAX_ERROR_STRING];
    int size = 0;
    MPI_Error_string(code, text, &size);
    throw std::runtime_error("MPI: " + std::string(text, static_cast<std::size_t>(size)));
  }

  Message take(const MPI_Status& status) {
    int size = 0;
    require(MPI_Get_count(&status, MPI_BYTE, &size));
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    require(
        MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE));
    return message;
  }

  void forget_sent() {
    for (auto sending = sent_.begin(); sending != sent_.end();) {
      int is_done = 0;
      require(MPI_Test(&sending->request, &is_done, MPI_STATUS_IGNORE));
      sending = is_done ? sent_.erase(sending) : std::next(sending);
    }
  }

  int rank_ = 0, size_ = 1;
  std::list<Sending> sent_;
};

}  // namespace

std::unique_ptr<messages::Messages> join() {
  return std::make_unique<MpiMessages>();
}

}  // namespace stepwire::mpi
