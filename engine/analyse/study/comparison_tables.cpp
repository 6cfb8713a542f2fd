#include "engine/analyse/study/comparison_tables.hpp"
#include "engine/base/text/count.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stepwire::study {

using json::Json;

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
      {fmt::format("95 % confidence, {}. From, to: Student's t of the values as they are. Within subjects: "
                   "without what tells subjects apart as a whole (Cousineau 2005, Morey 2008). A difference "
                   "whose interval has 0 outside is significant at 0.05, uncorrected.",
                   text::counted(within.table.subjects.size(), "subject"))}};
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
      {fmt::format("First minus second: above 0 the second is smaller. Paired t test with {} "
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
      {fmt::format("Power: of a study of {} at 0.05, uncorrected, were the effect seen the true one; it "
                   "follows from P and says nothing beyond it. Subjects: needed for a power of {:g}. t: "
                   "noncentral t, for normal differences. Simulated: {} experiments whose subjects are drawn "
                   "from those seen (seed {}), up to {} of them.",
                   text::counted(within.table.subjects.size(), "subject"), statistics::wanted_power,
                   simulation.experiments, seed, simulation.most_subjects)}};
  for (const statistics::PowerRow& row : statistics::power_rows(within, simulation))
    table.rows.push_back({row.of, digits(row.d_z), digits(row.power), digits(row.simulated),
                          counted(row.needed, std::isfinite(row.d_z), 10000),
                          counted(row.needed_simulated, row.simulation_possible, simulation.most_subjects)});
  if (within.table.subjects.size() < 3)
    table.notes.emplace_back("Power is not simulated: two subjects show too little of how subjects differ.");
  return table;
}

constexpr double level = 0.05;
constexpr double mild_epsilon = 0.75;  // above it Huynh and Feldt's correction is better (Girden 1992)

/// Writer of assumptions: a line of the table, and a sentence for each rejected or undecided one.
class AssumptionLines {
 public:
  explicit AssumptionLines(text::TextTable& table) : table_(table) {}

  void add(const std::string& assumption, const std::string& of, const std::string& statistic, double p,
           const std::string& sentence) {
    const bool judged = !std::isnan(p), rejected = judged && p < level;
    table_.rows.push_back({assumption, of, statistic, printed_probability(p),
                           !judged    ? "–"
                           : rejected ? "rejected"
                                      : "not rejected"});
    if (rejected) table_.notes.push_back(sentence);
    any_ = any_ || rejected;
  }

  void add(const std::string& of, const std::optional<statistics::Normality>& normality,
           const std::string& what, const std::string& read) {
    if (!normality)
      return add_unjudged("normal", of,
                          fmt::format("{}: normality is not judged; Shapiro-Wilk needs three independent "
                                      "values or more that are not all equal.",
                                      of));
    add("normal", of, fmt::format("W = {:.3f}", normality->w), normality->p,
        fmt::format("{} are not normal (Shapiro-Wilk W = {:.2f}, P = {}): {}.", what, normality->w,
                    printed_probability(normality->p), read));
  }

  void add_unjudged(const std::string& assumption, const std::string& of, const std::string& sentence) {
    table_.rows.push_back({assumption, of, "–", "–", "–"});
    table_.notes.push_back(sentence);
  }

  bool any() const { return any_; }

 private:
  text::TextTable& table_;
  bool any_ = false;
};

void add_sphericity(const statistics::AnovaRow& row, AssumptionLines& lines) {
  const statistics::Sphericity& s = *row.sphericity;
  const bool mild = s.epsilon > mild_epsilon && !std::isnan(s.huynh_feldt);
  const std::string epsilons =
      fmt::format("ε = {:.3f} (GG){}", s.epsilon,
                  std::isnan(s.huynh_feldt) ? "" : fmt::format(", {:.3f} (HF)", s.huynh_feldt));
  const std::string w = std::isnan(s.mauchly) ? "" : fmt::format("W = {:.3f}, ", s.mauchly);
  lines.add(
      "spherical", row.name, w + epsilons, s.p_mauchly,
      fmt::format(
          "{} is not spherical (Mauchly's W = {:.2f}, P = {}): read its P with the correction of {}, {}.",
          row.name, s.mauchly, printed_probability(s.p_mauchly),
          mild ? "Huynh and Feldt" : "Greenhouse and Geisser",
          printed_probability(mild ? s.p_huynh_feldt : s.p_corrected)));
}

void add_variances(const statistics::WithinSubjects& within, AssumptionLines& lines) {
  if (!within.variances) {
    lines.add_unjudged("equal variances", "conditions",
                       within.table.subjects.size() < 3
                           ? "Equal variances: not judged, three values per condition are needed."
                           : "Equal variances: not judged, the values of each condition lie equally far from "
                             "their median.");
    return;
  }
  const statistics::VarianceTest& test = *within.variances;
  const std::string statistic = fmt::format("F({:g}, {:g}) = {:.3g}", test.above, test.below, test.f);
  lines.add("equal variances", "conditions", statistic, test.p,
            fmt::format(
                "The variances of the conditions differ (Brown-Forsythe {}, P = {}): read the comparisons of "
                "pairs, each of which has a variance of its own.",
                statistic, printed_probability(test.p)));
}

