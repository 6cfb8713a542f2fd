#include "engine/app/cli/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "engine/analyse/coverage/coverage.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/kept_inputs.hpp"
#include "engine/app/cli/monitoring.hpp"
#include "engine/app/cli/run_call.hpp"
#include "engine/app/report/coverage_picture.hpp"
#include "engine/app/report/fit_text.hpp"
#include "engine/app/report/junit_suites.hpp"
#include "engine/app/report/profile_report.hpp"
#include "engine/app/report/run_text.hpp"
#include "engine/app/report/study_text.hpp"
#include "engine/app/report/tune_text.hpp"
#include "engine/app/session/partial_signals.hpp"
#include "engine/app/session/run_files.hpp"
#include "engine/app/session/run_result.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::cli {

using json::Json;

namespace {

/// Returns the result of a run with its claims, as --json has it.
Json run_json(const session::LoadedModel& model, const session::Outcome& outcome) {
  return result::json_of(session::RunReport{&model, &outcome})
      .set("claims", result::json_of(session::judged_claims(model, outcome)));
}

void require_section(const RunCall& call, const session::LoadedModel& model) {
  const auto refuse = [&](const char* message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, "", message, {}});
  };
  if (call.requires_section == "fit" && !model.fit)
    refuse("has no section 'fit'; it names parameters and records");
  if (call.requires_section == "tune" && !model.tune)
    refuse("has no section 'tune'; it names parameters and what is minimised");
  if (call.requires_section == "study" && !model.study)
    refuse("has no section 'study'; it names task, people and conditions");
}

/// Refuses --csv unless the model has exactly one recorded table.
void require_one_table(const RunCall& call, const session::LoadedModel& model) {
  if (call.csv.empty()) return;
  const auto refuse = [&](const std::string& message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, "", message, {}});
  };
  const std::size_t count = model.job.plan.diagram.records.size();
  if (count == 0) refuse("records nothing, and --csv is a table of what is recorded");
  if (model.study)
    refuse("has a section 'study', whose trials are no single table; --out has files for them");
  if (count != 1)
    refuse(fmt::format(
        "records at {} periods, which --csv, a single table, has no place for; --out has a file for each",
        count));
}

/// Refuses --part and --mpi for a model that cannot be shared, or without a folder for the journal. A share
/// is always a part of a sweep.
void require_shares(const RunCall& call, const session::LoadedModel& model) {
  if (!call.part && !call.mpi) return;
  const auto refuse = [&](const char* message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, call.part ? "--part" : "--mpi", message, {}});
  };
  const bool sweeps = !model.job.points.empty();
  if (call.part && (!sweeps || model.study))
    refuse("needs a file with a section 'sweep', and without a study");
  if (!sweeps && !model.study && !model.fit && call.requires_section.empty())
    refuse("needs a file with a section 'sweep', 'study' or 'fit', whose runs processes can share");
  if (call.out.empty() || call.archive) refuse("needs --out DIR, in which what is done is kept");
}

/// Refuses --coverage for runs that other processes make, and for a study, whose trials are not observed.
void require_observable(const RunCall& call, const session::LoadedModel& model) {
  if (call.coverage && (call.part || call.mpi || model.study))
    throw yaml::Error(yaml::Fault{
        {model.file, {}}, "--coverage", "is of the runs of one process, without a study; leave it out", {}});
}

/// Refuses --device gpu for runs that no GPU makes: those of other processes, single ones, and trials.
void require_device(const RunCall& call, const session::LoadedModel& model) {
  if (call.device == device::DeviceUse::cpu) return;
  const auto refuse = [&](const char* message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, "--device", message, {}});
  };
  if (call.mpi) refuse("is of the runs of one process, and --mpi has several; leave one of them out");
  if (model.study) refuse("is for a sweep; the trials of a study run on the processor");
  if (model.job.points.empty())
    refuse("is for a sweep, and the file has none; a single run is on the processor");
}

/// Refuses a missing folder before the run rather than after it.
void require_place(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (!folder.empty()) io::require_folder(folder.string());
}

