// The table of assumptions of the analyses within subjects.
#include <fmt/format.h>

#include <cmath>

#include "engine/analyse/study/comparison_tables.hpp"

namespace stepwire::study {
namespace {

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

}  // namespace

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

}  // namespace stepwire::study
