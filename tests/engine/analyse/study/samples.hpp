#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "engine/analyse/study/path_errors.hpp"
#include "engine/analyse/study/published.hpp"

namespace stepwire::testing {

constexpr double mm = 1e-3, degree = std::numbers::pi / 180.0;

/// Conditions of both tasks of the thesis.
inline const std::vector<study::Condition>& six_conditions() {
  static const std::vector<study::Condition> all{
      {"NO", {}},
      {"H", {{"haptic", true}}},
      {"V", {{"visual", true}}},
      {"HV", {{"haptic", true}, {"visual", true}}},
      {"V_gp", {{"visual", true}, {"guiding path", true}}},
      {"HV_gp", {{"haptic", true}, {"visual", true}, {"guiding path", true}}}};
  return all;
}

const study::CircleTask circle{"1", "NO"};
const study::ReturnTask way_back{"2"};

/// Published numbers of the tasks of the thesis: sections 4.3.1 and 4.3.2, tables 3 to 6.
inline study::PublishedStudy published_task_1() {
  return {{"section 4.3.1, mean of ten", {{"NO", 0.698}, {"H", 0.217}, {"V", 0.114}, {"HV", 0.079}}},
          {"table 4", {{"haptic", 2.02e-5}, {"visual", 4.49e-8}}},
          {{"table 3, participant a", {{"NO", 0.5139}, {"H", 0.1064}, {"V", 0.1155}, {"HV", 0.0546}}}},
          {{"NO", "H", "V", "HV"}}};
}

inline study::PublishedStudy published_task_2() {
  return {{"section 4.3.2, mean of ten",
           {{"H", 0.421}, {"V", 0.547}, {"HV", 0.291}, {"V_gp", 0.288}, {"HV_gp", 0.185}}},
          {"table 6", {{"haptic", 2.38e-3}, {"visual", 2.16e-1}, {"guiding path", 2.75e-3}}},
          {},
          {{"V", "H", "HV", "HV_gp"}, {"V", "V_gp", "HV_gp"}}};
}

/// 100 points about a circle of 50 mm at (20 mm, -10 mm): the radius is larger by `outwards`, and by `ripple`
/// more or less at every other point [m].
inline study::Trial circle_drawing(const std::string& subject, const std::string& condition, double outwards,
                                   double ripple) {
  study::Trial trial{subject, "1", condition, {}, statistics::PlanePoints(2, 100)};
  for (int i = 0; i < 100; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 100.0;
    const double radius = 50 * mm + outwards + (i % 2 == 0 ? ripple : -ripple);
    trial.time.push_back(0.25 * i);
    trial.points.col(i) << 20 * mm + radius * std::cos(angle), -10 * mm + radius * std::sin(angle);
  }
  return trial;
}

/// A straight way of 30 mm to the region x <= 0, so much off the shortest one.
inline study::Trial straight_return(const std::string& subject, const std::string& condition, double angle) {
  study::Trial trial{subject, "2", condition, {}, statistics::PlanePoints(2, 61)};
  for (int i = 0; i <= 60; ++i) {
    const double to_go = 0.5 * mm * (60 - i);
    trial.time.push_back(0.1 * i);
    trial.points.col(i) << to_go * std::cos(angle), to_go * std::sin(angle);
  }
  return trial;
}

inline Eigen::Vector2d to_half_plane(const Eigen::Vector2d& point) {
  return point.x() > 0.0 ? Eigen::Vector2d(-1.0, 0.0) : Eigen::Vector2d(0.0, 0.0);
}

/// Ten subjects whose mean errors are those that the thesis prints, each subject a share above or below.
inline study::PathErrors errors_of(const std::string& task,
                                   const std::vector<std::pair<std::string, double>>& means) {
  study::PathErrors errors{task, "m", "rad", "made up", {}, {}, {}};
  for (int subject = 0; subject < 10; ++subject)
    for (std::size_t k = 0; k < means.size(); ++k) {
      const double share = 0.3 * std::sin(1.0 + 2.0 * subject + 5.0 * static_cast<double>(k));
      study::PathError row{std::to_string(subject + 1), means[k].first};
      row.error = row.normalised = row.raw = means[k].second * (1.0 + share);
      errors.rows.push_back(row);
    }
  return errors;
}

}  // namespace stepwire::testing