/// Refuses a model that does not fit the options of a call, before the first step. Throws Error and
/// EnvironmentError.
void require_fitting(const RunCall& call, const session::LoadedModel& model) {
  require_section(call, model);
  require_one_table(call, model);
  require_shares(call, model);
  require_observable(call, model);
  require_device(call, model);
  require_place(call.csv);
}

std::string file_name(const session::LoadedModel& model) {
  return std::filesystem::path(model.file).filename().string();
}

/// Scope guard for following a journal; ends the following even after an exception.
class Followed {
 public:
  explicit Followed(journal::Journal& journal) : journal_(journal) { journal_.follow(); }
  ~Followed() { journal_.end_following(); }
  Followed(const Followed&) = delete;
  Followed& operator=(const Followed&) = delete;

 private:
  journal::Journal& journal_;
};

/// Runs the points that a journal misses: on threads of this process, or by other processes.
using PointsRunner = std::function<session::PointsReport(session::KeptPoints&)>;

/// Sweep with a journal in its folder. After an interruption or a kill, the same call continues it.
class KeptRun {
 public:
  /// Opens the journal and reports the points of an earlier call. Throws EnvironmentError.
  KeptRun(const session::LoadedModel& model, const session::RowUse& use, const session::Share& share = {})
      : model_(model), use_(use), share_(share), kept_(model, use.folder, share) {
    if (kept_.found() > 0)
      complain("{}: {} of {} points are there from an earlier call\n", use_.folder, kept_.found(),
               kept_.points());
  }

  /// Runs the missing points and joins all points.
  session::Outcome run(const PointsRunner& runner) {
    std::packaged_task<session::Outcome()> task(
        [&] { return session::joined_points(model_, {&kept_.journal()}, use_, &kept_); });
    const std::function<void()> join = [&] { task(); };
    std::vector<std::jthread> writer;
    const Followed followed(kept_.journal());
    // Writes runs during the sweep if their files allow it. Otherwise the join needs all rows at once, and
    // waits for the end to save memory.
    if (session::goes_run_by_run(model_, use_)) writer = parallel::begin_threads(2, join);
    const session::PointsReport report = runner(kept_);
    kept_.journal().end_following();
    if (writer.empty()) join();
    session::Outcome outcome = task.get_future().get();
    outcome.seconds = report.seconds;
    outcome.result.lanes = report.lanes;
    if (outcome.result.interrupted) note_interrupted();
    return outcome;
  }

  /// Runs the missing points of a share, and prints how to collect the shares.
  ExitCode run_share(const PointsRunner& runner) {
    runner(kept_);
    kept_.journal().flush();
    if (interrupted() || kept_.kept() < kept_.points()) {
      note_interrupted();
      return ExitCode::interrupted;
    }
    say("{}: share {} of {}, {} of {} points; when all shares are there: stepwire collect DIR... --out DIR\n",
        use_.folder, share_.number, share_.count, kept_.points(), model_.job.points.size());
    return ExitCode::done;
  }

  /// Removes the journal, after the results are written.
  void drop() { std::filesystem::remove(session::points_path(use_.folder)); }

 private:
  void note_interrupted() {
    complain("{}: {} of {} points are kept; the same call goes on\n", use_.folder, kept_.kept(),
             kept_.points());
  }

  const session::LoadedModel& model_;
  const session::RowUse use_;
  const session::Share share_;
  session::KeptPoints kept_;
};

/// Run of one file.
class FileRun {
 public:
  FileRun(const RunCall& call, session::Session& session, MpiRun* mpi)
      : call_(call), session_(session), mpi_(mpi) {}

  ExitCode carry_out(session::LoadedModel& model, Json& results) {
    require_fitting(call_, model);
    const EndDelay delay(EndDelay::Signals::first);
    render::require_converter(call_.pictures);
    keep_inputs(call_.csv == standard_output ? "" : call_.csv, replay::files_read(model.job));
    const std::string folder = folder_of(call_, model.file);
    use_ = {folder, session::files_for(model, call_.files), !call_.csv.empty()};
    if (!folder.empty() && !call_.files && use_.files != session::usual_files)
      complain("{}: more than {:.0f} million numbers, so signals.h5 is written, and no csv or mat\n",
               model.file, session::most_numbers_of_csv * 1e-6);
    if (!call_.part) session::require_rows(model, use_);
    const auto owned = session::own_results(folder, model, use_.files);
    if (!mpi_) return carry_out(model, folder, results);
    try {
      const ExitCode code = carry_out(model, folder, results);
      if (code != ExitCode::interrupted) mpi_->drop();
      return code;
    } catch (const std::exception&) {
      mpi_->say_deaths();
      if (interrupted()) mpi_->say_kept();
      throw;
    }
  }

