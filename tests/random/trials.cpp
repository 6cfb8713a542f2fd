#include "tests/random/trials.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <numeric>
#include <regex>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/subprocess/isolated.hpp"
#include "tests/random/generator.hpp"

namespace stepwire::random {

namespace {

constexpr std::size_t batch = 100;
constexpr std::size_t fewest = 20;  ///< diagrams of a law, below which their share proves nothing

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

void Trials::run(std::uint64_t first, std::size_t count, std::size_t with_code) {
  for (std::size_t done = 0; done < count; done += batch) {
    const std::vector<Trial> trials = valid_of(first + done, std::min(batch, count - done));
    std::vector<Check> checks = checks_of(trials, first + std::min(with_code, count));
    check_all(checks);
    for (const Check& check : checks) this->count(check);
    code_.clear();
  }
}

/// Diagrams are made on all cores, and counted in the order of their seeds.
std::vector<Trial> Trials::valid_of(std::uint64_t first, std::size_t count) {
  std::vector<Trial> all(count);
  std::vector<std::string> refused(count);
  parallel::in_parallel(count, 0, [&](std::size_t i) {
    all[i] = {first + i, random_sketch(registry_, first + i), &registry_, folder_};
    try {
      begin(all[i]);
    } catch (const yaml::Error& error) {
      refused[i] = kind_of(error.what());
    }
  });
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < count; ++i) {
    if (!refused[i].empty()) {
      ++totals_.refused[refused[i]];
      continue;
    }
    ++totals_.valid;
    totals_.ended += all[i].expected.faults.empty() ? 0 : 1;
    count_types(all[i].loaded->plan());
    trials.push_back(std::move(all[i]));
  }
  return trials;
}

void Trials::count_types(const plan::Plan& plan) {
  std::set<std::string> types;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks) types.insert(block.type().name);
  for (const std::string& type : types) ++totals_.types[type];
}

std::vector<Trials::Check> Trials::checks_of(const std::vector<Trial>& trials,
                                             std::uint64_t end_of_code) const {
  std::vector<Check> checks;
  for (const Trial& trial : trials)
    for (std::size_t law = 0; law < laws().size(); ++law)
      if (laws()[law].is_for(trial.seed) && (!laws()[law].asks || trial.seed < end_of_code))
        checks.push_back({&trial, law});
  return checks;
}

/// Laws that take no process of their own are checked on all cores; no process is begun meanwhile.
void Trials::check_all(std::vector<Check>& checks) {
  std::vector<Check*> alone, together;
  for (Check& check : checks) {
    const Law& law = laws()[check.law];
    if (law.asks) law.check(*check.trial, code_);
    (law.isolated ? alone : together).push_back(&check);
  }
  code_.compile_all();
  const auto find = [&](Check& one) { one.verdict = checked(laws()[one.law], *one.trial); };
  parallel::in_parallel(together.size(), 0, [&](std::size_t i) { find(*together[i]); });
  for (Check* check : alone) find(*check);
}

void Trials::count(const Check& check) {
  LawCount& counts = totals_.laws[check.law];
  const Verdict& verdict = check.verdict;
  ++counts.meant;
  if (verdict.kind == Verdict::Kind::skipped) {
    ++counts.skipped[kind_of(verdict.text)];
    return;
  }
  counts.located += check.trial->expected.events.located > 0 ? 1 : 0;
  ++(verdict.kind == Verdict::Kind::same ? counts.same : counts.different);
  if (verdict.kind == Verdict::Kind::same) return;
  totals_.failures.push_back({check.trial->seed, &laws()[check.law], check.trial->sketch, verdict.text});
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
    if (const LawCount& law = totals.laws[i];
        law.meant >= fewest && 20 * (law.same + law.different) < law.meant)
      return fmt::format("'{}' was compared on less than 5 % of the diagrams for which it is meant",
                         laws()[i].name);
  for (const BlockType* type : registry.types())
    if (totals.valid >= 3 * registry.types().size() && !type->file_output &&
        !totals.types.contains(type->name))
      return fmt::format("no diagram has a block {}", type->name);
  return "";
}

}  // namespace stepwire::random
