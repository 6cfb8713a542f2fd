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

/// Column by its index at the page: all signals first, then the requested formulas.
struct LiveColumn {
  std::string name;
  std::optional<unit::Dimension> dimension;
  std::string unit;    ///< display unit
  double scale = 1.0;  ///< shown = SI * scale + offset
  double offset = 0.0;
  std::optional<query::Formula> formula{};  ///< std::nullopt for a signal
};

/// Model that was loaded, with functions that load it again from the same texts.
struct Loading {
  using Again = std::function<session::LoadedModel(const session::LoadOptions& options)>;
  using Documents = std::function<const yaml::Document&(const std::string& path)>;

  Loading(session::LoadedModel model_read, Again read_again = {}, Documents files = {})
      : model(std::move(model_read)), again(std::move(read_again)), documents(std::move(files)) {}

  session::LoadedModel model;
  Again again;          ///< empty if it cannot be loaded again
  Documents documents;  ///< returns the tree of a text; throws Error for an unknown file
};

/// Function that starts a run of a plan. Plan and signals outlive the run.
using MakeRun = std::function<std::unique_ptr<RunControl>(const plan::Plan& plan, const SignalList& signals)>;

/// Model, its run, and the columns by which a page refers to signals. Thread-safe.
class LoadedRun {
 public:
  LoadedRun(Loading loading, const MakeRun& make);

  const session::LoadedModel& model() const { return model_; }
  /// Returns the model with the values of the events, for its figures and claims; model() if it cannot be
  /// loaded again.
  std::shared_ptr<const session::LoadedModel> model_with(const std::vector<LiveEvent>& set);
  const plan::Plan& plan() const { return model_.job.plan; }
  /// Returns the tree of a file's text; nullptr if unknown. Valid while the run is loaded.
  const yaml::Document* document(const std::string& path) const;
  const SignalList& signals() const { return signals_; }
  RunControl& thread() { return *thread_; }
  RunStatus status() const { return thread_->status(); }
  const SampleStore& store() const { return thread_->store(); }

  /// Returns the column of a name or an expression, such as "cart.position in mm". Throws Error for a faulty
  /// one.
  std::size_t find(const std::string& expression);
  /// Throws std::runtime_error for an unknown index.
  LiveColumn column(std::size_t index) const;
  /// Returns the column of the store with its samples, and starts storing them if needed.
  std::size_t stored(std::size_t index);
  std::vector<std::size_t> stored(const std::vector<std::size_t>& columns);

  /// Returns the first tick at or after a time, from 0 to the end of the samples.
  std::int64_t tick_at(double time) const;

 private:
  session::LoadedModel model_;
  Loading::Again again_;
  Loading::Documents documents_;
  std::mutex again_mutex_;  ///< guards the cache of model_with()
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