 private:
  ExitCode carry_out(session::LoadedModel& model, const std::string& folder, Json& results) {
    if (call_.part) return run_share(model);
    const ExitCode fitted = model.fit ? fit(model, folder, results) : ExitCode::done;
    if (ends(fitted)) return fitted;
    const bool tunes = call_.requires_section == "tune";
    const ExitCode tuned = tunes ? tune(model, folder, results) : ExitCode::done;
    if (ends(tuned)) return tuned;
    const ExitCode done = model.study ? study(model, folder, results) : run(model, folder, results);
    return worst(worst(fitted, tuned), done);
  }

  /// True for a search whose result cannot be run. One without convergence can.
  static bool ends(ExitCode search) { return search != ExitCode::done && search != ExitCode::fails; }

  ExitCode run_share(const session::LoadedModel& model) {
    KeptRun kept(model, use_, *call_.part);
    const auto watch = watched(file_name(model));
    return kept.run_share(runner_of(model));
  }

  PointsRunner runner_of(const session::LoadedModel& model) {
    return [&](session::KeptPoints& points) {
      return mpi_ ? mpi_->run(points, model, session_.monitor())
                  : session_.run(model, points, call_.engine, call_.models.threads);
    };
  }

  /// Returns the other processes as workers for a job; nullptr without MPI.
  messages::ItemWorkers* others(cluster::SharedJob::Kind kind, const session::LoadedModel& model,
                                const std::string& folder, const std::string& follows_from,
                                std::size_t most) {
    if (!mpi_) return nullptr;
    return &mpi_->workers(job_of(kind, model), folder, follows_from, most, session_.monitor());
  }

  /// Optimises the parameters of the section `tune`, prints them, and reloads the model with them.
  ExitCode tune(session::LoadedModel& model, const std::string& folder, Json& results) {
    session::TuneCall call = call_.tune;
    call.engine = call_.engine;
    call.workers = others(cluster::SharedJob::Kind::tune, model, folder, session::tune_key(model, call),
                          session::most_searches(model, call));
    const tuning::TuneResult result = [&] {
      const auto watch = watched("tune " + file_name(model));
      return session_.tune(model, call);
    }();
    if (!folder.empty() && !result.history.empty()) session::write_tune(folder, model, result);
    const ExitCode code = worst(code_of(result), call_.models.code_of_notes(!result.findings.empty()));
    if (call_.models.json)
      results.push(Json::object().set("tune", result::json_of(result)));
    else
      put_report(report::tune_text(result), code != ExitCode::done);
    if (!ends(code)) model = session_.tuned(model, result);
    return code;
  }

  /// Estimates the parameters of the section `fit`, prints them, and reloads the model with them.
  ExitCode fit(session::LoadedModel& model, const std::string& folder, Json& results) {
    session::FitCall call = call_.fit;
    call.engine = call_.engine;
    call.workers = others(cluster::SharedJob::Kind::fit, model, folder, session::fit_key(model, call),
                          session::most_searches(model, call));
    const estimation::FitResult result = [&] {
      const auto watch = watched("fit " + file_name(model));
      return session_.fit(model, call);
    }();
    if (!folder.empty() && !result.records.empty()) session::write_fit(folder, model, result);
    const ExitCode code = worst(code_of(result), call_.models.code_of_notes(!result.findings.empty()));
    if (call_.models.json)
      results.push(Json::object().set("fit", result::json_of(result)));
    else
      put_report(report::fit_text(result), code != ExitCode::done);
    if (!ends(code)) model = session_.fitted(model, result);
    return code;
  }

