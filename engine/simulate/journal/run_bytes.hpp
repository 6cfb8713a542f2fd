#pragma once

#include "engine/base/messages/bytes.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::journal {

using messages::all;
using messages::list;

// Serialisation of settings and ends of runs for another process. Each function writes its argument to a
// ByteWriter, or reads it from a ByteReader.

template <class Stream, class Place>
void place(Stream& stream, Place& of) {
  all(stream, of.file, of.mark.line, of.mark.column);
}

template <class Stream, class Fault>
void fault(Stream& stream, Fault& of) {
  place(stream, of.place);
  all(stream, of.subject, of.message.wrong, of.message.cure);
  list(stream, of.used_by, [&](auto& user) { place(stream, user); });
}

template <class Stream, class Setting>
void setting(Stream& stream, Setting& of) {
  all(stream, of.name, of.value, of.written, of.mark.line, of.mark.column);
}

template <class Stream, class End>
void run_end(Stream& stream, End& end) {
  list(stream, end.faults, [&](auto& one) {
    all(stream, one.block, one.port, one.time);
    fault(stream, one.fault);
  });
  list(stream, end.diagnostics, [&](auto& one) { all(stream, one.block, one.text, one.time); });
  list(stream, end.loops, [&](auto& one) {
    all(stream, one.path, one.unknowns, one.instants, one.iterations, one.most, one.unsolved,
        one.first_unsolved);
  });
  std::int64_t stopped = end.stopped;
  all(stream, end.events.located, end.events.most_in_a_step, stopped, end.ticks, end.lane_ticks,
      end.compiled_ticks);
  if constexpr (std::is_same_v<Stream, messages::ByteReader>) end.stopped = stopped != 0;
}

/// Writes or reads the columns of a table, which the reader has without rows.
template <class Stream, class Table>
void rows(Stream& stream, Table& of) {
  std::uint64_t count = of.rows();
  all(stream, count);
  for (auto& column : of.columns)
    if constexpr (std::is_same_v<Stream, messages::ByteReader>)
      stream.get(column.values, count);
    else
      stream.put(column.values);
}

}  // namespace stepwire::journal
