#include <fmt/format.h>

#include "engine/analyse/comparison/compare.hpp"

namespace stepwire::comparison {

using result::Record;

static void declare(Record<SignalDifference>& is) {
  using Signal = SignalDifference;
  is.named("SignalDifference", "Difference of a signal of two recordings; numbers are in its unit.");
  is.field("name", &Signal::name, "name of the signal");
  is.field("unit", &Signal::unit, "its unit in A, in which the numbers here are; empty without one");
  is.field("agrees", &Signal::agrees, "true if each row is within the tolerance");
  is.field("difference", &Signal::difference, "largest absolute difference, beyond the jitter");
  is.field("share", &Signal::share, "the same as a share of the largest absolute value of A");
  is.field("time", &Signal::time, "its time", "s");
  is.field("run", &Signal::run, "index of its run, of several");
  is.field("a", &Signal::a, "value of A there");
  is.field("b", &Signal::b, "value of B there");
  is.field("tolerance", &Signal::tolerance, "accepted difference");
  is.field("excess", &Signal::excess, "largest difference divided by the tolerance; null: without bound");
  is.field("rows", &Signal::rows, "number of compared rows");
  is.field("differing", &Signal::differing, "number of comparisons beyond the tolerance");
  is.field("missing", &Signal::missing, "number of comparisons with a number on one side alone");
  is.field("unpaired", &Signal::unpaired, "rows before an event of which B has a single side");
  is.field(
      "method", [](const Signal& of) { return method_name(of.method); },
      "values of B at the instants of A: rows, linear or hold");
  is.field("notes", &Signal::notes, "other lengths, and rows that are not compared");
}

void declare(Record<RecordingDifference>& is) {
  using Difference = RecordingDifference;
  is.named("RecordingDifference", "Comparison of two recordings: compare --json.");
  is.field("a", &Difference::a, "first recording, whose instants are compared");
  is.field("b", &Difference::b, "second recording");
  is.field("agrees", &Difference::agrees, "true if all signals are in both and agree");
  is.field("signals", &Difference::signals, "signals of both, the worst first");
  is.field("only_in_a", &Difference::only_in_a, "signals of A that B does not have");
  is.field("only_in_b", &Difference::only_in_b, "signals of B that A does not have");
}

std::string difference_text(const SignalDifference& signal) {
  const std::string unit = signal.unit.empty() || signal.unit == "1" ? "" : " " + signal.unit;
  const std::string run = signal.run > 0 ? fmt::format(" of run {}", signal.run + 1) : "";
  std::string text = signal.name + ": ";
  if (signal.missing > 0)
    text += fmt::format("{} rows have a number on one side alone, first at {:.6g} s", signal.missing,
                        signal.time);
  else if (signal.difference == 0.0)
    text += "no difference";
  else
    text += fmt::format("{} {:.4g}{}{} at {:.6g} s{}, {:.6g} and {:.6g}",
                        signal.differing > 0 ? "differs by" : "largest difference", signal.difference, unit,
                        signal.share ? fmt::format(" ({:.3g} %)", 100.0 * *signal.share) : "", signal.time,
                        run, signal.a, signal.b);
  if (signal.differing > 0 && signal.missing == 0)
    text += fmt::format(", beyond {:.4g}{}", signal.tolerance, unit);
  for (const std::string& note : signal.notes) text += "; " + note;
  return text;
}

}  // namespace stepwire::comparison
