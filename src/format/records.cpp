// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/records.hpp"

#include "descriptor.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <map>
#include <mutex>
#include <string_view>
#include <sys/file.h>
#include <unistd.h>

namespace tetrarch::format {
namespace {

using detail::fail;
using detail::reason;

constexpr std::string_view first_words = "tetrarch-records 1 ";
constexpr std::size_t sum_length = 8;

/// CRC-32 in eight digits of sixteen.
std::string checksum(std::string_view text) {
  boost::crc_32_type sum;
  sum.process_bytes(text.data(), text.size());
  std::array<char, sum_length + 1> digits{};
  std::snprintf(digits.data(), digits.size(), "%08x", static_cast<unsigned>(sum.checksum()));
  return {digits.data(), sum_length};
}

int opened(const std::string& path, Records::Open how) {
  const int flags = how == Records::Open::read ? O_RDONLY : O_RDWR | O_CREAT;
  const int fd = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  if (fd < 0) fail(path, "cannot be opened: " + reason(errno));
  return fd;
}

} // namespace

struct Records::State {
  std::string path;
  detail::Descriptor file;
  off_t end = 0; ///< of the last whole record
  std::map<std::string, std::string> texts;
  int damaged = 0;
  mutable std::mutex mutex;

  State(std::string name, Open how) : path(std::move(name)), file(opened(path, how)) {}

  void lock() const {
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) fail(path, "another process is writing here");
  }

  /// A line without its end: whether it is a whole record, which is kept.
  bool keep(std::string_view line) {
    if (line.size() < sum_length + 2 || line[sum_length] != ' ') return false;
    const std::string_view body = line.substr(sum_length + 1);
    const std::size_t blank = body.find(' ');
    if (blank == std::string_view::npos || checksum(body) != line.substr(0, sum_length)) return false;
    texts[std::string(body.substr(0, blank))] = std::string(body.substr(blank + 1));
    return true;
  }

  void read(const std::string& heading) {
    const std::string content = read_file(path);
    const std::string wanted = std::string(first_words) + heading;
    std::size_t at = content.find('\n');
    if (at == std::string::npos) { // nothing but the beginning of a heading
      if (!wanted.starts_with(content)) fail(path, "is no file of records");
      return;
    }
    if (const std::string_view found(content.data(), at); found != wanted)
      fail(path, found.starts_with(first_words) ? "holds '" + std::string(found.substr(first_words.size())) +
                                                      "', expected '" + heading + "'"
                                                : "is no file of records");
    end = static_cast<off_t>(++at);
    for (std::size_t next = 0; (next = content.find('\n', at)) != std::string::npos; at = next + 1) {
      if (!keep(std::string_view(content).substr(at, next - at))) ++damaged;
      end = static_cast<off_t>(next + 1);
    }
    if (at < content.size()) ++damaged; // torn
  }

  /// At the end; what cannot be written whole is taken back.
  void append(std::string_view line) {
    int error = ::lseek(file.get(), end, SEEK_SET) < 0 ? errno : detail::write_all(file.get(), line);
    if (error == 0 && ::fdatasync(file.get()) != 0) error = errno;
    if (error != 0) {
      if (::ftruncate(file.get(), end) != 0) error = errno;
      fail(path, "cannot be written: " + reason(error));
    }
    end += static_cast<off_t>(line.size());
  }
};

Records::Records(const std::string& path, const std::string& heading, Open how)
    : state_(std::make_unique<State>(path, how)) {
  if (how != Open::read) state_->lock();
  state_->read(heading);
  if (how == Open::read) return;
  if (how == Open::fresh && !state_->texts.empty()) fail(path, "holds records already, expected none");
  if (::ftruncate(state_->file.get(), state_->end) != 0) fail(path, "cannot be written: " + reason(errno));
  if (state_->end == 0) state_->append(std::string(first_words) + heading + "\n");
}

Records::~Records() = default;

const std::string* Records::find(const std::string& key) const {
  const std::lock_guard lock(state_->mutex);
  const auto found = state_->texts.find(key);
  return found == state_->texts.end() ? nullptr : &found->second;
}

int Records::size() const {
  return static_cast<int>(state_->texts.size());
}

int Records::damaged() const {
  return state_->damaged;
}

void Records::add(const std::string& key, const std::string& text) {
  if ((key + text).find('\n') != std::string::npos || key.empty() || key.find(' ') != std::string::npos)
    throw PreconditionError("a record is one line, and its key one word");
  const std::string body = key + " " + text;
  const std::lock_guard lock(state_->mutex);
  state_->append(checksum(body) + " " + body + "\n");
  state_->texts[key] = text;
}

} // namespace tetrarch::format
