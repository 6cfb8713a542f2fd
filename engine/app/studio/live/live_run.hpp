#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
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
#include "engine/app/studio/live/page_clock.hpp"
#include "engine/app/studio/live/scene_now.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::live {

/// Where what pages are to see goes. Called from any thread; must return soon.
struct Sinks {
  std::function<void(json::Json news)> news;               ///< to all pages
  std::function<void(int page, std::string bytes)> frame;  ///< data of one view
};

/// Loads the model of a file by its number, with the texts that its page has; `hand`: with the pointer of a
/// page in the place of who moves the pin in the file. Throws Error.
using Load = std::function<Loading(int file, bool hand)>;

struct LiveOptions {
  std::optional<session::LoopSettings> loop{};  ///< runs are real-time loops with these settings
  std::string out{};                            ///< the folder in which run.keep keeps a run; "": beside FILE
};

/// What runs under the pages of a studio: one model and its run, and what the pages see of it. Calls may come
/// from several threads; those that take long (run.load, figures, claims, fan, profile, data.export) hold up
/// no others. They throw std::runtime_error, Error or EnvironmentError, and change nothing then.
class LiveRun {
 public:
  LiveRun(Load load, Sinks sinks, LiveOptions options = {});
  ~LiveRun();

  /// The calls of the studio's protocol: run.*, data.*, clock, scope.signal, figures, claims, fan, scene,
  /// scene.watch, mechanism, profile, loop.
  json::Json call(int page, const std::string& name, const json::Json& arguments);
  /// The names of all calls.
  static std::vector<std::string> call_names();
  void acknowledge(int page, std::uint32_t sequence);
  /// A page has gone: its views end, and the inputs that it wrote last have their defaults.
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

  /// Throws std::runtime_error where nothing is loaded.
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
  std::set<int> gone_;        ///< pages that have left, of which a last message may still come
  bool scene_asked_ = false;  ///< by a page that has not seen it
  std::shared_ptr<std::atomic<bool>> fan_interrupt_;
  std::uint32_t runs_ = 0;

  // Of the thread that publishes.
  std::condition_variable changed_;
  std::mutex wake_mutex_;
  bool is_woken_ = false, quits_ = false;
  Loaded scene_of_;  ///< before what looks at it
  std::optional<SceneNow> scene_;
  std::jthread judge_;  ///< of claims
  std::int64_t scene_tick_ = -1;
  std::optional<RunStatus> told_;
  double told_at_ = 0.0, scene_at_ = 0.0, loop_at_ = 0.0;
  std::thread publisher_;  ///< last: it uses the others
};

}  // namespace stepwire::live
