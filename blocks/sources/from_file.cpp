#include "blocks/sources/from_file.hpp"

#include <fmt/format.h>

#include "blocks/records/preparation.hpp"
#include "blocks/sources/own_time_declare.hpp"
#include "blocks/sources/read_samples.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire {

template <>
struct Literal<Samples> {
  static std::string text(const Samples& samples, LiteralWriter& writer) {
    return fmt::format("{{{}, {}, {}}}", Literal<Numbers>::text(samples.time, writer),
                       Literal<Matrix>::text(samples.value, writer), writer.number(samples.interval));
  }
};

template <>
struct Literal<BandLimited> {
  static std::string text(const BandLimited& signal, LiteralWriter& writer) {
    return fmt::format("{{{}, {}}}", writer.number(signal.length),
                       Literal<Matrix>::text(signal.fine, writer));
  }
};

namespace {

void require_start(const FromFile& block, const Configure& is, double origin) {
  if (std::abs(block.offset + origin) > 1e12)
    is.refuse<&FromFile::start_>(
        fmt::format("{} s is no time of a record; stay within 1e12 s", block.offset + origin));
}

void require_inside(const FromFile& block, const Configure& is, double origin) {
  const Samples& samples = block.samples;
  const double slack = samples.slack();
  if (block.offset < samples.begin() - slack || block.offset > samples.end() + slack)
    is.refuse<&FromFile::start_>(fmt::format("{} s is not in the record, which goes from {} s to {} s in {}",
                                             block.offset + origin, samples.begin() + origin,
                                             samples.end() + origin, block.file.string()));
}

}  // namespace

void FromFile::configure(Configure& is) {
  if (column.empty()) is.refuse<&FromFile::column>("names no column; give one or a list");
  if (unit.size() > 1 && unit.size() != column.size())
    is.refuse<&FromFile::unit>(fmt::format("has {} for {}; give one for all or one for each",
                                           text::counted(unit.size(), "unit"),
                                           text::counted(column.size(), "column")));
  const auto record = read_samples(*this, is);
  samples = record->samples;
  smooth = record->smooth;
  is.size("n", static_cast<Index>(column.size()));
  offset = start_ == -open ? samples.begin() : start_ - record->origin;
  const bool periodic = interpolation == Interpolation::band_limited || after_end == AfterEnd::repeat;
  if (start_ == -open && !record->late.empty()) is.refuse<&FromFile::missing>(record->late);
  if (periodic && !record->uneven.empty()) is.refuse<&FromFile::missing>(record->uneven);
  require_start(*this, is, record->origin);
  if (!periodic) require_inside(*this, is, record->origin);
  configure_own_time(*this, is, !periodic && after_end == AfterEnd::refuse);
  if (interpolation == Interpolation::hold || samples.has_jumps()) return;
  is.smooth();
  is.skip_instants();
}

void FromFile::declare(Declare<FromFile>& is) {
  is.block(
      "FromFile",
      {.doc =
           "Plays back columns of a data file (CSV with a header line, MAT, HDF5, or MCAP): y at t is the "
           "record at t + "
           "start. "
           "Numbers become SI by their column's unit. A column without a unit is in SI; where its name ends "
           "in "
           "another one (x_mm), its unit must be said. What `prepare` lists is done first. band_limited "
           "takes the record for whole periods of a "
           "periodic signal without content above half of the sample rate, and gives that signal between the "
           "rows "
           "to 2e-13 of its amplitude.",
       .symbol = {.text = "{file|record}"},
       .at_events = true,
       .at_end = true});
  is.parameter<&FromFile::file>(
      {.doc = "path of a .csv (.tsv, .txt, .dat), .mat, .h5 or .mcap file, beside the diagram or data/...",
       .required = true});
  is.parameter<&FromFile::column>(
      {.doc = "name of the column, or a list of names for a vector; in an HDF5 "
              "or MCAP file of several runs with "
              "its group or channel, as `run-1/cart.position`, in a MAT file with its struct, "
              "as `out.signals.values`",
       .required = true});
  is.parameter<&FromFile::unit>(
      {.doc = "of the columns: one for all or one for each; left out: as the header says "
              "(`x [mm]`), SI where it says nothing"});
  is.parameter<&FromFile::time>(
      {.doc = "column with the times, which must increase, where two rows of one time "
              "are a jump; in s unless its header "
              "says else; ISO 8601 counts from the first row, as do times whose rounding in seconds would "
              "move rows (ms since 1970). Left out: `time`, in the "
              "column's group where there is none else, or `t`"});
  is.parameter<&FromFile::sample_time>(
      {.unit = "s",
       .doc = "time between rows, the first one being at 0, in place of a column of "
              "times; 0: there is such a column",
       .at_least = 0.0});
  is.parameter<&FromFile::from>({.unit = "s", .doc = "rows before this time of the record are left out"});
  is.parameter<&FromFile::to>({.unit = "s", .doc = "rows after this time of the record are left out"});
  is.parameter<&FromFile::decimal>({.doc = "decimal mark of a text file, where its numbers do not show which "
                                           "one they have; the other mark then "
                                           "parts thousands",
                                    .words = {"detect", ",", "."}});
  is.parameter<&FromFile::missing>({.doc = "an empty cell or NaN in the columns: refuse it, hold the value "
                                           "of the row before, or skip the row; where the first row is "
                                           "skipped, `from` or `start` says where the record begins",
                                    .words = {"refuse", "hold", "skip"}});
  is.parameter<&FromFile::sort>({.doc = "sorts the rows by their times; rows of one time keep their order"});
  is.parameter<&FromFile::prepare_>(
      {.doc =
           "steps, done once and in order on all rows in use before the run, so that they may look ahead: " +
           preparation_help()});
  is.parameter<&FromFile::start_>(
      {.unit = "s", .doc = "time of the record at which the run begins; left out: its first row in use"});
  is.parameter<&FromFile::interpolation>(
      {.doc = "between the rows: a straight line, the row before, or the periodic "
              "band-limited signal through evenly spaced rows",
       .words = {"linear", "hold", "band_limited"}});
  is.parameter<&FromFile::after_end>(
      {.doc = "after the last row: refuse (ends the run), hold it, or repeat: the first row "
              "follows one mean interval after the last; band_limited repeats always",
       .words = {"refuse", "hold", "repeat"}});
  is.output<&FromFile::y>({.unit = "'u", .doc = "the record"});
  is.diagnostic<&FromFile::ended>(
      {.doc = "the record is over; give after_end or an earlier stop", .ends_run = true});
  declare_own_time(is);
  is.derived<&FromFile::samples, &FromFile::sample_time, &FromFile::from, &FromFile::to>();
  is.derived<&FromFile::smooth, &FromFile::sample_time, &FromFile::from, &FromFile::to>();
  is.derived<&FromFile::offset, &FromFile::sample_time, &FromFile::from, &FromFile::to, &FromFile::start_>();
}

}  // namespace stepwire
