#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <vector>

#include "engine/app/cluster/group_size.hpp"
#include "engine/app/cluster/item_source.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/base/messages/messages.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cluster {

/// Process 0 of several: it gives the items of one job after the other to those that ask for some, and takes
/// what comes out of them.
class ItemServer {
 public:
  /// `messages` has at least two processes.
  explicit ItemServer(messages::Messages& messages)
      : messages_(messages),
        workers_(static_cast<std::size_t>(messages.size())),
        living_(workers_.size() - 1) {}

  /// Serves until all items of a job are done, until the rest of them was lost with their processes, or until
  /// it is interrupted. `job` says what the items are. Throws the Error that a process threw.
  void serve(ItemSource& source, const std::string& job, const session::Monitor& monitor);
  /// Has all others end. False where some of them will not come to their end by themselves.
  bool finish();
  /// "process 2 on node7 has died ..., and with it 3 ...": a sentence for each; none where all are well.
  const std::vector<std::string>& deaths() const { return deaths_; }
  /// What it has cost so far, beside waiting: to answer a message, and to keep what came out of an item [s].
  double seconds_of_answer() const { return size_.answer(); }
  double seconds_of_item() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    std::string host;
    std::int64_t process = 0;
    std::deque<std::size_t> has;  ///< items that it has been given and has not done yet
    Clock::time_point heard = Clock::now();
    bool wants_job = false;
    bool ended = false;  ///< does no more items
    bool gone = false;   ///< sends nothing any more
    bool lost = false;   ///< has died, and not only what works for it
  };

  void step();
  void measure(char kind, double seconds);
  void take(std::size_t of, char kind, std::string_view rest);
  void take_note(std::size_t of, char kind, std::string_view rest);
  void take_request(std::size_t of, std::string_view rest);
  void take_results(Worker& worker, std::string_view rest);
  void give(std::size_t worker);
  void give_job(std::size_t worker);
  void note_death(std::size_t worker, const std::string& what);
  void look_for_deaths();
  void end(Worker& worker);
  bool is_done() const;

  messages::Messages& messages_;
  std::vector<Worker> workers_;     ///< by their process; the first is none
  std::size_t living_, given_ = 0;  ///< workers that do items, and the items that they have
  std::vector<std::string> deaths_;
  std::vector<yaml::Fault> refused_;
  GroupSize size_;
  ItemSource* source_ = nullptr;  ///< null between jobs
  std::string job_;
  std::uint64_t job_number_ = 0;
  Clock::time_point looked_ = Clock::now();
  double taking_ = 0.0;    ///< what the items of the message at hand cost [s]
  std::size_t taken_ = 0;  ///< that it brought
  double costs_ = 0.0;     ///< of all items whose cost was measured [s]
  std::size_t items_ = 0;  ///< how many these are
};

}  // namespace stepwire::cluster
