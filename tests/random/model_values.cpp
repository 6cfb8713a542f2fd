// Models, filters, sources, plants and devices, whose numbers have to fit each
// other.
#include <fmt/format.h>

#include "tests/random/value_tools.hpp"

namespace stepwire::random {

namespace {

/// Coefficients of a polynomial with these roots, highest power first.
std::vector<double> with_roots(const std::vector<double>& roots) {
  std::vector<double> coefficients{1.0};
  for (const double root : roots) {
    coefficients.push_back(0.0);
    for (std::size_t k = coefficients.size() - 1; k > 0; --k) coefficients[k] -= root * coefficients[k - 1];
  }
  return coefficients;
}

/// The order of a block is kept as the length of its letter n.
std::vector<double> roots_of(Making& making, double lower, double upper) {
  std::vector<double> roots;
  for (Index k = 0; k < making.size("n"); ++k) roots.push_back(making.dice().between(lower, upper));
  return roots;
}

std::string slow_denominator(Making& making) {
  return list(with_roots(roots_of(making, -10.0 * slowest(making), -slowest(making))));
}

std::string sampled_denominator(Making& making) {
  return list(with_roots(roots_of(making, -0.5, 0.9)));
}

std::string numerator(Making& making) {
  return list(some(making, making.size("n")));
}

std::string stable(Making& making) {
  const Index n = making.size("n");
  const double rate = slowest(making);
  return matrix_text(making, n, n, -6.0 * rate, -rate, rate);
}

std::string contracting(Making& making) {
  const Index n = making.size("n");
  return matrix_text(making, n, n, -0.7, 0.7, 0.2);
}

std::string covariance(Making& making, const char* letter) {
  const Index n = making.size(letter);
  return matrix_text(making, n, n, 0.5, 2.0, 0.0);
}

template <char letter>
std::string covariance_of(Making& making) {
  return covariance(making, std::string(1, letter).c_str());
}

/// Whole periods, whatever the period is: those of some_period() divide 30 steps.
std::string whole_periods(Making& making) {
  const bool has_own = making.has("every");
  const double of_period = has_own ? making.period : 30.0 * making.bench.step;
  return digits(of_period * making.dice().whole(1, has_own ? 6 : 2)) + " s";
}

std::string inverted(Making& making) {
  return list({making.bench.size(), 0.0, making.bench.size(), making.dice().between(-0.2, 0.2)});
}

std::string gauges(Making& making) {
  return matrix_text(making, 6, 6, 0.8, 1.2, 0.05);
}

}  // namespace

const std::map<std::string, SpecialValue>& model_values() {
  static const std::map<std::string, SpecialValue> values{
      {"Delay.delay", whole_periods},
      {"DiscreteLuenbergerObserver.A", contracting},
      {"DiscreteStateSpace.A", contracting},
      {"DiscreteTransferFunction.denominator", sampled_denominator},
      {"DiscreteTransferFunction.numerator", numerator},
      {"DrivenLinkage.anchors", [](Making&) -> std::string { return "[[20, 0], [0, 20], [-10, -10]]"; }},
      {"DrivenLinkage.housing_inertia", [](Making&) -> std::string { return "0.2"; }},
      {"DrivenLinkage.pin_mass", [](Making& m) { return digits(m.bench.size()); }},
      {"DrivenLinkage.rod_centre", [](Making&) -> std::string { return "0.1"; }},
      {"DrivenLinkage.rod_mass", [](Making& m) { return digits(m.bench.size()); }},
      {"Fmu.file", [](Making&) -> std::string { return "unit.fmu"; }},
      {"Fmu.parameters", without},
      {"FromFile.after_end",
       [](Making& m) -> std::string { return m.dice().chance(0.5) ? "hold" : "repeat"; }},
      {"FromFile.column", [](Making&) -> std::string { return "x"; }},
      {"FromFile.file", [](Making&) -> std::string { return "record.csv"; }},
      {"FromFile.from", without},
      {"FromFile.prepare",
       [](Making& m) -> std::string { return m.dice().chance(0.5) ? "" : "[{low_pass: 100 Hz, order: 2}]"; }},
      {"FromFile.sample_time", without},
      {"FromFile.start", without},
      {"FromFile.time", without},
      {"FromFile.to", without},
      {"FromFile.unit", [](Making&) -> std::string { return "mm"; }},
      {"InversePolynomial.coefficients", inverted},
      {"InversePolynomial.range", [](Making& m) { return in_unit(m, "[-1.5, 2.5]", "'y"); }},
      {"KalmanFilter.A", contracting},
      {"KalmanFilter.P0", covariance_of<'n'>},
      {"KalmanFilter.Q", covariance_of<'n'>},
      {"KalmanFilter.R", covariance_of<'p'>},
      {"Linkage.anchors", [](Making&) -> std::string { return "[[2, 0], [0, 2], [-1, -1]]"; }},
      {"Linkage.housing_inertia", [](Making&) -> std::string { return "0.2"; }},
      {"Linkage.longest", without},
      {"Linkage.pin_mass", [](Making& m) { return digits(m.bench.size()); }},
      {"Linkage.rod_centre", [](Making&) -> std::string { return "0.1"; }},
      {"Linkage.rod_inertia", without},
      {"Linkage.rod_mass", [](Making& m) { return digits(m.bench.size()); }},
      {"Linkage.shortest", without},
      {"DrivenLinkage.longest", without},
      {"DrivenLinkage.rod_inertia", without},
      {"DrivenLinkage.shortest", without},
      {"LoadCell.calibration", gauges},
      {"LoadCellToWrench.calibration", gauges},
      {"LuenbergerObserver.A", stable},
      {"MovingAverage.window", whole_periods},
      {"Multisine.frequencies", without},
      {"Multisine.highest", [](Making& m) { return digits(6.0 * slowest(m)) + " Hz"; }},
      {"Multisine.lowest", [](Making& m) { return digits(0.25 * slowest(m)) + " Hz"; }},
      {"Multisine.period", [](Making& m) { return digits(m.bench.step * m.bench.ticks) + " s"; }},
      {"Multisine.phases", without},
      {"Pusher.points", [](Making& m) { return matrix_text(m, 3, 2, -0.5, 0.5, 0.5); }},
      {"SavitzkyGolay.derivative", whole<0, 2>},
      {"SavitzkyGolay.order", whole<2, 3>},
      {"SavitzkyGolay.window", [](Making& m) { return fmt::format("{}", 2 * m.dice().whole(2, 5) + 1); }},
      {"Sensor.bits", without},
      {"Sensor.linearity", without},
      {"StateSpace.A", stable},
      {"StraightMotion.direction", [](Making& m) { return list(some(m, m.size("d"))); }},
      {"StraightMotion.from", [](Making& m) { return list(some(m, m.size("d"))); }},
      {"TransferFunction.denominator", slow_denominator},
      {"TransferFunction.numerator", numerator},
      {"Sensor.converter_range", without},
      {"MRDamper.A", without},
      {"MRDamper.alpha", without},
      {"MRDamper.beta", without},
      {"MRDamper.c", without},
      {"MRDamper.current_range", without},
      {"MRDamper.gamma", without},
      {"MRDamper.ratio", without},
      {"MRDamper.z_max", without},
      {"MRDamper.k0", without},
      {"RotaryMRDamper.A", without},
      {"RotaryMRDamper.alpha", without},
      {"RotaryMRDamper.beta", without},
      {"RotaryMRDamper.c", without},
      {"RotaryMRDamper.current_range", without},
      {"RotaryMRDamper.gamma", without},
      {"RotaryMRDamper.ratio", without},
      {"RotaryMRDamper.z_max", without},
      {"RotaryMRDamper.k0", without},
      {"Multisine.amplitude", [](Making& m) { return m.bench.number(m.bench.size(), m.unit_of("'u")); }},
      {"Noise.power", without},
      {"TransportDelay.longest",
       [](Making& m) { return m.moving_delay ? digits(m.bench.step * 25) + " s" : std::string(); }},
      {"VariableDelay.longest", whole_periods}};
  return values;
}

}  // namespace stepwire::random
