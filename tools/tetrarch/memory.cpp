// SPDX-License-Identifier: GPL-2.0-or-later
#include "memory.hpp"

#include "command.hpp"

#include "tetrarch/format/text.hpp"
#include "tetrarch/numeric/ball.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <execinfo.h>
#include <fstream>
#include <gmp.h>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <unistd.h>

namespace tetrarch::program {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool has_shadow = true;
#else
constexpr bool has_shadow = false;
#endif

constexpr std::size_t reserve_size = std::size_t{1} << 18;
std::atomic<void*> reserve_to_go_on{nullptr};
std::atomic<void*> reserve_to_complain{nullptr};

/// Called when an allocation failed; it is tried again if this returns. At first it is tried with a reserve:
/// what tidies up needs a little, too, and may not fail (the JSON library's destructor does). Then the other
/// reserve is given back, so that there is something to complain with.
void give_up() {
  if (void* const kept = reserve_to_go_on.exchange(nullptr)) return std::free(kept);
  std::free(reserve_to_complain.exchange(nullptr));
  throw std::bad_alloc();
}

/// The destructor of the JSON library allocates, and may not throw: where both reserves are gone by then, the
/// program still ends as it does for want of memory, and does not abort.
[[noreturn]] void end_for_want() {
  if (reserve_to_complain.load() != nullptr) std::abort(); // it is something else
  format::remove_unfinished_files();
  constexpr std::string_view line = "tetrarch: out of memory\n";
  const bool is_said = ::write(STDERR_FILENO, line.data(), line.size()) > 0;
  std::_Exit(static_cast<int>(is_said ? Status::bad_input : Status::fault));
}

template <class Allocate>
void* allocated(const Allocate& allocate) {
  void* block = allocate();
  while (block == nullptr) {
    give_up();
    block = allocate();
  }
  return block;
}

// GMP, and MPFR with it, and FLINT would abort.
void* allocate(std::size_t size) {
  return allocated([size] { return std::malloc(size); });
}
void* allocate_cleared(std::size_t count, std::size_t size) {
  return allocated([count, size] { return std::calloc(count, size); });
}
void* reallocate(void* old, std::size_t size) {
  return allocated(
      [old, size] { return std::realloc(old, std::max<std::size_t>(size, 1)); }); // of 0 it gives null
}
void* gmp_reallocate(void* old, std::size_t, std::size_t size) {
  return reallocate(old, size);
}
void gmp_free(void* old, std::size_t) {
  std::free(old);
}

/// The number in a file of the system; `otherwise` where there is none ("max").
double number_in(const char* path, double otherwise) {
  std::ifstream file(path);
  double number = 0;
  return file >> number ? number : otherwise;
}

double bytes_of_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Of data and stacks, before the job begins; and the buffers that OpenBLAS takes when it is first called,
/// and each of its threads when it is first run, for which they wait for ever if there are none.
double bytes_of_program() {
  constexpr double buffer = 64e6;
  const double buffers = buffer * static_cast<double>(1 + sysconf(_SC_NPROCESSORS_ONLN));
  std::ifstream file("/proc/self/statm");
  double pages = 0;
  for (int field = 0; field < 6 && file >> pages; ++field) {
  }
  return buffers + pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void start_again_within_limits(char** arguments) {
  rlimit space{};
  constexpr const char* threads = "OPENBLAS_NUM_THREADS";
  if (getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY || std::getenv(threads) != nullptr)
    return;
  if (setenv(threads, "1", 1) == 0) execv("/proc/self/exe", arguments); // if that fails, we go on as we are
}

} // namespace

void prepare_for_want(char** arguments) {
  start_again_within_limits(arguments);
  // The C library loads what unwinds the stack when it is first needed, and aborts if it cannot.
  void* here = nullptr;
  backtrace(&here, 1);
  restore_reserves();
  if (reserve_to_go_on.load() == nullptr || reserve_to_complain.load() == nullptr) throw std::bad_alloc();
  std::set_new_handler(give_up);
  std::set_terminate(end_for_want);
  mp_set_memory_functions(allocate, gmp_reallocate, gmp_free);
  numeric::take_memory_from(allocate, allocate_cleared, reallocate, std::free);
}

double usual_memory() {
  constexpr double share = 0.9;
  const double machine = bytes_of_machine();
  const double group = std::min(number_in("/sys/fs/cgroup/memory.max", machine),
                                number_in("/sys/fs/cgroup/memory/memory.limit_in_bytes", machine));
  return share * std::min(machine, group) / 1e9;
}

void bound_memory(double gigabytes) {
  rlimit data{};
  if (has_shadow || getrlimit(RLIMIT_DATA, &data) != 0) return;
  const double most = std::min(1e9 * gigabytes + bytes_of_program(), static_cast<double>(data.rlim_max));
  data.rlim_cur = most < static_cast<double>(std::numeric_limits<rlim_t>::max()) ? static_cast<rlim_t>(most)
                                                                                 : data.rlim_max;
  setrlimit(RLIMIT_DATA, &data);
}

void restore_reserves() {
  for (std::atomic<void*>* const reserve : {&reserve_to_go_on, &reserve_to_complain})
    if (reserve->load() == nullptr) *reserve = std::malloc(reserve_size);
}

} // namespace tetrarch::program
