// Changes diagrams as their files here say, and looks which claims fail by it.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "blocks/register.hpp"
#include "engine/app/session/fitting.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/diagrams/broken/changes.hpp"

using namespace stepwire;
namespace fs = std::filesystem;

namespace {

/// A copy of the diagrams in which texts may be replaced.
class Copy {
 public:
  Copy() : folder_(fs::temp_directory_path() / fmt::format("stepwire-broken-{}", ::getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    for (const char* folder : {"thesis", "examples", "parts"})
      fs::copy(fs::path(STEPWIRE_SOURCE_DIR) / "diagrams" / folder, folder_ / folder,
               fs::copy_options::recursive);
  }
  ~Copy() { fs::remove_all(folder_); }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;

  /// `name` begins with a folder, as "thesis/".
  std::string file(const std::string& name) const { return folder_ / name; }

  /// Replaces texts, each of which occurs once, and returns what the file had before.
  std::string replace(const std::string& file, const broken::Texts& replaced) const {
    const std::string before = io::read_file(file);
    std::string text = before;
    for (const auto& [old, other] : replaced) {
      const std::size_t at = text.find(old);
      if (at == std::string::npos) throw std::runtime_error(fmt::format("'{}' is not in {}", old, file));
      if (text.find(old, at + 1) != std::string::npos)
        throw std::runtime_error(fmt::format("'{}' is in {} more than once", old, file));
      text.replace(at, old.size(), other);
    }
    io::write_file(file, text);
    return before;
  }

 private:
  fs::path folder_;
};

/// Runs, fits and makes studies as the gallery does.
class Runner {
 public:
  std::vector<claim::Verdict> verdicts(const std::string& file,
                                       const std::vector<diagram::Setting>& settings) {
    session::LoadOptions options;
    options.settings = settings;
    session::LoadedModel model = session::load_model(registry_, file, options);
    const auto& sweep = model.job.plan.diagram.sweep;
    takes_long_ = model.study || model.fit || (sweep && sweep->design);
    if (model.study) {
      const auto experiments = studies_.experiments(registry_, model, {}, {});
      return session::study_outcome(model, *experiments).verdicts;
    }
    if (model.fit) {
      const estimation::FitResult fit = session::fit_model(registry_, model, {}, {});
      model = session::load_model(registry_, file, session::with_fitted(options, fit));
    }
    parameters_ = model.job.plan.diagram.parameters;
    swept_.clear();
    if (model.job.plan.diagram.sweep)
      for (const diagram::Sweep::Axis& axis : model.job.plan.diagram.sweep->axes)
        swept_.insert(axis.parameter);
    run::RunOptions run;
    run.engine = run::ExecutionMode::automatic;
    run.code = &code_;
    const session::Outcome outcome = session::run_model(model, run);
    if (!outcome.result.faults.empty()) throw yaml::Error(outcome.result.faults.front().fault);
    return outcome.verdicts;
  }

  bool takes_long() const { return takes_long_; }
  const std::vector<diagram::DiagramParameter>& parameters() const { return parameters_; }
  bool sweeps(const std::string& parameter) const { return swept_.contains(parameter); }

 private:
  const Registry registry_ = blocks();
  codegen::GeneratedCode code_{run::code_trial()};
  session::Studies studies_;
  bool takes_long_ = false;
  std::vector<diagram::DiagramParameter> parameters_;
  std::set<std::string> swept_;
};

bool is_statement(const claim::Verdict& verdict) {
  return verdict.kind == claim::Claim::Kind::statement;
}

/// Twice the value of a parameter as a setting; empty where that is the same, or no number.
std::string doubled(const diagram::DiagramParameter& parameter) {
  const std::string& text = parameter.text;
  if (const double* number = std::get_if<double>(&parameter.value.content))
    return *number == 0.0 ? "" : fmt::format("= 2*({})", text.starts_with("=") ? text.substr(1) : text);
  const bool formula =
      text.find_first_of("+-*/(") != std::string::npos && text.find('[') == std::string::npos;
  return formula && !parameter.text.starts_with("\"") ? fmt::format("2*({})", text) : "";
}

/// One diagram with its changes; prints what is not as it should be.
class Check {
 public:
  Check(Runner& runner, const std::string& file) : runner_(runner), broken_(broken::read_broken(file)) {
    const std::string stem = fs::path(file).stem().string() + "-";
    for (const char* folder : {"thesis", "examples"})
      for (const auto& entry : fs::directory_iterator(copy_.file(folder)))
        if (entry.path().extension() == ".yaml" && entry.path().filename().string().starts_with(stem))
          name_ = folder / entry.path().filename();
    if (name_.empty())
      throw std::runtime_error(fmt::format("no diagram file of thesis or examples begins with {}", stem));
    copy_.replace(copy_.file(name_), broken_.always);
  }

