#include "blocks/sources/multisine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "blocks/sources/own_time_declare.hpp"
#include "engine/base/math/random.hpp"
#include "engine/base/math/sum_of_squares.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double max_lines = 100'000, max_harmonics = 1e15;

SumOfSquares squares_of(const Numbers& numbers) {
  SumOfSquares squares;
  for (double number : numbers) squares.add(number);
  return squares;
}

/// Returns phases with a low crest factor (Schroeder): phi_k = -2 pi sum_{j<k} (k - j) p_j, with p the share
/// of each line in the power.
Numbers schroeder_phases(const Numbers& amplitudes) {
  const SumOfSquares all = squares_of(amplitudes);
  double turns = 0.0, power = 0.0;
  return amplitudes.map([&](double amplitude) {
    turns += power;
    const double scaled = amplitude * all.scale();
    power += scaled * scaled / all.scaled();
    return -two_pi * (turns - std::floor(turns));
  });
}

}  // namespace

void Multisine::configure(Configure& is) {
  configure_own_time(*this, is);
  lay_lines(is);
  lay_amplitudes(is);
  lay_phases(is);
}

void Multisine::lay_lines(const Configure& is) {
  if (frequencies.size() > 0) {
    omega = frequencies.map([](double f) { return two_pi * f; });
    return;
  }
  if (highest < lowest)
    is.refuse<&Multisine::highest>(
        fmt::format("{} Hz is below the lowest frequency, {} Hz", highest, lowest));
  const double near = 1e-9, first = std::ceil(lowest * period - near),
               last = std::floor(highest * period + near);
  if (!(last <= max_harmonics) || last - first > max_lines)
    is.refuse<&Multisine::period>(
        "makes more than 100000 lines, or lines beyond the 1e15th harmonic; shorten it");
  std::vector<double> found;
  for (double harmonic = std::max(first, 1.0); harmonic <= last; ++harmonic)
    if (lines == Lines::all || std::fmod(harmonic, 2.0) == 1.0) found.push_back(two_pi * harmonic / period);
  if (found.empty())
    is.refuse<&Multisine::period>(fmt::format(
        "no multiple of 1/period = {} Hz that `lines` allows lies from {} Hz to {} Hz; lengthen the period",
        1.0 / period, lowest, highest));
  omega = Numbers(found);
}

void Multisine::lay_amplitudes(const Configure& is) {
  if (amplitude.size() != 1 && amplitude.size() != omega.size())
    is.refuse<&Multisine::amplitude>(fmt::format("has {} for {}; give one for all or one for each",
                                                 text::counted(amplitude.size(), "value"),
                                                 text::counted(omega.size(), "line")));
  a = amplitude.size() == 1 ? Numbers(omega.size(), amplitude[0]) : amplitude;
  const SumOfSquares squares = squares_of(a);
  if (squares.scaled() == 0.0)
    is.refuse<&Multisine::amplitude>("is zero in every line; at least one must not be");
  if (rms > 0.0) a = a.map([&](double one) { return one * (rms / squares.root(2.0)); });
}

void Multisine::lay_phases(const Configure& is) {
  if (phases.size() > 0 && phases.size() != omega.size())
    is.refuse<&Multisine::phases>(fmt::format("has {} for {}; give one for each",
                                              text::counted(phases.size(), "value"),
                                              text::counted(omega.size(), "line")));
  if (phases.size() > 0) {
    phi = phases;
  } else if (phase == Phase::schroeder) {
    phi = schroeder_phases(a);
  } else {
    std::uint64_t line = 0;
    phi = omega.map([&](double) {
      if (phase == Phase::zero) return 0.0;
      return two_pi * to_unit_interval(random_bits(static_cast<std::uint64_t>(seed), line++));
    });
  }
}

void Multisine::declare(Declare<Multisine>& is) {
  is.block(
      "Multisine",
      {.doc = "A sum of cosines at chosen frequencies, y = sum a_k cos(2 pi f_k t + phi_k): a "
              "broad-band excitation. "
              "The frequencies are the multiples of 1/period from lowest to highest, or `frequencies`.",
       .source = "Schroeder: Synthesis of low-peak-factor signals, IEEE Trans. Inf. Theory 16, 1970, eq. 11",
       .symbol = {.curve = "M-1 0C-.85 .9 -.75 .9 -.65 .2C-.55 -.3 -.45 -.3 -.35 .3C-.25 1.2 -.15 .6 0 0C.15 "
                           "-.6 .25 -1.2 .35 -.3C.45 .3 .55 .3 .65 -.2C.75 -.9 .85 -.9 1 0"},
       .at_events = true,
       .smooth = true});
  is.parameter<&Multisine::period>({.unit = "s", .doc = "after which the signal repeats", .above = 0.0});
  is.parameter<&Multisine::lowest>({.unit = "Hz", .doc = "no line lies below", .at_least = 0.0});
  is.parameter<&Multisine::highest>({.unit = "Hz", .doc = "no line lies above", .above = 0.0});
  is.parameter<&Multisine::lines>(
      {.doc = "all multiples of 1/period, or the odd ones only (to tell even nonlinearities)",
       .words = {"all", "odd"}});
  is.parameter<&Multisine::frequencies>(
      {.unit = "Hz", .doc = "of each line, in place of period, lowest, highest and lines", .above = 0.0});
  is.parameter<&Multisine::amplitude>(
      {.unit = "delta 'u", .doc = "of the lines: one number, or one for each"});
  is.parameter<&Multisine::rms>(
      {.unit = "delta 'u",
       .doc = "if above 0, all amplitudes are scaled so that the signal has this rms",
       .at_least = 0.0});
  is.parameter<&Multisine::phase>({.doc = "schroeder: low peaks; random: even over the circle, from the "
                                          "seed; zero: all cosines begin at their peak",
                                   .words = {"schroeder", "random", "zero"}});
  is.parameter<&Multisine::phases>({.unit = "rad", .doc = "of each line, in place of `phase`"});
  is.parameter<&Multisine::seed>({.doc = "of the random phases; a whole number"});
  is.output<&Multisine::y>({.unit = "'u", .doc = "the sum"});
  declare_own_time(is);
  is.derived<&Multisine::omega, &Multisine::period, &Multisine::lowest, &Multisine::highest,
             &Multisine::frequencies>();
  is.derived<&Multisine::a, &Multisine::period, &Multisine::lowest, &Multisine::highest,
             &Multisine::frequencies, &Multisine::amplitude, &Multisine::rms>();
  is.derived<&Multisine::phi, &Multisine::period, &Multisine::lowest, &Multisine::highest,
             &Multisine::frequencies, &Multisine::amplitude, &Multisine::rms, &Multisine::phases,
             &Multisine::seed>();
}

}  // namespace stepwire
