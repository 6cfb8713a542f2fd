#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/studio/live/run_control.hpp"
#include "engine/app/studio/live/signal_list.hpp"

namespace stepwire::live {

/// A column as the page counts them: all signals, then the formulas that were asked for.
struct LiveColumn {
  std::string name;
  std::optional<unit::Dimension> dimension;
  std::string unit;    ///< in which it is shown
  double scale = 1.0;  ///< shown = SI * scale + offset
  double offset = 0.0;
  std::optional<query::Formula> formula{};  ///< none: it is a signal
};

/// A model that was read, and how it is read again from the same texts, with other settings.
struct Loading {
  using Again = std::function<session::LoadedModel(const session::LoadOptions& options)>;
  using Documents = std::function<const yaml::Document&(const std::string& path)>;

  Loading(session::LoadedModel model_read, Again read_again = {}, Documents files = {})
      : model(std::move(model_read)), again(std::move(read_again)), documents(std::move(files)) {}

  session::LoadedModel model;
  Again again;          ///< empty: it cannot be
  Documents documents;  ///< its texts as trees; throws Error for a file that is none of them
};

/// Begins a run of a plan, whose signals are these; both outlive it.
using MakeRun = std::function<std::unique_ptr<RunControl>(const plan::Plan& plan, const SignalList& signals)>;

/// A model and its run, and the columns by which a page calls its signals. From any thread.
class LoadedRun {
 public:
  LoadedRun(Loading loading, const MakeRun& make);

  const session::LoadedModel& model() const { return model_; }
  /// The model with the values that some events have set, for its figures and claims; its own where it cannot
  /// be read again.
  std::shared_ptr<const session::LoadedModel> model_with(const std::vector<LiveEvent>& set);
  const plan::Plan& plan() const { return model_.job.plan; }
  /// The tree of a file's text; nullptr where it is not known. While the run is loaded only.
  const yaml::Document* document(const std::string& path) const;
  const SignalList& signals() const { return signals_; }
  RunControl& thread() { return *thread_; }
  RunStatus status() const { return thread_->status(); }
  const SampleStore& store() const { return thread_->store(); }

  /// The column of a name or an expression, "cart.position in mm". Throws Error where there is something
  /// wrong with it.
  std::size_t find(const std::string& expression);
  /// Throws std::runtime_error where there is none.
  LiveColumn column(std::size_t index) const;
  /// Where its samples are, which are stored from now on at the latest.
  std::size_t stored(std::size_t index);
  std::vector<std::size_t> stored(const std::vector<std::size_t>& columns);

  /// The first tick at or behind a time, 0 to that behind the last sample.
  std::int64_t tick_at(double time) const;

 private:
  session::LoadedModel model_;
  Loading::Again again_;
  Loading::Documents documents_;
  std::mutex again_mutex_;  ///< of the model that was read last, and by which values
  std::map<std::string, std::string> again_values_;
  std::shared_ptr<const session::LoadedModel> again_model_;
  SignalList signals_;
  query::SymbolTable names_;
  std::unique_ptr<RunControl> thread_;
  mutable std::mutex mutex_;
  std::vector<LiveColumn> formulas_;
  std::map<std::string, std::size_t> known_;   ///< columns of expressions
  std::map<std::size_t, std::size_t> stored_;  ///< columns of the store
};

}  // namespace stepwire::live