  /// The number of faults found.
  int run() {
    as_it_is();
    for (const broken::Change& change : broken_.changes) {
      try {
        try_change(change);
      } catch (const std::exception& error) {
        fault(fmt::format("{}: {}", change.what, error.what()));
      }
    }
    for (const std::string& claim : unbroken_) fault(fmt::format("no change breaks the claim '{}'", claim));
    if (!runner_.takes_long()) double_parameters();
    fmt::print("{}: {} claims, {} changes, {} parameters doubled, {} of them without effect: {}\n", name_,
               claims_, broken_.changes.size(), doubled_, broken_.unmoved.size(),
               faults_ == 0 ? "ok" : fmt::format("{} faults", faults_));
    return faults_;
  }

 private:
  void fault(const std::string& text) {
    ++faults_;
    fmt::print("{}: {}\n", name_, text);
    std::fflush(stdout);
  }

  void as_it_is() {
    for (const claim::Verdict& verdict : runner_.verdicts(copy_.file(name_), {})) {
      if (verdict.fails()) fault(fmt::format("fails as it is: {} ({})", verdict.that, verdict.shown));
      if (!is_statement(verdict)) continue;
      ++claims_;
      if (verdict.disagrees.empty()) unbroken_.insert(verdict.that);
    }
    parameters_ = runner_.parameters();
    std::erase_if(parameters_, [&](const diagram::DiagramParameter& one) {
      return runner_.sweeps(one.name) || one.name.find('.') != std::string::npos;  // that of a part
    });
  }

  void try_change(const broken::Change& change) {
    const std::string changed =
        change.in.empty()
            ? copy_.file(name_)
            : (fs::path(copy_.file(name_)).parent_path() / change.in).lexically_normal().string();
    const std::string before = copy_.replace(changed, change.replaced);
    std::vector<claim::Verdict> verdicts;
    try {
      verdicts = runner_.verdicts(copy_.file(name_), change.settings);
    } catch (...) {
      io::write_file(changed, before);
      throw;
    }
    io::write_file(changed, before);
    for (const std::string& words : change.fails) expect_failure(change, words, verdicts);
  }

  void expect_failure(const broken::Change& change, const std::string& words,
                      const std::vector<claim::Verdict>& verdicts) {
    const auto named = [&](const claim::Verdict& verdict) {
      return is_statement(verdict) && verdict.that.starts_with(words);
    };
    const auto count = std::ranges::count_if(verdicts, named);
    if (count != 1) return fault(fmt::format("{}: {} claims begin with '{}'", change.what, count, words));
    const claim::Verdict& verdict = *std::ranges::find_if(verdicts, named);
    if (verdict.holds)
      fault(fmt::format("{}: holds all the same: {}: {} ({})", change.what, verdict.that, verdict.shown,
                        verdict.check));
    unbroken_.erase(verdict.that);
  }

  void double_parameters() {
    const auto parameters = parameters_;
    for (const diagram::DiagramParameter& parameter : parameters) {
      const std::string value = doubled(parameter);
      if (value.empty()) continue;
      ++doubled_;
      const bool listed = std::ranges::any_of(broken_.unmoved, [&](const auto& one) {
        return one.first == parameter.name && !one.second.empty();
      });
      const bool breaks = breaks_a_claim({parameter.name, value});
      if (!breaks && !listed) fault(fmt::format("doubling '{}' breaks no claim", parameter.name));
      if (breaks && listed)
        fault(fmt::format("doubling '{}' breaks a claim; take it out of 'unmoved'", parameter.name));
    }
    for (const auto& [name, why] : broken_.unmoved)
      if (std::ranges::none_of(parameters,
                               [&](const diagram::DiagramParameter& one) { return one.name == name; }))
        fault(fmt::format("unmoved: there is no parameter '{}' that can be doubled", name));
  }

  /// Or is the value refused, or the run ended by it?
  bool breaks_a_claim(const diagram::Setting& setting) {
    try {
      return std::ranges::any_of(runner_.verdicts(copy_.file(name_), {setting}), &claim::Verdict::fails);
    } catch (const yaml::Error&) {
      return true;
    }
  }

  Runner& runner_;
  broken::Broken broken_;
  Copy copy_;
  std::string name_;  // with its folder
  std::vector<diagram::DiagramParameter> parameters_;
  std::set<std::string> unbroken_;
  std::size_t claims_ = 0, doubled_ = 0;
  int faults_ = 0;
};

}  // namespace

int main(int count, char** arguments) {
  Runner runner;
  int faults = 0;
  for (int i = 1; i < count; ++i) {
    try {
      faults += Check(runner, arguments[i]).run();
    } catch (const std::exception& error) {
      fmt::print("{}: {}\n", arguments[i], error.what());
      ++faults;
    }
  }
  return faults == 0 ? 0 : 1;
}
