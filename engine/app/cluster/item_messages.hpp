#pragma once

namespace stepwire::cluster {

/// What a message between process 0 and one that works is, by its first byte.
namespace kind {

// To process 0.
inline constexpr char hello = 'h';        ///< the process, as a number of its machine, and the machine's name
inline constexpr char wants_job = 'j';    ///< has no job, or has come to its end
inline constexpr char wants_items = 'a';  ///< of a job, after so many seconds and items; and results
inline constexpr char results = 'r';      ///< what came out of items
inline constexpr char refused = 'e';      ///< faults of what the user wrote
inline constexpr char failed = 'f';       ///< why the worker gives up
inline constexpr char died = 'd';         ///< how the worker died
inline constexpr char alive = 'l';
inline constexpr char bye = 'b';  ///< the last one

// From process 0.
inline constexpr char job = 'J';    ///< its number and what it is
inline constexpr char items = 'I';  ///< none: there are no more of this job
inline constexpr char end = 'E';

}  // namespace kind

}  // namespace stepwire::cluster
