#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "engine/app/cluster/kept_items.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/base/messages/messages.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cluster {

/// Size of the group of items that a process is given at once.
/// Large groups keep the server mostly idle; small ones let all processes end together and lose little work
/// with a process. The rule is guided self-scheduling: each request gets a fixed fraction of an even share of
/// the remaining items, so groups shrink towards the end. A group is at least as long as the measured cost of
/// answers demands, and at most 10 s long.
class GroupSize {
 public:
  /// Adds a group of items that a process has done in `seconds`.
  void note_group(std::size_t items, double seconds);
  /// Adds the time [s] of answering a message, without storing the results in it.
  void note_answer(double seconds);

  /// Returns the size of the next group, with `left` items not given out yet and `processes` processes.
  std::size_t next(std::size_t left, std::size_t processes) const;
  /// Returns the mean time of an answer [s]; 0 before the first note.
  double answer() const { return answer_.value(); }

 private:
  /// Mean that forgets: old values lose weight.
  struct Mean {
    double sum = 0.0, count = 0.0;
    void add(double value, double weight);
    double value() const { return count > 0.0 ? sum / count : 0.0; }
  };

  Mean item_, answer_;  ///< [s]
};

/// Server in process 0 that distributes the items of one job after the other to the other processes, and
/// collects the results.
class ItemServer {
 public:
  /// `messages` must have at least two processes.
  explicit ItemServer(messages::Messages& messages)
      : messages_(messages),
        workers_(static_cast<std::size_t>(messages.size())),
        living_(workers_.size() - 1) {}

  /// Serves until all items of the job are done, until the processes of the remaining ones have died, or
  /// until an interruption. The text `job` is the content of the job message. Throws the Error that a worker
  /// reports.
  void serve(ItemSource& source, const std::string& job, const session::Monitor& monitor);
  /// Ends all workers. False if some of them are lost and will not exit by themselves.
  bool finish();
  /// One sentence for each death: "process 2 on node7 has died ..., and with it 3 ...".
  const std::vector<std::string>& deaths() const { return deaths_; }
  /// Return measured mean costs [s], without waiting: of answering a message, and of storing the result of an
  /// item.
  double seconds_of_answer() const { return size_.answer(); }
  double seconds_of_item() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    std::string host;
    std::int64_t process = 0;
    std::deque<std::size_t> has;  ///< items given but not done
    Clock::time_point heard = Clock::now();
    bool wants_job = false;
    bool ended = false;  ///< accepts no more items
    bool gone = false;   ///< sends no more messages
    bool lost = false;   ///< the process itself has died, not only its child process
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
  std::vector<Worker> workers_;     ///< indexed by process; element 0 is unused
  std::size_t living_, given_ = 0;  ///< workers that accept items, and items in work
  std::vector<std::string> deaths_;
  std::vector<yaml::Fault> refused_;
  GroupSize size_;
  ItemSource* source_ = nullptr;  ///< nullptr between jobs
  std::string job_;
  std::uint64_t job_number_ = 0;
  Clock::time_point looked_ = Clock::now();
  double taking_ = 0.0;    ///< cost of the items in the current message [s]
  std::size_t taken_ = 0;  ///< number of items in the current message
  double costs_ = 0.0;     ///< total cost of all measured items [s]
  std::size_t items_ = 0;  ///< number of all measured items
};

}  // namespace stepwire::cluster
