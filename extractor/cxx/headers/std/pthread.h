// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
#include <sched.h>
#include <time.h>
typedef unsigned long pthread_t;
typedef union { char size[56]; long align; } pthread_attr_t;
typedef union { char size[40]; long align; } pthread_mutex_t;
typedef union { char size[48]; long align; } pthread_cond_t;
typedef union { char size[56]; long align; } pthread_rwlock_t;
typedef union { char size[4]; int align; } pthread_mutexattr_t;
typedef union { char size[4]; int align; } pthread_condattr_t;
typedef union { char size[8]; int align; } pthread_rwlockattr_t;
typedef union { char size[32]; long align; } pthread_barrier_t;
typedef int pthread_spinlock_t;
typedef int pthread_once_t;
typedef unsigned int pthread_key_t;
#define PTHREAD_MUTEX_INITIALIZER {{0}}
#define PTHREAD_COND_INITIALIZER {{0}}
#define PTHREAD_RWLOCK_INITIALIZER {{0}}
#define PTHREAD_RECURSIVE_MUTEX_INITIALIZER_NP {{0}}
#define PTHREAD_ONCE_INIT 0
enum { PTHREAD_CREATE_JOINABLE, PTHREAD_CREATE_DETACHED, PTHREAD_MUTEX_NORMAL = 0, PTHREAD_MUTEX_RECURSIVE = 1,
  PTHREAD_MUTEX_ERRORCHECK = 2, PTHREAD_MUTEX_DEFAULT = 0,
  PTHREAD_PROCESS_PRIVATE = 0, PTHREAD_PROCESS_SHARED = 1, PTHREAD_EXPLICIT_SCHED = 1, PTHREAD_INHERIT_SCHED = 0, PTHREAD_CANCEL_ENABLE = 0,
    PTHREAD_CANCEL_DISABLE = 1,
  PTHREAD_CANCEL_DEFERRED = 0, PTHREAD_CANCEL_ASYNCHRONOUS = 1, PTHREAD_PRIO_INHERIT = 1, PTHREAD_SCOPE_SYSTEM = 0 };
#ifdef __cplusplus
extern "C" {
#endif
int pthread_create(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
int pthread_join(pthread_t, void**); int pthread_detach(pthread_t); int pthread_cancel(pthread_t); void pthread_exit(void*);
  pthread_t pthread_self(void);
int pthread_equal(pthread_t, pthread_t); int pthread_kill(pthread_t, int); int pthread_setname_np(pthread_t, const char*);
  void pthread_testcancel(void); int pthread_yield(void);
int pthread_setcancelstate(int, int*); int pthread_setcanceltype(int, int*); int pthread_once(pthread_once_t*, void (*)(void));
int pthread_attr_init(pthread_attr_t*); int pthread_attr_destroy(pthread_attr_t*); int pthread_attr_setdetachstate(pthread_attr_t*, int);
  int pthread_attr_setstacksize(pthread_attr_t*, size_t);
int pthread_attr_setschedpolicy(pthread_attr_t*, int); int pthread_attr_setschedparam(pthread_attr_t*, const struct sched_param*);
  int pthread_attr_setinheritsched(pthread_attr_t*, int);
int pthread_attr_setscope(pthread_attr_t*, int);
int pthread_setschedparam(pthread_t, int, const struct sched_param*); int pthread_getschedparam(pthread_t, int*, struct sched_param*);
  int pthread_setaffinity_np(pthread_t, size_t, const cpu_set_t*);
int pthread_mutex_init(pthread_mutex_t*, const pthread_mutexattr_t*); int pthread_mutex_destroy(pthread_mutex_t*);
  int pthread_mutex_lock(pthread_mutex_t*);
int pthread_mutex_trylock(pthread_mutex_t*); int pthread_mutex_unlock(pthread_mutex_t*);
  int pthread_mutex_timedlock(pthread_mutex_t*, const struct timespec*);
int pthread_mutexattr_init(pthread_mutexattr_t*); int pthread_mutexattr_settype(pthread_mutexattr_t*, int);
  int pthread_mutexattr_destroy(pthread_mutexattr_t*);
int pthread_mutexattr_setpshared(pthread_mutexattr_t*, int);
int pthread_cond_init(pthread_cond_t*, const pthread_condattr_t*); int pthread_cond_destroy(pthread_cond_t*);
  int pthread_cond_wait(pthread_cond_t*, pthread_mutex_t*);
int pthread_cond_timedwait(pthread_cond_t*, pthread_mutex_t*, const struct timespec*); int pthread_cond_signal(pthread_cond_t*);
  int pthread_cond_broadcast(pthread_cond_t*);
int pthread_rwlock_init(pthread_rwlock_t*, const pthread_rwlockattr_t*); int pthread_rwlock_destroy(pthread_rwlock_t*);
  int pthread_rwlock_rdlock(pthread_rwlock_t*);
int pthread_rwlock_wrlock(pthread_rwlock_t*); int pthread_rwlock_unlock(pthread_rwlock_t*); int pthread_rwlock_tryrdlock(pthread_rwlock_t*);
  int pthread_rwlock_trywrlock(pthread_rwlock_t*);
int pthread_key_create(pthread_key_t*, void (*)(void*)); void* pthread_getspecific(pthread_key_t);
  int pthread_setspecific(pthread_key_t, const void*);
#ifdef __cplusplus
}
#endif
