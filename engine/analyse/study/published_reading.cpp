#include "engine/analyse/study/published.hpp"

namespace stepwire {

const PublishedTask& published_task_1() {
  static const PublishedTask task{
      "1",
      {"section 4.3.1, mean of ten", {{"NO", 0.698}, {"H", 0.217}, {"V", 0.114}, {"HV", 0.079}}},
      {"table 4", {{"haptic", 2.02e-5}, {"visual", 4.49e-8}}},
      {{"table 3, participant a", {{"NO", 0.5139}, {"H", 0.1064}, {"V", 0.1155}, {"HV", 0.0546}}},
       {"table 3, participant b", {{"NO", 0.2352}, {"H", 0.1492}, {"V", 0.1333}, {"HV", 0.0625}}}},
      {{"NO", "H", "V", "HV"}}};
  return task;
}

const PublishedTask& published_task_2() {
  static const PublishedTask task{
      "2",
      {"section 4.3.2, mean of ten",
       {{"H", 0.421}, {"V", 0.547}, {"HV", 0.291}, {"V_gp", 0.288}, {"HV_gp", 0.185}}},
      {"table 6", {{"haptic", 2.38e-3}, {"visual", 2.16e-1}, {"guiding path", 2.75e-3}}},
      {{"table 5", {{"H", 0.4059}, {"V", 0.9264}, {"HV", 0.2498}, {"V_gp", 0.2506}, {"HV_gp", 0.1460}}}},
      {{"V", "H", "HV", "HV_gp"}, {"V", "V_gp", "HV_gp"}}};
  return task;
}

const PublishedTask& published_task(const std::string& task) {
  return task == "1" ? published_task_1() : published_task_2();
}

}  // namespace stepwire
