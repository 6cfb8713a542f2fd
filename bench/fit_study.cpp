// Repeats the fit of a file with different noise and counts how often its intervals hold the truth:
//   fit_study FILE [--seeds 100] [--parameter seed] NAME=TRUTH...
// NAME is a parameter that the file fits. TRUTH is its true value in the file's notation ("model.beta=10.614
// 1/mm"). Each repetition sets the file's parameter `seed` to 1, 2, ... Exit status 1: a 95 % interval holds
// the truth in less than 90 or more than 99 of 100 repetitions. Exit status 2: wrong call or file.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "blocks/register.hpp"
#include "engine/analyse/estimation/fit.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire {

namespace {

struct Call {
  std::string file, seed = "seed";
  int repetitions = 100;
  std::map<std::string, double> truth;  ///< True values in SI.
};

double number_of(const std::string& text) {
  const auto quantity = unit::parse_quantity(text);
  if (!quantity) throw std::invalid_argument(fmt::format("'{}' is no number with a unit", text));
  return quantity->value;
}

Call call_of(int count, char** words) {
  Call call;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const std::size_t equals = word.find('=');
    if (word == "--seeds" && i + 1 < count)
      call.repetitions = std::atoi(words[++i]);
    else if (word == "--parameter" && i + 1 < count)
      call.seed = words[++i];
    else if (equals != std::string::npos)
      call.truth[word.substr(0, equals)] = number_of(word.substr(equals + 1));
    else
      call.file = word;
  }
  if (call.file.empty() || call.truth.empty() || call.repetitions < 1)
    throw std::invalid_argument("fit_study FILE [--seeds 100] [--parameter seed] NAME=TRUTH...");
  return call;
}

/// Statistics of one fitted number over the repetitions.
struct Tally {
  int fits = 0, held = 0;
  double sum = 0.0, squares = 0.0, errors = 0.0;

  void add(const estimation::FittedNumber& number, double truth) {
    const double error = number.value - truth;
    ++fits;
    held += number.low <= truth && truth <= number.high;
    sum += error;
    squares += error * error;
    errors += number.standard_error;
  }
  double share() const { return 100.0 * held / fits; }
};

std::map<std::string, Tally> tallies_of(const Call& call) {
  const Registry registry = blocks();
  codegen::GeneratedCode code{run::code_trial()};
  std::map<std::string, Tally> tallies;
  for (int seed = 1; seed <= call.repetitions; ++seed) {
    session::LoadOptions options;
    options.settings.push_back({call.seed, std::to_string(seed), "repetition"});
    diagram::Loader loader(registry);
    const session::LoadedModel model = session::load_model(loader, call.file, options);
    if (!model.fit) throw std::invalid_argument(call.file + " has no section 'fit'");
    const estimation::FitResult result =
        estimation::fit({loader, call.file, options.settings, &code}, model.job, *model.fit);
    for (const estimation::FittedNumber& number : result.numbers)
      if (const auto truth = call.truth.find(number.title()); truth != call.truth.end())
        tallies[number.title()].add(number, truth->second);
    fmt::print(stderr, "\r{} of {}{}", seed, call.repetitions, result.compiled ? "" : " (not compiled)");
  }
  fmt::print(stderr, "\n");
  return tallies;
}

/// Prints the table. Returns true if all shares are from 90 to 99 %.
bool tell(const Call& call, const std::map<std::string, Tally>& tallies) {
  bool good = true;
  fmt::print(
      "| number | truth (SI) | bias / spread | mean standard error / spread | interval holds the truth |\n");
  fmt::print("|---|---|---|---|---|\n");
  for (const auto& [name, tally] : tallies) {
    const double mean = tally.sum / tally.fits;
    const double spread = std::sqrt(std::max(0.0, tally.squares / tally.fits - mean * mean));
    fmt::print("| {} | {:.6g} | {:.2f} | {:.2f} | {:.0f} % |\n", name, call.truth.at(name), mean / spread,
               tally.errors / tally.fits / spread, tally.share());
    good = good && tally.share() >= 90.0 && tally.share() <= 99.0;
  }
  return good && tallies.size() == call.truth.size();
}

}  // namespace

}  // namespace stepwire

int main(int count, char** words) {
  try {
    const stepwire::Call call = stepwire::call_of(count, words);
    return stepwire::tell(call, stepwire::tallies_of(call)) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
