// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/group_text.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace tetrarch::algebra {
namespace {

constexpr std::size_t most_letters = 1'000'000;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}

class Parser {
public:
  Parser(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  Presentation presentation() {
    expect('<');
    if (next() != '|') read_generators();
    expect('|');
    if (next() != '>') read_relators();
    expect('>');
    if (next() != 0) fail("the end of the presentation");
    return std::move(result_);
  }

private:
  /// The next character that is no blank, which stays where it is; 0 at the end.
  char next() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!take(c)) fail(std::string("'") + c + "'");
  }

  [[noreturn]] void fail(const std::string& expected) {
    const char c = next();
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    throw InputError({source_, static_cast<int>(line)},
                     (c == 0 ? std::string("the text ends") : "found " + in_quotes(text_.substr(at_, 1))) +
                         ", expected " + expected);
  }

  /// A letter and the digits after it.
  std::string_view name() {
    next();
    const std::size_t first = at_++;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    return text_.substr(first, at_ - first);
  }

  void read_generators() {
    do {
      if (!is_lower(next())) fail("a generator (a lower-case letter, perhaps with digits)");
      const std::size_t before = at_;
      if (generators_.emplace(name(), result_.generators + 1).second) {
        ++result_.generators;
      } else {
        at_ = before;
        fail("a generator that is not listed yet");
      }
    } while (take(','));
  }

  void read_relators() {
    do read_relations();
    while (take(','));
  }

  /// A word; or equal ones, of which each says that the first times its inverse is 1.
  void read_relations() {
    const Word first = word();
    if (next() != '=') {
      result_.relators.push_back(first);
      return;
    }
    while (take('=')) {
      Word relator = first;
      const Word other = word();
      if (relator.size() + other.size() > most_letters) fail("no relator of more than a million letters");
      for (auto letter = other.rbegin(); letter != other.rend(); ++letter) relator.push_back(-*letter);
      result_.relators.push_back(std::move(relator));
    }
  }

  /// The generator or inverse that stands next.
  int letter() {
    const std::size_t before = at_;
    std::string spelled(name());
    const bool inverse = is_upper(spelled[0]);
    if (inverse) spelled[0] = static_cast<char>(spelled[0] - 'A' + 'a');
    const auto found = generators_.find(spelled);
    if (found == generators_.end()) {
      at_ = before;
      fail("a generator that is listed before the bar");
    }
    return inverse ? -found->second : found->second;
  }

  int exponent() {
    if (!take('^')) return 1;
    next();
    int value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("an exponent");
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  Word word() {
    Word word;
    if (take('1')) return word;
    if (!is_lower(next()) && !is_upper(next())) fail("a word");
    while (is_lower(next()) || is_upper(next())) {
      const int base = letter();
      const int power = exponent();
      const auto times = static_cast<std::size_t>(std::abs(static_cast<long long>(power)));
      if (word.size() + times > most_letters) fail("no word of more than a million letters");
      word.insert(word.end(), times, power < 0 ? -base : base);
      if (take('*') && !is_lower(next()) && !is_upper(next())) fail("a letter after '*'");
    }
    return word;
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  std::map<std::string, int, std::less<>> generators_;
  Presentation result_;
};

} // namespace

Presentation parse_presentation(std::string_view text, const std::string& source) {
  return Parser(text, source).presentation();
}

} // namespace tetrarch::algebra