Json interval_json(const statistics::ConfidenceInterval& interval) {
  return Json::list({Json(interval.low), Json(interval.high)});
}

Json normality_json(const std::optional<statistics::Normality>& normality) {
  if (!normality) return nullptr;
  return Json::object().set("W", normality->w).set("P", normality->p);
}

Json means_json(const statistics::WithinSubjects& within) {
  Json list = Json::list();
  for (std::size_t i = 0; i < within.means.size(); ++i)
    list.push(Json::object()
                  .set("condition", within.table.conditions[i])
                  .set("mean", within.means[i].mean)
                  .set("interval", interval_json(within.means[i].plain))
                  .set("interval_within_subjects", interval_json(within.means[i].within_subject)));
  return list;
}

Json comparison_json(const statistics::PairComparison& one) {
  return Json::object()
      .set("first", one.first)
      .set("second", one.second)
      .set("difference", one.test.mean)
      .set("interval", interval_json(one.test.interval))
      .set("t", one.test.t)
      .set("degrees_of_freedom", one.test.freedom)
      .set("P", one.test.p)
      .set("P_holm", one.holm)
      .set("signed_rank", Json::object()
                              .set("V", one.ranks.sum)
                              .set("P", one.ranks.p)
                              .set("P_holm", one.ranks_holm)
                              .set("exact", one.ranks.exact))
      .set("d_z", one.effect.d_z)
      .set("d_z_interval", interval_json(one.effect.interval))
      .set("d_av", one.effect.d_av)
      .set("normality", normality_json(one.normality));
}

Json term_json(const statistics::TermEffect& one, const statistics::WithinSubjects& within) {
  Json json = Json::object()
                  .set("name", one.term)
                  .set("partial_eta_squared", one.partial)
                  .set("partial_eta_squared_interval", interval_json(one.interval))
                  .set("generalised_eta_squared", one.generalised);
  if (const auto& s = within.repeated.find(one.term)->sphericity) json.set("sphericity", sphericity_json(*s));
  return json;
}

Json needed_json(const std::optional<std::size_t>& needed) {
  return needed ? Json(*needed) : Json(nullptr);
}

Json power_json(const statistics::WithinSubjects& within, std::uint64_t seed) {
  statistics::PowerSimulation simulation;
  simulation.seed = seed;
  Json list = Json::list();
  for (const statistics::PowerRow& row : statistics::power_rows(within, simulation))
    list.push(Json::object()
                  .set("of", row.of)
                  .set("d_z", row.d_z)
                  .set("power", row.power)
                  .set("power_simulated", row.simulated)
                  .set("subjects_needed", needed_json(row.needed))
                  .set("subjects_needed_simulated", needed_json(row.needed_simulated)));
  return list;
}

/// Returns the table of assumptions, with advice for each violated one.
text::TextTable assumptions_table(const statistics::WithinSubjects& within, const std::string& title) {
  text::TextTable table{title, {"assumption", "of", "statistic", "P", "at 0.05"}, {}, {}};
  AssumptionLines lines(table);
  lines.add("residuals", within.residuals, "The residuals", "read the signed-rank tests of the comparisons");
  for (const statistics::PairComparison& one : within.comparisons) {
    const std::string name = fmt::format("{} - {}", one.first, one.second);
    lines.add(name, one.normality, "The differences " + name,
              "read the signed-rank P of this pair, " + printed_probability(one.ranks.p));
  }
  bool several = false;
  for (const statistics::AnovaRow& row : within.repeated.terms) {
    if (row.sphericity) add_sphericity(row, lines);
    several = several || (row.freedom > 1.0 && within.repeated.find(row.against) != nullptr);
  }
  add_variances(within, lines);
  if (!several) table.notes.emplace_back("Every term has one degree of freedom, so that sphericity holds.");
  if (!lines.any())
    table.notes.push_back(fmt::format("No assumption is rejected; {} subjects show large departures only.",
                                      within.table.subjects.size()));
  table.notes.emplace_back(
      "Residuals: of the model subject + condition. W: Shapiro-Wilk of what should be normal, Mauchly of "
      "what should "
      "be spherical; ε of Greenhouse and Geisser (GG) and of Huynh and Feldt (HF).");
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

Json comparisons_json(const statistics::WithinSubjects& within, std::optional<std::uint64_t> seed) {
  Json comparisons = Json::list(), terms = Json::list();
  for (const statistics::PairComparison& one : within.comparisons) comparisons.push(comparison_json(one));
  for (const statistics::TermEffect& one : within.effects) terms.push(term_json(one, within));
  Json assumptions = Json::object().set("residuals", normality_json(within.residuals));
  if (within.variances)
    assumptions.set("equal_variances",
                    Json::object().set("F", within.variances->f).set("P", within.variances->p));
  Json json = Json::object();
  json.set("subjects", Json::list_of(within.table.subjects))
      .set("left_out", Json::list_of(within.table.left_out))
      .set("means", means_json(within))
      .set("comparisons", std::move(comparisons))
      .set("terms", std::move(terms));
  if (seed) json.set("power", power_json(within, *seed));
  return json.set("assumptions", std::move(assumptions));
}

}  // namespace stepwire::study
