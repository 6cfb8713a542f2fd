/* A driver of one's own, with what is installed: an input of 2.5 V and an output that nothing is connected to. */
#include <stepwire/driver.h>
#include <string.h>

static const stepwire_channel channels_of_level[] = {
    {"level", STEPWIRE_INPUT, "analog", "V", -10.0, 10.0, "of a tank"},
    {"valve", STEPWIRE_OUTPUT, "analog", "V", 0.0, 5.0, ""}};
static const stepwire_known_setting settings[] = {{NULL, NULL, NULL}};
static int device;

static void* open_level(const stepwire_setting* given, size_t count, char* error, size_t size) {
  (void)given, (void)count, (void)error, (void)size;
  return &device;
}
static size_t channels(void* of, const stepwire_channel** table) {
  (void)of;
  *table = channels_of_level;
  return 2;
}
static int start(void* of, int64_t period_ns, const double* safe, char* error, size_t size) {
  (void)of, (void)period_ns, (void)safe, (void)error, (void)size;
  return 0;
}
static int read_level(void* of, double* values) {
  (void)of;
  values[0] = 2.5;
  return STEPWIRE_OK;
}
static int write_valve(void* of, const double* values) { return (void)of, (void)values, STEPWIRE_OK; }
static int safe(void* of) { return (void)of, STEPWIRE_OK; }
static void stop(void* of) { (void)of; }
static void report(void* of, char* text, size_t size) {
  (void)of;
  strncpy(text, "the tank is half full", size);
}

const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver = {STEPWIRE_DRIVER_VERSION, "level", "a tank", settings, open_level, channels, start,
                                         read_level, write_valve, safe, NULL, stop, stop, report, NULL};
  return &driver;
}