  /// Adds the claims of a run to the report of --junit.
  void add_suite(const session::LoadedModel& model, const session::Outcome& outcome) {
    if (call_.suites) call_.suites->push_back(report::suite_of(model, outcome));
  }

  ExitCode run(const session::LoadedModel& model, const std::string& folder, Json& results) {
    // Written before the run, during which data files may change.
    if (!folder.empty()) replay::write_replay(folder, model.job);
    const session::Outcome outcome = written_run(model, folder);
    add_suite(model, outcome);
    const std::optional<profile::Profile> profile = wanted_profile(model);
    if (profile && !folder.empty()) write_profile(folder, model, *profile);
    if (call_.models.json) {
      Json result = run_json(model, outcome);
      if (profile) result.set("profile", result::json_of(report::ProfileReport{*profile}));
      put_coverage(model, folder, &result);
      results.push(std::move(result));
      return judged(model, outcome);
    }
    if (call_.models.units) put_text(report::units_text(model.job.plan));
    put_outcome(model, outcome);
    if (profile) put_text(report::profile_text(model, *profile));
    put_coverage(model, folder, nullptr);
    say_where(folder);
    return judged(model, outcome);
  }

  /// Returns the exit code of a run, with --strict also by its notes.
  ExitCode judged(const session::LoadedModel& model, const session::Outcome& outcome,
                  bool remarked = false) const {
    const bool noted =
        remarked || !outcome.result.diagnostics.empty() || !session::findings_of(model, outcome).empty();
    return worst(code_of(outcome), call_.models.code_of_notes(noted));
  }

  /// Returns the observers of the runs: that of the branches, and that of the rows.
  std::vector<run::RunObserver*> observers_of(session::PartialSignals* partial) {
    std::vector<run::RunObserver*> observers;
    if (partial) observers.push_back(partial);
    if (coverage_) observers.push_back(&*coverage_);
    return observers;
  }

  /// Writes the branches as JSON and as a drawing, which a missing program leaves out.
  void write_coverage(const std::string& folder, const session::LoadedModel& model,
                      const coverage::Coverage& coverage) const {
    io::write_file(folder + "/coverage.json", result::json_of(coverage).text() + "\n");
    try {
      io::write_file(folder + "/coverage.svg",
                     report::coverage_picture(session_.registry(), model.file, coverage));
    } catch (const io::EnvironmentError& error) {
      complain("{}: there is no coverage.svg: {}\n", folder, error.what());
    }
  }

  /// Adds the branches that the runs took to the result, the report and the folder.
  void put_coverage(const session::LoadedModel& model, const std::string& folder, Json* result) {
    if (!coverage_) return;
    coverage::Coverage coverage = coverage_->coverage();
    coverage.file = model.file;
    if (!folder.empty()) write_coverage(folder, model, coverage);
    if (result)
      result->set("coverage", result::json_of(coverage));
    else
      put_text(coverage::coverage_text(coverage));
  }

  session::Outcome written_run(const session::LoadedModel& model, const std::string& folder) {
    const auto partial = partial_signals(folder, model);
    if (call_.coverage) coverage_.emplace();
    std::optional<KeptRun> kept;
    if (!folder.empty() && !model.job.points.empty()) kept.emplace(model, use_);
    session::Outcome outcome = [&] {
      const auto watch = watched(file_name(model));
      session_.monitor().observers = observers_of(partial.get());
      if (kept) return kept->run(runner_of(model));
      if (session::goes_run_by_run(model, use_))
        return session_.pass(model, call_.engine, call_.models.threads);
      return session_.run(model, call_.engine, call_.models.threads);
    }();
    session_.monitor().observers.clear();
    print_faults(outcome.result);
    if (const auto left = session::csv_left_out(outcome.result.recordings, use_.files);
        !folder.empty() && !left.empty())
      complain("{}: {}\n", folder, left);
    if (!folder.empty()) session::write_outputs(folder, model, outcome, use_.files, call_.pictures);
    if (partial) partial->remove();
    if (kept && !outcome.result.interrupted) kept->drop();
    if (!call_.csv.empty()) put_csv(outcome);
    return outcome;
  }

