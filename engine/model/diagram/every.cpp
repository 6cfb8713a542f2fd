#include "engine/model/diagram/every.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/open.hpp"

namespace stepwire::diagram {

using form = yaml::form;

namespace {

yaml::Key at_least_zero(yaml::Key number) {
  number.least = 0.0;
  return number;
}

const yaml::Key& pair_form() {
  static const yaml::Key form = form::keys(
      "a period with an offset", "{period: 3 ms, offset: 1 ms}",
      {yaml::needed(yaml::key("period", "time between two runs", form::above_zero(form::number("s")))),
       yaml::otherwise("0 s", yaml::key("offset", "time of the first run, below the period",
                                        at_least_zero(form::number("s"))))});
  return form;
}

/// True for a whole multiple of the other, up to rounding.
bool is_multiple(double time, double unit) {
  const double ratio = time / unit;
  return std::abs(ratio - std::round(ratio)) <= 1e-9 * std::max(1.0, ratio);
}

}  // namespace

yaml::Key every_key(const std::string& doc) {
  return yaml::key("every", doc, form::either({form::above_zero(form::number("s")), pair_form()}));
}

void Opener::read_period(const Scope& scope, const yaml::Node& node, DiagramBlock& block) {
  block.every_origin = scope.at(node.mark);
  block.every = read_every(scope, node, block.name + ".every");
}

std::optional<Every> Opener::read_every(const Scope& scope, const yaml::Node& node,
                                        const std::string& subject) {
  if (!node.is_map()) {
    const auto period = read_time(scope, node, subject);
    return period ? std::optional(Every{*period}) : std::nullopt;
  }
  const HeadReading read(subject, scope, report_);
  read.check(node, pair_form());
  const yaml::Node *period = node.find("period"), *offset = node.find("offset");
  if (!period) return std::nullopt;
  Every every;
  yaml::below(read, "period").take(*period, *pair_form().find("period"), every.period);
  if (offset) yaml::below(read, "offset").take(*offset, *pair_form().find("offset"), every.offset);
  if (every.period > 0.0 && every.offset >= 0.0 && every.offset < every.period) return every;
  if (every.offset >= every.period && every.period > 0.0)
    report_.add(scope.at(offset->mark), subject + ".offset",
                fmt::format("{:.12g} s is not below the period of {:.12g} s: the first of the runs comes "
                            "within one period",
                            every.offset, every.period));
  return std::nullopt;
}

std::optional<double> Opener::read_time(const Scope& scope, const yaml::Node& node,
                                        const std::string& subject) {
  const ValueReader reader(scope.parameters, report_, scope.index);
  const auto time = reader.read_number(node, unit::parse_unit("s")->dimension, subject);
  if (!time || *time > 0.0) return time;
  report_.add(scope.at(node.mark), subject,
              yaml::fault_text("{} is not allowed; it must be above 0", node.text));
  return std::nullopt;
}

void Opener::take_period_of_part(const Scope& scope, DiagramBlock& block) {
  if (!scope.every) return;
  if (block.every) return join_with_part(scope, block.every_origin, block.name, *block.every);
  block.every = scope.every;
  block.every_origin = scope.every_origin;
  block.every_of_part = true;
}

void Opener::read_period_of_part(const Scope& scope, const yaml::Entry& entry, const KeyTaken& is_own,
                                 Scope& part) {
  part.every = scope.every;
  part.every_origin = scope.every_origin;
  const yaml::Node* every = is_own("every") ? nullptr : entry.value.find("every");
  if (!every) return;
  const std::string name = scope.prefix + entry.key;
  if (auto own = read_every(scope, *every, name + ".every")) {
    join_with_part(scope, scope.at(every->mark), name, *own);
    part.every = own;
    part.every_origin = scope.at(every->mark);
  }
}

/// Shifts times inside of a part, which are relative to the part's first run.
void Opener::join_with_part(const Scope& scope, const Origin& origin, const std::string& name, Every& every) {
  if (!scope.every) return;
  const auto require_multiple = [&](double time, double least) {
    const double period = scope.every->period;
    if (time >= 0.5 * least && is_multiple(time, period)) return;
    report_.add(origin, name + ".every",
                fmt::format("{0} s is not a whole multiple of the {1} s at which its part runs; e.g. "
                            "{2:.12g} s would be",
                            time, period, std::max(least, period * std::round(time / period))));
  };
  require_multiple(every.period, scope.every->period);
  require_multiple(every.offset, 0.0);
  every.offset += scope.every->offset;
}

}  // namespace stepwire::diagram
