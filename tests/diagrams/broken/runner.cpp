#include "tests/diagrams/broken/runner.hpp"

#include <algorithm>
#include <utility>

#include "engine/app/session/fitting.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "tests/diagrams/drawn_texts.hpp"

namespace stepwire::broken {

namespace {

bool is_of_claim(const yaml::Fault& fault) {
  return fault.subject.starts_with("claims") || fault.subject.starts_with("invariants");
}

bool is_behind(const yaml::Mark& mark, const yaml::Mark& other) {
  return std::pair(mark.line, mark.column) >= std::pair(other.line, other.column);
}

bool reads_pictures(const claim::Claim& claim) {
  return claim.check.find("figure.") != std::string::npos;
}

/// A claim that cannot be read fails, and nothing is known of the others, which count as holding.
std::vector<claim::Verdict> unread_claims(const std::vector<claim::Claim>& claims,
                                          const std::vector<yaml::Fault>& faults) {
  std::vector<claim::Verdict> verdicts;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const auto inside = [&](const yaml::Fault& fault) {
      return is_behind(fault.place.mark, claims[i].place.mark) &&
             (i + 1 == claims.size() || !is_behind(fault.place.mark, claims[i + 1].place.mark));
    };
    claim::Verdict verdict;
    verdict.kind = claims[i].kind;
    verdict.that = claims[i].that;
    verdict.holds = std::ranges::none_of(faults, inside);
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

}  // namespace

std::vector<claim::Verdict> Runner::verdicts(const std::string& file,
                                             const std::vector<diagram::Setting>& settings) {
  session::LoadOptions options;
  options.settings = settings;
  model_ = session::load_model(registry_, file, options);
  const auto& sweep = model_->job.plan.diagram.sweep;
  takes_long_ = model_->study || model_->fit || (sweep && sweep->design);
  swept_.clear();
  if (sweep)
    for (const diagram::Sweep::Axis& axis : sweep->axes) swept_.insert(axis.parameter);
  if (model_->study) {
    outcome_ = session::study_outcome(*model_, *studies_.experiments(registry_, *model_, {}, {}));
    return outcome_.verdicts;
  }
  if (model_->fit) {
    const estimation::FitResult fit = session::fit_model(registry_, *model_, {}, {});
    model_ = session::load_model(registry_, file, session::with_fitted(options, fit));
  }
  run();
  return outcome_.verdicts;
}

void Runner::run() {
  run::RunOptions options;
  options.engine = run::ExecutionMode::automatic;
  options.code = &code_;
  outcome_ = session::run_model(*model_, options);
  if (!outcome_.result.faults.empty()) throw yaml::Error(outcome_.result.faults.front().fault);
}

session::LoadedModel Runner::loaded_with(const yaml::Node& figure) const {
  session::LoadOptions options = model_->options;
  options.figure = figure;
  return session::load_model(registry_, model_->file, options);
}

std::vector<claim::Verdict> Runner::verdicts_with(const yaml::Node& figure) {
  try {
    session::LoadedModel model = loaded_with(figure);
    std::erase_if(model.claims, [](const claim::Claim& claim) { return !reads_pictures(claim); });
    session::judge_again(model, outcome_);
    return outcome_.verdicts;
  } catch (const yaml::Error& error) {
    if (!std::ranges::all_of(error.faults(), is_of_claim)) throw;
    return unread_claims(model_->claims, error.faults());
  }
}

bool Runner::has_wrong_texts(const yaml::Node& figure) const {
  return !text_faults(loaded_with(figure)).empty();
}

std::string Runner::picture_with(const yaml::Node& figure, std::size_t picture) {
  const session::LoadedModel model = loaded_with(figure);
  return plot::figure_json(plot::figure_spec(model.figures.at(picture), outcome_.recordings())).text(-1);
}

}  // namespace stepwire::broken
