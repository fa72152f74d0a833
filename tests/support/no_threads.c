// Preloaded into the program by tests: a system that refuses every thread.
#define _GNU_SOURCE
#include <errno.h>
#include <pthread.h>

int pthread_create(pthread_t* restrict thread, const pthread_attr_t* restrict attributes, void* (*start)(void*), void* restrict argument) {
  (void)thread;
  (void)attributes;
  (void)start;
  (void)argument;
  return EAGAIN;
}
