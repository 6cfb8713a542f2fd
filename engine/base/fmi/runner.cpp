#include "engine/base/fmi/runner.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <new>
#include <optional>

#include "engine/base/fmi/call_watch.hpp"
#include "engine/base/fmi/isolated.hpp"
#include "engine/base/io/descriptor.hpp"

namespace stepwire::fmi {

namespace {

/// Runner in this process.
class Inside : public Runner {
 public:
  Inside(const Setup& setup, const Counts& counts)
      : setup_(setup), memory_(new (std::align_val_t(alignof(Exchange))) char[Exchange::bytes(counts)]()) {
    exchange_ = new (memory_.get()) Exchange;
    exchange_->counts = counts;
    watch_.emplace(exchange_->call, fmt::format("{}: the unit {}", setup.name, setup.package->path()));
    model_ = std::make_unique<Model>(setup_, *exchange_);
  }

  bool run(Operation operation) override {
    exchange_->operation = operation;
    model_->run();
    [[maybe_unused]] const int back = ::fchdir(folder_.number());  // a unit may change the working directory
    return exchange_->ok != 0;
  }

 private:
  struct Free {
    void operator()(char* memory) const { ::operator delete[](memory, std::align_val_t(alignof(Exchange))); }
  };
  Setup setup_;
  /// Working directory, into which results are written.
  io::Descriptor folder_{::open(".", O_PATH | O_DIRECTORY | O_CLOEXEC)};
  std::unique_ptr<char[], Free> memory_;
  std::optional<CallWatch> watch_;
  std::unique_ptr<Model> model_;
};

}  // namespace

std::unique_ptr<Runner> make_runner(const Setup& setup, bool isolated, std::size_t kept) {
  Counts counts = counts_of(setup);
  counts.kept = kept;
  if (isolated) return std::make_unique<Isolated>(setup, counts);
  return std::make_unique<Inside>(setup, counts);
}

}  // namespace stepwire::fmi