  /// Returns the writer of rows that survive a killed run; nullptr if no folder or no HDF5 file is written,
  /// or in a sweep.
  std::unique_ptr<session::PartialSignals> partial_signals(const std::string& folder,
                                                           const session::LoadedModel& model) const {
    const bool kept = std::ranges::find(use_.files, session::FileKind::h5) != use_.files.end();
    if (folder.empty() || !kept || !model.job.points.empty()) return nullptr;
    return std::make_unique<session::PartialSignals>(folder, model);
  }

  void put_csv(const session::Outcome& outcome) const {
    const std::string text = session::signals_csv(outcome.result.recordings.front());
    if (call_.csv == standard_output) return put_data(text);
    io::write_file(call_.csv, text);
  }

  void say_where(const std::string& folder) const {
    if (!folder.empty() && !call_.archive) say("  written to {}\n", folder);
  }

  /// Returns a progress bar for the session's next operation, shown during its lifetime.
  std::unique_ptr<Progress> watched(const std::string& label) {
    auto progress = std::make_unique<Progress>(label);
    session_.monitor() = terminal_monitor(progress.get());
    return progress;
  }

  /// Measures the costs in a separate run, so that the recorded run is not disturbed.
  std::optional<profile::Profile> wanted_profile(const session::LoadedModel& model) const {
    if (!call_.profile || interrupted()) return std::nullopt;
    return report::profile_of(model, &interrupted());
  }

  void write_profile(const std::string& folder, const session::LoadedModel& model,
                     const profile::Profile& profile) const {
    io::write_file(folder + "/profile.csv", report::profile_csv(profile));
    render::write_figure(folder, "profile", report::profile_figure(model, profile), {}, call_.pictures);
  }

  session::Studies::Shared perform(const session::LoadedModel& model, const std::string& folder) {
    session::StudyCall call{call_.engine, call_.models.threads, folder};
    call.workers = others(cluster::SharedJob::Kind::study, model, folder, session::study_items_key(model),
                          session::most_items(model));
    const auto watch = watched("study " + file_name(model));
    return session_.study(model, call);
  }

  /// Runs the study of the section `study` instead of a single run.
  ExitCode study(session::LoadedModel& model, const std::string& folder, Json& results) {
    const session::Studies::Shared experiments = perform(model, folder);
    const session::Outcome outcome = session::study_outcome(model, *experiments);
    if (outcome.result.interrupted) {  // an unfinished experiment leaves no results
      if (!folder.empty() && model.study->experiments > 1)
        say("the experiments that are done are kept in {}; the same call goes on\n", folder);
      return ExitCode::interrupted;
    }
    add_suite(model, outcome);
    if (!folder.empty()) {
      session::write_outputs(folder, model, outcome, use_.files, call_.pictures);
      session::write_study(folder, model, *experiments, outcome);
    }
    const bool remarked =
        std::ranges::any_of(*experiments, [](const auto& one) { return !one.remarks.empty(); });
    if (call_.models.json) {
      Json result = run_json(model, outcome);
      results.push(result.set("study", result::json_of(session::StudyReport{&model, experiments.get()})));
      return judged(model, outcome, remarked);
    }
    put_text(report::study_text(model, *experiments));
    put_outcome(model, outcome);
    say_where(folder);
    return judged(model, outcome, remarked);
  }

  const RunCall& call_;
  session::Session& session_;
  MpiRun* const mpi_;
  session::RowUse use_;
  std::optional<coverage::CoverageObserver> coverage_;  ///< Of --coverage.
};

}  // namespace

void put_outcome(const session::LoadedModel& model, const session::Outcome& outcome) {
  if (console_style().quiet) return put_failure(report::failures_text(outcome, model.file));
  put_text(report::outcome_text(model, outcome));
}

std::string folder_of(const RunCall& call, const std::string& file) {
  if (call.out.empty() || (call.models.files.size() == 1 && !call.archive)) return call.out;
  return (std::filesystem::path(call.out) / std::filesystem::path(file).stem()).string();
}

ExitCode run_file(const RunCall& call, session::Session& session, session::LoadedModel& model, Json& results,
                  MpiRun* mpi) {
  return FileRun(call, session, mpi).carry_out(model, results);
}

}  // namespace stepwire::cli
