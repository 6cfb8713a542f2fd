// Comparisons of conditions within subjects as JSON.
#include <fmt/format.h>

#include "engine/analyse/study/comparison_tables.hpp"

namespace stepwire::study {

using json::Json;

namespace {

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
  if (const auto& s = within.repeated.find(one.term)->sphericity)
    json.set("sphericity", Json::object()
                               .set("mauchly_W", s->mauchly)
                               .set("mauchly_P", s->p_mauchly)
                               .set("epsilon_greenhouse_geisser", s->epsilon)
                               .set("P_greenhouse_geisser", s->p_corrected)
                               .set("epsilon_huynh_feldt", s->huynh_feldt)
                               .set("P_huynh_feldt", s->p_huynh_feldt));
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

}  // namespace

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
