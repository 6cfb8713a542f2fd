/* Interface of the drivers of Stepwire: plain C, version 1. A driver is a shared object `NAME.so` that includes this
   file alone and exports one function, `stepwire_driver_v1`.

   A process of its own opens each device and closes it before another process uses it. Calls of a device come from one
   thread at a time, in this order: open, channels, start, then any number of read, write, safe and wait, then stop and
   close. Between start and stop a driver neither allocates memory nor waits longer than it states, and its functions
   return in bounded time. No exception leaves a function. */
#ifndef STEPWIRE_DRIVER_H
#define STEPWIRE_DRIVER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define STEPWIRE_DRIVER_VERSION 1

/* Directions, as the program sees them: an input is read from the device. */
enum { STEPWIRE_INPUT = 0, STEPWIRE_OUTPUT = 1 };

/* Results of read, write, safe and wait. */
enum {
  STEPWIRE_OK = 0,
  STEPWIRE_STALE = 1,  /* nothing new for longer than the device's limit; the values are the last ones */
  STEPWIRE_FAILED = 2, /* the device does not answer, or refuses */
  STEPWIRE_ENDED = 3   /* a record is at its end */
};

/* A setting of a device, from the file of the rig. */
typedef struct stepwire_setting {
  const char* key;
  const char* value;
} stepwire_setting;

/* A setting that a driver knows; `otherwise` is its default, NULL if it is required. */
typedef struct stepwire_known_setting {
  const char* key;
  const char* doc;
  const char* otherwise;
} stepwire_known_setting;

/* A channel of an open device. Values are in `unit`; "" is a pure number. Beyond least and most the device has no
   values; infinities where it has no limits. */
typedef struct stepwire_channel {
  const char* name;
  int direction;
  const char* kind; /* "analog", "digital", "counter", "number" */
  const char* unit;
  double least, most;
  const char* doc;
} stepwire_channel;

/* The functions of a driver. `error` of size `size` receives one sentence where a function fails. */
typedef struct stepwire_driver {
  int version;
  const char* name;
  const char* doc;
  const stepwire_known_setting* settings; /* ends with a key of NULL */

  /* Opens a device without moving anything; NULL on failure. A sentence on a value that makes no sense names its
     setting in the words `the setting 'KEY'`, and is told as a fault of the rig file. */
  void* (*open)(const stepwire_setting* settings, size_t count, char* error, size_t size);
  /* Returns the number of channels, and their table, which lives until close. */
  size_t (*channels)(void* device, const stepwire_channel** table);
  /* Begins; `safe` has a value for each output in the order of the table. Returns 0, or -1 on failure. */
  int (*start)(void* device, int64_t period_ns, const double* safe, char* error, size_t size);
  /* Writes the present value of each input, in the order of the table. */
  int (*read)(void* device, double* values);
  /* Sets each output, in the order of the table. */
  int (*write)(void* device, const double* values);
  /* Sets each output to its safe value. */
  int (*safe)(void* device);
  /* Waits for the next sample of a device that is a clock, at most `limit_ns`. Returns the number of samples since the
     call before, 0 after the limit, -1 on failure. NULL: the device is no clock. */
  int (*wait)(void* device, int64_t limit_ns);
  /* Ends; the outputs keep their values, which are the safe ones by then. */
  void (*stop)(void* device);
  void (*close)(void* device);
  /* Writes one line with counts, such as lost packets, between start and close; "" without any. A line that begins
     with "failed: " has the reason of a failure, such as a record that is not whole; the command ends with 3. The
     counts follow behind a line break. */
  void (*report)(void* device, char* text, size_t size);
  /* Writes what is plugged in, one line each; "" for nothing. May be NULL. */
  void (*list)(char* text, size_t size);
  /* Returns 1 once a first value has come since the start, else 0, or -1 on failure. NULL: read has values at once. */
  int (*ready)(void* device);
} stepwire_driver;

/* The one function that a driver exports. */
#ifdef __GNUC__
__attribute__((visibility("default")))
#endif
const stepwire_driver* stepwire_driver_v1(void);

#ifdef __cplusplus
}
#endif

#endif
