#include "engine/analyse/study/comparison_tables.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stepwire::study {
namespace {

std::string digits(double value) {
  return std::isfinite(value) ? fmt::format("{:.3f}", value) : "–";
}

std::string pair_name(const statistics::PairComparison& one) {
  return fmt::format("{} - {}", one.first, one.second);
}

void note_left_out(const statistics::WithinSubjects& within, text::TextTable& table) {
  for (const std::string& sentence : within.table.left_out)
    table.notes.push_back("Left out: " + sentence + ".");
}

/// Adds a note for each comparison whose differences are all equal.
void note_equal_differences(const statistics::WithinSubjects& within, text::TextTable& table) {
  for (const statistics::PairComparison& one : within.comparisons)
    if (std::isnan(one.test.t))
      table.notes.push_back(
          fmt::format("{}: the difference is {:.4g} for every subject, so t and d_z have no value.",
                      pair_name(one), one.test.mean));
}

text::TextTable intervals_table(const statistics::WithinSubjects& within, const std::string& of) {
  text::TextTable table{
      "Intervals" + of,
      {"mean of", "mean", "from", "to", "within subjects from", "to"},
      {},
      {fmt::format("95 % confidence, {} subjects. From, to: Student's t of the values as they are. Within "
                   "subjects: without what tells subjects apart as a whole (Cousineau 2005, Morey 2008). A "
                   "difference whose interval has 0 outside is significant at 0.05, uncorrected.",
                   within.table.subjects.size())}};
  for (std::size_t i = 0; i < within.means.size(); ++i) {
    const statistics::MeanInterval& one = within.means[i];
    table.rows.push_back({within.table.conditions[i], digits(one.mean), digits(one.plain.low),
                          digits(one.plain.high), digits(one.within_subject.low),
                          digits(one.within_subject.high)});
  }
  for (const statistics::PairComparison& one : within.comparisons)
    table.rows.push_back({pair_name(one), digits(one.test.mean), digits(one.test.interval.low),
                          digits(one.test.interval.high), "–", "–"});
  return table;
}

/// Returns the note on the correction of P: the number of comparisons with a P.
std::string corrected_for(const statistics::WithinSubjects& within) {
  std::size_t of_t = 0, of_ranks = 0;
  for (const statistics::PairComparison& one : within.comparisons) {
    if (!std::isnan(one.test.p)) ++of_t;
    if (!std::isnan(one.ranks.p)) ++of_ranks;
  }
  if (of_t == of_ranks) return fmt::format("corrected for {} comparison{}", of_t, of_t == 1 ? "" : "s");
  return fmt::format("corrected for the comparisons that have a P, {} of t and {} of the signed ranks", of_t,
                     of_ranks);
}

text::TextTable pairs_table(const statistics::WithinSubjects& within, const std::string& of) {
  text::TextTable table{
      "Comparisons of pairs" + of,
      {"pair", "mean difference", "t", "P", "P (Holm)", "signed-rank V", "P", "P (Holm)"},
      {},
      {fmt::format("First minus second: above 0 the second has the smaller error. Paired t test with {} "
                   "degrees of freedom, Wilcoxon's signed-rank test ({}); P (Holm): {}.",
                   within.table.subjects.size() - 1,
                   within.table.subjects.size() > 50 ? "normal approximation" : "exact",
                   corrected_for(within))}};
  for (const statistics::PairComparison& one : within.comparisons)
    table.rows.push_back({pair_name(one), digits(one.test.mean), digits(one.test.t),
                          printed_probability(one.test.p), printed_probability(one.holm),
                          fmt::format("{:g}", one.ranks.sum), printed_probability(one.ranks.p),
                          printed_probability(one.ranks_holm)});
  note_equal_differences(within, table);
  return table;
}

text::TextTable effects_table(const statistics::WithinSubjects& within, const std::string& of) {
  text::TextTable table{"Effect sizes" + of, {"effect", "measure", "value", "from", "to"}, {}, {}};
  for (const statistics::PairComparison& one : within.comparisons) {
    table.rows.push_back({pair_name(one), "d_z", digits(one.effect.d_z), digits(one.effect.interval.low),
                          digits(one.effect.interval.high)});
    table.rows.push_back({pair_name(one), "d_av", digits(one.effect.d_av), "–", "–"});
  }
  for (const statistics::TermEffect& one : within.effects) {
    table.rows.push_back(
        {one.term, "partial η²", digits(one.partial), digits(one.interval.low), digits(one.interval.high)});
    table.rows.push_back({one.term, "generalised η²", digits(one.generalised), "–", "–"});
  }
  table.notes = {
      "d_z: mean difference over the standard deviation of the differences, 95 % by the noncentral t; d_av: "
      "over the "
      "mean of both standard deviations (Lakens 2013). Partial η²: 90 % by the noncentral F (Smithson 2003); "
      "generalised η² after Olejnik and Algina (2003)."};
  note_equal_differences(within, table);
  return table;
}

std::string counted(const std::optional<std::size_t>& needed, bool known, std::size_t most) {
  if (!known) return "–";
  return needed ? std::to_string(*needed) : fmt::format("> {}", most);
}

text::TextTable power_table(const statistics::WithinSubjects& within, const std::string& of,
                            std::uint64_t seed) {
  statistics::PowerSimulation simulation;
  simulation.seed = seed;
  text::TextTable table{
      "Power" + of,
      {"effect", "d_z", "power (t)", "power (simulated)", "subjects (t)", "subjects (simulated)"},
      {},
      {fmt::format("Power: of a study of {} subjects at 0.05, uncorrected, were the effect seen the true "
                   "one; it follows from P and says nothing beyond it. Subjects: needed for a power of "
                   "{:g}. t: noncentral t, for normal differences. Simulated: {} experiments whose "
                   "subjects are drawn from those seen (seed {}), up to {} of them.",
                   within.table.subjects.size(), statistics::wanted_power, simulation.experiments, seed,
                   simulation.most_subjects)}};
  for (const statistics::PowerRow& row : statistics::power_rows(within, simulation))
    table.rows.push_back({row.of, digits(row.d_z), digits(row.power), digits(row.simulated),
                          counted(row.needed, std::isfinite(row.d_z), 10000),
                          counted(row.needed_simulated, row.simulation_possible, simulation.most_subjects)});
  if (within.table.subjects.size() < 3)
    table.notes.emplace_back("Power is not simulated: two subjects show too little of how subjects differ.");
  return table;
}

}  // namespace

const std::vector<std::string>& comparison_table_names() {
  static const std::vector<std::string> names{"intervals", "comparisons", "effect_sizes", "power",
                                              "assumptions"};
  return names;
}

text::TextTable comparison_table(const std::string& name, const statistics::WithinSubjects& within,
                                 const std::string& of, std::uint64_t seed) {
  text::TextTable table = name == "intervals"      ? intervals_table(within, of)
                          : name == "comparisons"  ? pairs_table(within, of)
                          : name == "effect_sizes" ? effects_table(within, of)
                          : name == "power"        ? power_table(within, of, seed)
                                                   : assumptions_table(within, "Assumptions" + of);
  note_left_out(within, table);
  return table;
}

}  // namespace stepwire::study
