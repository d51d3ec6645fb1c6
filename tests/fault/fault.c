/* SPDX-License-Identifier: GPL-2.0-or-later */
/* Makes an allocation or a system call of a program fail. Preloaded by fault_test.py.
 *
 * FAULT_CALLS  "memory", or names of system calls with spaces between: open read write fsync close rename
 * stat FAULT_AT     the number of the call that fails, counted from 1 after main has begun; none: none
 * FAULT_TIMES  so many in a row fail (1)
 * FAULT_ERRNO  what a system call reports
 * FAULT_BYTES  allocations fail that would make more than so many bytes
 * FAULT_COUNT  a file that gets the number of calls counted, and the greatest number of bytes held
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <malloc.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

static const char* calls = "";
static long at = 0;
static long times = 1;
static int reported = ENOSPC;
static long most_bytes = 0;
static _Atomic long count = 0;
static _Atomic long held = 0;
static _Atomic long peak = 0;
static atomic_bool armed = 0;

static int fails(const char* name) {
  if (!armed) return 0;
  const char* found = strstr(calls, name);
  if (found == NULL) return 0;
  const long n = ++count;
  return at > 0 && n >= at && n < at + times;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

/* glibc's own names, so that nothing need be looked up, which may allocate. */
extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);
extern void __libc_free(void*);

static int too_many(size_t size) {
  return armed && most_bytes > 0 && held + (long)size > most_bytes;
}

static int wanting(size_t size) {
  return fails("memory") || too_many(size);
}

static void* none(void) {
  errno = ENOMEM;
  return NULL;
}

static void* held_now(void* block) {
  if (!armed || block == NULL) return block;
  const long now = held += (long)malloc_usable_size(block);
  long before = peak;
  while (now > before && !atomic_compare_exchange_weak(&peak, &before, now)) {
  }
  return block;
}

void* malloc(size_t size) {
  return wanting(size) ? none() : held_now(__libc_malloc(size));
}
void* calloc(size_t n, size_t size) {
  return wanting(n * size) ? none() : held_now(__libc_calloc(n, size));
}
void free(void* block) {
  if (armed && block != NULL) held -= (long)malloc_usable_size(block);
  __libc_free(block);
}
void* realloc(void* old, size_t size) {
  const size_t before = old == NULL ? 0 : malloc_usable_size(old);
  if (size > before && wanting(size - before)) return none();
  void* block = __libc_realloc(old, size);
  if (armed && (block != NULL || size == 0)) held -= (long)before;
  return held_now(block);
}
void* memalign(size_t alignment, size_t size) {
  return wanting(size) ? none() : held_now(__libc_memalign(alignment, size));
}
void* aligned_alloc(size_t alignment, size_t size) {
  return memalign(alignment, size);
}
int posix_memalign(void** to, size_t alignment, size_t size) {
  *to = memalign(alignment, size);
  return *to == NULL ? ENOMEM : 0;
}

static int error(void) {
  errno = reported;
  return -1;
}

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  return fails("open") ? error() : REAL(open)(path, flags, mode);
}
ssize_t read(int fd, void* to, size_t size) {
  return fails("read") ? error() : REAL(read)(fd, to, size);
}
ssize_t write(int fd, const void* from, size_t size) {
  return fails("write") ? error() : REAL(write)(fd, from, size);
}
int fsync(int fd) {
  return fails("fsync") ? error() : REAL(fsync)(fd);
}
int close(int fd) {
  if (!fails("close")) return REAL(close)(fd);
  REAL(close)(fd);
  return error();
}
int rename(const char* from, const char* to) {
  return fails("rename") ? error() : REAL(rename)(from, to);
}
int fstat(int fd, struct stat* about) {
  return fails("stat") ? error() : REAL(fstat)(fd, about);
}
int stat(const char* path, struct stat* about) {
  return fails("stat") ? error() : REAL(stat)(path, about);
}

static int (*the_main)(int, char**, char**);

static int counted_main(int argc, char** argv, char** envp) {
  const char* told = getenv("FAULT_CALLS");
  calls = told != NULL ? told : "";
  told = getenv("FAULT_AT");
  at = told != NULL ? atol(told) : 0;
  told = getenv("FAULT_ERRNO");
  if (told != NULL) reported = atoi(told);
  told = getenv("FAULT_TIMES");
  if (told != NULL) times = atol(told);
  told = getenv("FAULT_BYTES");
  if (told != NULL) most_bytes = atol(told);
  unsetenv("LD_PRELOAD"); /* children are not ours to hurt */
  armed = 1;
  return the_main(argc, argv, envp);
}

static void tell(void) {
  armed = 0;
  const char* path = getenv("FAULT_COUNT");
  if (path == NULL) return;
  FILE* file = fopen(path, "w");
  if (file == NULL) return;
  fprintf(file, "%ld %ld\n", (long)count, (long)peak);
  fclose(file);
}

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void* stack_end) {
  the_main = main;
  atexit(tell);
  __typeof__(&__libc_start_main) real = dlsym(RTLD_NEXT, "__libc_start_main");
  return real(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}
