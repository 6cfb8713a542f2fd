#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "engine/app/session/loop_settings.hpp"
#include "engine/app/studio/live/arguments.hpp"
#include "engine/app/studio/live/frame_views.hpp"
#include "engine/app/studio/live/scene_now.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::live {

/// Estimator of the offset between the clock of a page and the one of this process. Delays are never
/// negative, so the smallest difference of send and arrival time is the best estimate. The minimum covers the
/// last 10 to 20 s, as clocks drift.
class PageClock {
 public:
  /// Adds a message that was sent at `page` and arrived at `now` [s].
  void came(double page, double now) {
    if (now - began_ > window) {
      offsets_[1] = offsets_[0];
      offsets_[0] = std::numeric_limits<double>::infinity();
      began_ = now;
    }
    if (now - page < offsets_[0]) offsets_[0] = now - page;
  }

  /// Converts a time of the page to the clock of this process; infinite before the first message.
  double here(double page) const { return page + (offsets_[0] < offsets_[1] ? offsets_[0] : offsets_[1]); }

 private:
  static constexpr double window = 10.0;  // [s]
  static constexpr double none = std::numeric_limits<double>::infinity();

  double began_ = -none;
  std::array<double, 2> offsets_{none, none};
};

/// Receivers of news and data for pages. Called from any thread; must return soon.
struct Sinks {
  std::function<void(json::Json news)> news;               ///< for all pages
  std::function<void(int page, std::string bytes)> frame;  ///< data of one view
};

/// Function that loads the model of a file from its edited texts. `hand`: the pointer of a page replaces the
/// source of the pin's motion. Throws Error.
using Load = std::function<Loading(int file, bool hand)>;

struct LiveOptions {
  std::optional<session::LoopSettings> loop{};  ///< set: runs are real-time loops with these settings
  std::string out{};                            ///< folder of run.keep; "": beside FILE
};

/// Model and run of a studio, shared by its pages. Thread-safe; slow calls (run.load, figures, claims, fan,
/// profile, data.export) do not delay others. Calls throw std::runtime_error, Error or EnvironmentError, and
/// change nothing then.
class LiveRun {
 public:
  LiveRun(Load load, Sinks sinks, LiveOptions options = {});
  ~LiveRun();

  /// Executes a call of the studio's protocol: run.*, data.*, clock, scope.signal, figures, claims, fan,
  /// scene, scene.watch, mechanism, profile, loop.
  json::Json call(int page, const std::string& name, const json::Json& arguments);
  /// Returns the names of all calls.
  static std::vector<std::string> call_names();
  void acknowledge(int page, std::uint32_t sequence);
  /// Removes the views of a page that has left, and resets the inputs that it wrote last.
  void left(int page);

 private:
  using Loaded = std::shared_ptr<LoadedRun>;
  using Call = json::Json (LiveRun::*)(int page, const Arguments& arguments);
  static const std::map<std::string, Call>& calls();

  json::Json load(int page, const Arguments& arguments);
  json::Json play(int page, const Arguments& arguments);
  json::Json pause(int page, const Arguments& arguments);
  json::Json tick(int page, const Arguments& arguments);
  json::Json restart(int page, const Arguments& arguments);
  json::Json seek(int page, const Arguments& arguments);
  json::Json set(int page, const Arguments& arguments);
  json::Json input(int page, const Arguments& arguments);
  json::Json log(int page, const Arguments& arguments);
  json::Json clock(int page, const Arguments& arguments);
  json::Json signal(int page, const Arguments& arguments);
  json::Json want(int page, const Arguments& arguments);
  json::Json statistics(int page, const Arguments& arguments);
  json::Json csv(int page, const Arguments& arguments);
  json::Json figures(int page, const Arguments& arguments);
  json::Json claims(int page, const Arguments& arguments);
  json::Json fan_of(int page, const Arguments& arguments);
  json::Json scene(int page, const Arguments& arguments);
  json::Json mechanism(int page, const Arguments& arguments);
  json::Json watch_scene(int page, const Arguments& arguments);
  json::Json profile(int page, const Arguments& arguments);
  json::Json loop(int page, const Arguments& arguments);
  json::Json keep(int page, const Arguments& arguments);

  /// Throws std::runtime_error if no run is loaded.
  Loaded loaded() const;
  MakeRun run_of(std::uint32_t number);
  Loaded going_loop(const session::LoadedModel& model) const;
  json::Json describe(LoadedRun& run) const;
  void put(Loaded next);
  void heard(int page);
  void refuse_in_loop(const char* what) const;
  json::Json moment(LoadedRun& run) const;
  void wake();
  void publish();
  void publish_now(const Loaded& run, double now);
  void publish_run(const Loaded& run, double now);
  void publish_scene(const Loaded& run, double now);
  void publish_loop(const Loaded& run, bool turned, double now);

  Load load_;
  Sinks sinks_;
  std::optional<session::LoopSettings> loop_;
  std::string out_;
  codegen::GeneratedCode code_{run::code_trial()};
  FrameViews views_;
  mutable std::mutex mutex_;
  Loaded loaded_;
  std::map<int, PageClock> clocks_;
  std::set<int> scene_watchers_;
  std::set<int> gone_;        ///< pages that have left; a late message may still arrive
  bool scene_asked_ = false;  ///< a new page needs the scene
  std::shared_ptr<std::atomic<bool>> fan_interrupt_;
  std::uint32_t runs_ = 0;

  // State of the publisher's thread.
  std::condition_variable changed_;
  std::mutex wake_mutex_;
  bool is_woken_ = false, quits_ = false;
  Loaded scene_of_;  ///< declared before `scene_`, which refers to it
  std::optional<SceneNow> scene_;
  std::jthread judge_;  ///< computes claims
  std::int64_t scene_tick_ = -1;
  std::optional<RunStatus> told_;
  double told_at_ = 0.0, scene_at_ = 0.0, loop_at_ = 0.0;
  std::thread publisher_;  ///< last: uses the other members
};

}  // namespace stepwire::live
