/* Layout of the shared memory of the driver `shared`, for programs of your own: plain C with the atomics of GCC and
   clang. The host creates the segment; the client is the program with the controller. */
#ifndef STEPWIRE_SEGMENT_H
#define STEPWIRE_SEGMENT_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define STEPWIRE_SEGMENT_MAGIC 0x3157535345525753ull
#define STEPWIRE_SEGMENT_MOST 64 /* channels in each direction */

/* Numbers of one writer. `lock` is odd while they change; `beat` counts the changes. */
typedef struct stepwire_numbers {
  uint32_t lock, count;
  uint64_t beat;
  int64_t time_ns; /* CLOCK_MONOTONIC of the last change */
  double values[STEPWIRE_SEGMENT_MOST];
} stepwire_numbers;

typedef struct stepwire_label {
  char name[48], unit[16];
} stepwire_label;

typedef struct stepwire_segment {
  uint64_t magic; /* written last */
  int64_t host, client; /* process ids; 0: none */
  stepwire_label to_client_labels[STEPWIRE_SEGMENT_MOST], to_host_labels[STEPWIRE_SEGMENT_MOST];
  stepwire_numbers to_client, to_host;
} stepwire_segment;

/* Writes numbers; only one thread of one process may do so. */
static inline void stepwire_put(stepwire_numbers* to, const double* values, size_t count, int64_t time_ns) {
  const uint32_t lock = __atomic_load_n(&to->lock, __ATOMIC_RELAXED) | 1u;
  __atomic_store_n(&to->lock, lock, __ATOMIC_RELAXED);
  __atomic_thread_fence(__ATOMIC_RELEASE);
  for (size_t i = 0; i < count; ++i) __atomic_store(&to->values[i], (double*)&values[i], __ATOMIC_RELAXED);
  __atomic_store_n(&to->time_ns, time_ns, __ATOMIC_RELAXED);
  __atomic_store_n(&to->beat, to->beat + 1, __ATOMIC_RELAXED);
  __atomic_store_n(&to->lock, lock + 1u, __ATOMIC_RELEASE);
}

/* Reads numbers of one change; returns its beat, 0 where none is whole within some tries (the writer ended inside). */
static inline uint64_t stepwire_get(const stepwire_numbers* from, double* values, size_t count, int64_t* time_ns) {
  for (int tries = 0; tries < 1000; ++tries) {
    const uint32_t before = __atomic_load_n(&from->lock, __ATOMIC_ACQUIRE);
    if (before & 1u) continue;
    for (size_t i = 0; i < count; ++i) __atomic_load(&from->values[i], &values[i], __ATOMIC_RELAXED);
    const int64_t time = __atomic_load_n(&from->time_ns, __ATOMIC_RELAXED);
    const uint64_t beat = __atomic_load_n(&from->beat, __ATOMIC_RELAXED);
    __atomic_thread_fence(__ATOMIC_ACQUIRE);
    if (__atomic_load_n(&from->lock, __ATOMIC_RELAXED) != before) continue;
    *time_ns = time;
    return beat;
  }
  return 0;
}

#endif
