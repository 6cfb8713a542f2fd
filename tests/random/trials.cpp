#include "tests/random/trials.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <numeric>
#include <regex>

#include "engine/base/subprocess/isolated.hpp"
#include "tests/random/generator.hpp"

namespace stepwire::random {

namespace {

constexpr std::size_t batch = 100;

/// A message without what is another one each time.
std::string kind_of(const std::string& message) {
  static const std::regex place(R"(\S*\.yaml:\d+:\d+:? ?)"), name(R"(\b(part\.|outer\.)*n\d+\b)"),
      number(R"(-?\d[\d.e+-]*)");
  std::string text = std::regex_replace(message.substr(0, message.find('\n')), place, "");
  return std::regex_replace(std::regex_replace(text, name, "NAME"), number, "N");
}

void write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t more = ::write(file, text.data() + done, text.size() - done);
    if (more <= 0) return;
    done += static_cast<std::size_t>(more);
  }
}

std::string read_all(int file) {
  std::string text;
  char piece[4096];
  for (ssize_t more; (more = ::read(file, piece, sizeof piece)) > 0;)
    text.append(piece, static_cast<std::size_t>(more));
  return text;
}

std::size_t sum_of(const std::map<std::string, std::size_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0},
                         [](std::size_t sum, const auto& one) { return sum + one.second; });
}

}  // namespace

std::size_t Totals::all() const {
  return valid + sum_of(refused);
}

Trials::Trials(const Registry& registry, std::string folder)
    : registry_(registry), folder_(std::move(folder)) {
  totals_.laws.resize(laws().size());
}

void Trials::run(std::uint64_t first, std::size_t count, const std::function<void(const Failure&)>& failed) {
  for (std::size_t done = 0; done < count; done += batch) {
    const std::vector<Trial> trials = valid_of(first + done, std::min(batch, count - done));
    ask_for_code(trials);
    code_.compile_all();
    for (const Trial& trial : trials)
      for (std::size_t law = 0; law < laws().size(); ++law)
        if (laws()[law].is_for(trial.seed)) this->count(trial, law, checked(laws()[law], trial), failed);
    code_.clear();
  }
}

std::vector<Trial> Trials::valid_of(std::uint64_t first, std::size_t count) {
  std::vector<Trial> trials;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    Trial trial{seed, random_sketch(registry_, seed), &registry_, folder_};
    try {
      begin(trial);
    } catch (const yaml::Error& error) {
      ++totals_.refused[kind_of(error.what())];
      continue;
    }
    ++totals_.valid;
    totals_.ended += trial.expected.faults.empty() ? 0 : 1;
    count_types(trial.loaded->plan());
    trials.push_back(std::move(trial));
  }
  return trials;
}

void Trials::count_types(const plan::Plan& plan) {
  std::set<std::string> types;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks) types.insert(block.type().name);
  for (const std::string& type : types) ++totals_.types[type];
}

void Trials::ask_for_code(const std::vector<Trial>& trials) {
  for (const Trial& trial : trials)
    for (const Law& law : laws())
      if (law.asks && law.is_for(trial.seed)) law.check(trial, code_);
}

void Trials::count(const Trial& trial, std::size_t law, const Verdict& verdict,
                   const std::function<void(const Failure&)>& failed) {
  LawCount& counts = totals_.laws[law];
  if (verdict.kind == Verdict::Kind::skipped) {
    ++counts.skipped[kind_of(verdict.text)];
    return;
  }
  counts.located += trial.expected.events.located > 0 ? 1 : 0;
  ++(verdict.kind == Verdict::Kind::same ? counts.same : counts.different);
  if (verdict.kind == Verdict::Kind::same) return;
  totals_.failures.push_back({trial.seed, &laws()[law], trial.sketch, verdict.text});
  failed(totals_.failures.back());
}

/// Code that is wrong may end the process that runs it.
Verdict Trials::checked(const Law& law, const Trial& trial) {
  if (!law.isolated) return law.check(trial, code_);
  try {
    const io::Descriptor output = subprocess::call_isolated(
        [&](int file) {
          const Verdict verdict = law.check(trial, code_);
          write_all(file, std::to_string(static_cast<int>(verdict.kind)) + verdict.text);
        },
        {std::chrono::seconds(60), std::size_t{8} << 30});
    const std::string text = read_all(output.number());
    return {static_cast<Verdict::Kind>(text.at(0) - '0'), text.substr(1)};
  } catch (const subprocess::IsolationError& error) {
    return {Verdict::Kind::different, std::string("the process ") + error.what()};
  }
}

std::vector<Verdict> Trials::check(const Law& law, std::uint64_t seed, const std::vector<Sketch>& sketches) {
  std::vector<Verdict> verdicts(sketches.size(), {Verdict::Kind::skipped, "it is refused"});
  std::vector<std::pair<std::size_t, Trial>> trials;
  for (std::size_t i = 0; i < sketches.size(); ++i) {
    Trial trial{seed, sketches[i], &registry_, folder_};
    try {
      begin(trial);
      if (law.asks) law.check(trial, code_);
      trials.emplace_back(i, std::move(trial));
    } catch (const std::exception&) {
      continue;
    }
  }
  code_.compile_all();
  for (const auto& [i, trial] : trials) verdicts[i] = checked(law, trial);
  code_.clear();
  return verdicts;
}

std::string totals_text(const Totals& totals) {
  std::string text = fmt::format(
      "{} diagrams: {} valid, {} refused, {} ended by a fault; {} "
      "types of blocks\n",
      totals.all(), totals.valid, sum_of(totals.refused), totals.ended, totals.types.size());
  for (const auto& [message, count] : totals.refused)
    text += fmt::format("  refused {:4}: {}\n", count, message.substr(0, 150));
  text += fmt::format("{:28}{:>9}{:>9}{:>9}{:>10}\n", "law", "the same", "located", "skipped", "different");
  for (std::size_t i = 0; i < totals.laws.size(); ++i) {
    const LawCount& law = totals.laws[i];
    text += fmt::format("{:28}{:9}{:9}{:9}{:10}\n", laws()[i].name, law.same, law.located,
                        sum_of(law.skipped), law.different);
    for (const auto& [why, count] : law.skipped)
      text += fmt::format("  skipped {:4}: {}\n", count, why.substr(0, 150));
  }
  return text;
}

std::string weakness_of(const Totals& totals, const Registry& registry) {
  if (10 * totals.valid < 6 * totals.all()) return "less than 60 % of the diagrams are valid";
  for (std::size_t i = 0; i < totals.laws.size(); ++i)
    if (20 * laws()[i].every * (totals.laws[i].same + totals.laws[i].different) < totals.valid)
      return fmt::format(
          "'{}' was compared on less than 5 % of the diagrams "
          "for which it is meant",
          laws()[i].name);
  for (const BlockType* type : registry.types())
    if (totals.valid >= 3 * registry.types().size() && !type->file_output &&
        !totals.types.contains(type->name))
      return fmt::format("no diagram has a block {}", type->name);
  return "";
}

}  // namespace stepwire::random
