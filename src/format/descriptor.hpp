// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Files by POSIX calls, for those that write them: streams cannot tell why something failed.

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace tetrarch::format::detail {

/// What the system says of an errno.
inline std::string reason(int error) {
  return std::generic_category().message(error);
}

[[noreturn]] inline void fail(const std::string& path, const std::string& what) {
  throw InputError(Place{source_name(path), 0}, what, Cause::file);
}

/// An open file that closes itself; standard input stays open.
class Descriptor {
public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ > STDIN_FILENO) ::close(fd_);
  }
  int get() const { return fd_; }
  /// 0, or the errno of a close that failed: some file systems report a full disk only now.
  int close() {
    const int result = ::close(fd_);
    fd_ = -1;
    return result == 0 ? 0 : errno;
  }

private:
  int fd_;
};

/// Writes all of it where the file stands; 0 or an errno.
inline int write_all(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t done = ::write(fd, content.data(), content.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(done));
  }
  return 0;
}

} // namespace tetrarch::format::detail
