// Preloaded into the program by tests: a wall clock that stands in the year 2100 and jumps by a day, forth and back, each
// time it is read. The steady clock is left alone.
#define _GNU_SOURCE
#include <sys/time.h>
#include <time.h>
#include <unistd.h>
#include <sys/syscall.h>

static time_t next(void) {
  static int calls = 0;
  return 4118000000 + (++calls % 2) * 86400;
}

time_t time(time_t* where) {
  const time_t now = next();
  if (where) *where = now;
  return now;
}

int gettimeofday(struct timeval* restrict where, void* restrict zone) {
  (void)zone;
  where->tv_sec = next();
  where->tv_usec = 0;
  return 0;
}

int clock_gettime(clockid_t clock, struct timespec* where) {
  if (clock != CLOCK_REALTIME) return (int)syscall(SYS_clock_gettime, clock, where);
  where->tv_sec = next();
  where->tv_nsec = 0;
  return 0;
}
