#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/kept_points.hpp"
#include "engine/base/messages/messages.hpp"

namespace stepwire::session {

/// The points of a sweep that other processes run: they ask process 0 for some, which keeps what they send.
class PointServer {
 public:
  /// Process 0 of `messages`, which has at least two.
  PointServer(messages::Messages& messages, KeptPoints& kept)
      : messages_(messages), kept_(kept), workers_(static_cast<std::size_t>(messages.size())) {}

  /// Serves until all points are kept, until the rest of them died with their processes, or until it is
  /// interrupted.
  void serve(const Monitor& monitor);
  /// "process 2 on node7 has died; ...", a sentence for each; none where all are well.
  const std::vector<std::string>& deaths() const { return deaths_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    std::string host;
    std::int64_t process = 0;
    std::vector<std::size_t> has;  ///< points that it has been given and has not sent yet
    Clock::time_point heard = Clock::now();
    bool asks = false, ended = false;
  };

  void take(const messages::Message& message);
  void take_results(Worker& worker, std::string_view rest);
  void give(std::size_t worker);
  void look_for_deaths();
  bool all_ended() const;

  messages::Messages& messages_;
  KeptPoints& kept_;
  std::vector<Worker> workers_;
  std::vector<std::string> deaths_;
};

/// The points that process 0 gives to this one.
class ServedPoints : public run::PointExchange {
 public:
  /// Once `interrupt` is true, there are no more points; it may be null.
  ServedPoints(messages::Messages& messages, const std::atomic<bool>* interrupt);

  std::optional<std::size_t> next() override;
  void take(run::PointResult result) override;
  double done() const override { return 0.0; }
  /// Lets process 0 know that this one is at work, now and then.
  void note_alive();
  /// Says why this process gives up.
  void fail(const std::string& why);

 private:
  void send_results();

  messages::Messages& messages_;
  const std::atomic<bool>* interrupt_;
  std::vector<std::size_t> given_;  ///< the next one last
  std::string results_;
  std::chrono::steady_clock::time_point sent_ = std::chrono::steady_clock::now();
};

}  // namespace stepwire::session
