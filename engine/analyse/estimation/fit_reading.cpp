#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire {

namespace {

using Keys = std::vector<std::string>;

const Keys fit_keys{"parameters", "compare", "hold_out",   "loss",   "width",  "starts",
                    "follow",     "seed",    "iterations", "global", "curves", "records"};
const Keys parameter_keys{"start", "bounds", "scale", "each_record"};
const Keys comparison_keys{"model", "measured", "weight", "where", "offset", "against"};
const Keys global_keys{"population", "generations"};

class Reader {
 public:
  Reader(const Node& node, const Names& names, const Diagram& diagram, Faults& faults)
      : node_(node), names_(names), diagram_(diagram), faults_(faults) {}

  FitRequest read() {
    request_.place = {names_.file, node_.mark};
    if (!is_map(node_, fit_keys, "fit", "the fit", "{parameters: {..}, compare: [..]}")) return request_;
    read_parameters();
    read_comparisons();
    if (const Node* held = node_.find("hold_out")) read_hold_out(*held);
    read_loss();
    request_.starts = whole(node_, "starts", 1, 10'000, request_.starts, "fit.starts");
    if (node_.find("follow"))
      request_.follow = whole(node_, "follow", 1, 10'000, request_.starts, "fit.follow");
    request_.seed = whole(node_, "seed", 0, 1'000'000'000, request_.seed, "fit.seed");
    request_.iterations = whole(node_, "iterations", 1, 100'000, request_.iterations, "fit.iterations");
    if (const Node* global = node_.find("global")) read_global(*global);
    if (const Node* curves = node_.find("curves")) read_curves(*curves);
    if (const Node* word = node_.find("records"))
      request_.records = read_text(*word, names_, "fit.records", faults_);
    return std::move(request_);
  }

 private:
  void fault(const Mark& mark, const std::string& subject, const std::string& message) {
    faults_.add({{names_.file, mark}, subject, message, {}});
  }

  bool is_map(const Node& node, const Keys& keys, const std::string& subject, const std::string& owner,
              const std::string& form) {
    if (!node.is_map()) {
      fault(node.mark, subject, "is written " + form);
      return false;
    }
    for (const Entry& entry : node.entries)
      if (std::find(keys.begin(), keys.end(), entry.key) == keys.end())
        add_unknown_key(entry, keys, owner, names_, subject, faults_);
    return true;
  }

  std::uint64_t whole(const Node& map, const char* key, double least, double most, std::uint64_t otherwise,
                      const std::string& subject) {
    const Node* node = map.find(key);
    if (!node) return otherwise;
    const auto value = parse_quantity(node->text);
    if (value && !value->dimension && value->value == std::floor(value->value) && value->value >= least &&
        value->value <= most)
      return static_cast<std::uint64_t>(value->value);
    fault(node->mark, subject, fmt::format("'{}' is no whole number from {} to {}", node->text, least, most));
    return otherwise;
  }

  bool flag(const Node& map, const char* key, const std::string& subject) {
    const Node* node = map.find(key);
    if (!node) return false;
    if (node->text != "true" && node->text != "false")
      fault(node->mark, subject, fmt::format("'{}' is neither true nor false", node->text));
    return node->text == "true";
  }

  void read_parameters() {
    const Node* map = node_.find("parameters");
    if (!map || !map->is_map() || map->entries.empty())
      return fault(map ? map->mark : node_.mark, "fit.parameters",
                   "names what is to be found: {rig.mass: {start: 2 kg, bounds: [1 kg, 5 kg]}}");
    for (const Entry& entry : map->entries) read_parameter(entry);
  }

  const DiagramParameter* known(const std::string& name) const {
    const auto& all = diagram_.parameters;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    return found == all.end() ? nullptr : &*found;
  }

  bool is_swept(const std::string& name) const {
    if (!diagram_.sweep) return false;
    const auto& axes = diagram_.sweep->axes;
    return std::any_of(axes.begin(), axes.end(), [&](const auto& axis) { return axis.parameter == name; });
  }

  void read_parameter(const Entry& entry) {
    const std::string subject = "fit.parameters." + entry.key;
    const DiagramParameter* of = known(entry.key);
    if (!of) return fault(entry.mark, subject, unknown(entry.key));
    const double* own = std::get_if<double>(&of->value.content);
    if (!own)
      return fault(entry.mark, subject,
                   fmt::format("'{}' is no single number, which alone is fitted", of->text));
    if (is_swept(entry.key))
      return fault(entry.mark, subject, "is swept, so it is given; take it out of 'sweep' or out of 'fit'");
    if (!is_map(entry.value, parameter_keys, subject, "it", "{start: 2 kg, bounds: [1 kg, 5 kg]}")) return;
    FitParameter parameter{.name = entry.key, .start = *own, .dimension = of->dimension};
    parameter.place = {names_.file, entry.mark};
    const Node* start = entry.value.find("start");
    if (start) parameter.start = number(*start, subject, parameter);
    if (const Node* bounds = entry.value.find("bounds"))
      read_bounds(*bounds, start ? start->text : of->text, subject, parameter);
    parameter.each_record = flag(entry.value, "each_record", subject);
    read_scale(entry.value.find("scale"), subject, parameter);
    all_.push_back(parameter);
    if (!of->set) request_.parameters.push_back(std::move(parameter));  // what the call sets is given
  }

  std::string unknown(const std::string& name) const {
    Keys all;
    for (const DiagramParameter& one : diagram_.parameters)
      if (std::holds_alternative<double>(one.value.content)) all.push_back(one.name);
    return fmt::format("there is no parameter '{}'{}", name, nearest_or_all(name, all, "there are"));
  }

  double number(const Node& node, const std::string& subject, FitParameter& parameter) {
    const auto read = read_number(node, names_, subject, faults_);
    if (!read) return 0.0;
    check_dimension(*read, parameter.dimension, "the parameter", node, names_, subject, faults_);
    if (!parameter.dimension) parameter.dimension = read->dimension;
    if (parameter.unit.empty()) parameter.unit = read->unit;
    return read->value;
  }

  void read_bounds(const Node& node, const std::string& start, const std::string& subject,
                   FitParameter& parameter) {
    if (!node.is_list() || node.items.size() != 2)
      return fault(node.mark, subject, "bounds are a lower and an upper one: [1 kg, 5 kg]");
    parameter.lower = number(node.items[0], subject, parameter);
    parameter.upper = number(node.items[1], subject, parameter);
    if (!(parameter.lower < parameter.upper))
      return fault(node.mark, subject,
                   fmt::format("the bounds are the wrong way round: {} is not below {}", node.items[0].text,
                               node.items[1].text));
    if (parameter.start < parameter.lower || parameter.start > parameter.upper)
      fault(node.mark, subject,
            fmt::format("the start, {}, is outside of the bounds [{}, {}]; it must lie within them", start,
                        node.items[0].text, node.items[1].text));
  }

  void read_scale(const Node* node, const std::string& subject, FitParameter& parameter) {
    if (node) {
      parameter.scale = number(*node, subject, parameter);
      if (!(parameter.scale > 0.0))
        fault(node->mark, subject, fmt::format("the scale {} is not above 0", node->text));
    } else if (parameter.start != 0.0) {
      parameter.scale = std::abs(parameter.start);
    } else if (parameter.bounded()) {
      parameter.scale = 0.1 * (parameter.upper - parameter.lower);
    }
  }

  void read_comparisons() {
    const Node* list = node_.find("compare");
    if (!list || !list->is_list() || list->items.empty())
      return fault(list ? list->mark : node_.mark, "fit.compare",
                   "is a list of what is compared: [{model: rig.x, measured: record.x}]");
    for (const Node& item : list->items)
      if (is_map(item, comparison_keys, "fit.compare", "it", "{model: rig.x, measured: record.x}"))
        read_comparison(item);
  }

  std::optional<Formula> formula(const Node& map, const char* key) {
    const Node* node = map.find(key);
    return node ? read_formula(*node, names_, std::string("fit.compare.") + key, faults_) : std::nullopt;
  }

  void read_comparison(const Node& map) {
    for (const char* key : {"model", "measured"})
      if (!map.find(key))
        fault(map.mark, "fit.compare", fmt::format("'{}' is missing: {{model: .., measured: ..}}", key));
    auto measured = formula(map, "measured");
    const Node* model_node = map.find("model");
    auto model = model_node ? read_series(*model_node, names_, "fit.compare.model", faults_) : std::nullopt;
    std::vector<Series> against = series(map, "against");
    auto weight = formula(map, "weight"), where = formula(map, "where");
    bool free_offset = false;
    if (const Node* offset = map.find("offset")) {
      if (offset->text != "free")
        fault(offset->mark, "fit.compare.offset", "is 'offset: free': the mean difference is no error");
      free_offset = true;
    }
    if (!model || !measured) return;
    const auto& dimension = model->formula.dimension;
    if (dimension && measured->dimension && *dimension != *measured->dimension)
      fault(map.mark, "fit.compare",
            fmt::format("'{}' is in {}, but '{}' is in {}", model->formula.text, si_name(*dimension),
                        measured->text, si_name(*measured->dimension)));
    std::vector<const Formula*> together{&model->formula, &*measured, weight ? &*weight : nullptr,
                                         where ? &*where : nullptr};
    for (const Series& one : against) together.push_back(&one.formula);
    const std::size_t recording = common_recording(together, names_, map, "fit.compare", faults_);
    request_.comparisons.push_back({std::move(*model),
                                    std::move(*measured),
                                    std::move(weight),
                                    std::move(where),
                                    free_offset,
                                    recording,
                                    {names_.file, map.mark},
                                    std::move(against)});
  }

  /// One expression or a list of them.
  std::vector<Series> series(const Node& map, const char* key) {
    std::vector<Series> all;
    const Node* node = map.find(key);
    if (!node) return all;
    const std::vector<Node> one{*node};
    for (const Node& item : node->is_list() ? node->items : one)
      if (auto read = read_series(item, names_, std::string("fit.compare.") + key, faults_))
        all.push_back(std::move(*read));
    return all;
  }

  void read_curves(const Node& list) {
    if (!list.is_list())
      return fault(list.mark, "fit.curves", "is a list: [{y: c1*i + c0, over: {i: [0, 1]}, data: current}]");
    for (const Node& item : list.items)
      if (auto curve = read_fit_curve(item, names_, all_, faults_))
        request_.curves.push_back(std::move(*curve));
  }

  void read_hold_out(const Node& node) {
    request_.hold_out = read_formula(node, names_, "fit.hold_out", faults_);
    if (!request_.hold_out) return;
    for (const std::string& column : request_.hold_out->columns)
      if (!is_swept(column))
        fault(node.mark, "fit.hold_out",
              fmt::format("'{}' is no swept parameter, and only these tell whole records apart", column));
  }

  void read_loss() {
    if (const Node* loss = node_.find("loss")) {
      const Keys words{"none", "huber", "cauchy"};
      const auto found = std::find(words.begin(), words.end(), loss->text);
      if (found == words.end())
        return fault(loss->mark, "fit.loss",
                     fmt::format("there is no loss '{}'; take none, huber or cauchy", loss->text));
      request_.loss = static_cast<FitLoss>(found - words.begin());
    }
    const Node* width = node_.find("width");
    if (!width) return;
    const auto read = read_number(*width, names_, "fit.width", faults_);
    if (read && !(read->value > 0.0))
      fault(width->mark, "fit.width", fmt::format("{} is not allowed; it must be above 0", width->text));
    if (request_.loss == FitLoss::none) fault(width->mark, "fit.width", "goes with 'loss: huber' or cauchy");
    if (read) request_.width = read->value;
  }

  void read_global(const Node& node) {
    const std::string subject = "fit.global";
    if (!is_map(node, global_keys, subject, "it", "{population: 40, generations: 60}")) return;
    GlobalSearch global;
    global.population = whole(node, "population", 4, 100'000, global.population, subject);
    global.generations = whole(node, "generations", 1, 1'000'000, global.generations, subject);
    request_.global = global;
    for (const FitParameter& parameter : request_.parameters)
      if (!parameter.bounded())
        faults_.add({parameter.place,
                     "fit.parameters." + parameter.name,
                     "has no bounds, between which 'global' searches; give them",
                     {}});
  }

  const Node& node_;
  const Names& names_;
  const Diagram& diagram_;
  Faults& faults_;
  FitRequest request_;
  std::vector<FitParameter> all_;  ///< also what the call sets, which starts there
};

}  // namespace

FitRequest read_fit(const Node& node, const Names& names, const Diagram& diagram, Faults& faults) {
  return Reader(node, names, diagram, faults).read();
}

}  // namespace stepwire
