// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Long parts of one relator inside of another: the search by which relators shorten each other.

#include "tietze.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace tetrarch::algebra {

/// A window that rolls round a cyclic word, and its hash.
class RollingHash {
public:
  /// The window that starts at letter 0. `width` is at most the word's length.
  RollingHash(const Word& word, std::size_t width) : word_(word), end_(width % word.size()) {
    for (std::size_t k = 0; k < width; ++k) {
      hash_ = hash_ * base + digit(word[k]);
      if (k > 0) top_ *= base;
    }
  }
  std::uint64_t value() const { return hash_; }
  /// On to the window that starts one letter further on.
  void roll() {
    hash_ = (hash_ - digit(word_[start_]) * top_) * base + digit(word_[end_]);
    if (++start_ == word_.size()) start_ = 0;
    if (++end_ == word_.size()) end_ = 0;
  }

private:
  static constexpr std::uint64_t base = 0x9E3779B97F4A7C15U; // any odd number with well mixed bits serves
  static std::uint64_t digit(int letter) { return static_cast<std::uint64_t>(rank_of(letter)); }
  const Word& word_;
  std::size_t start_ = 0;
  std::size_t end_;
  std::uint64_t hash_ = 0;
  std::uint64_t top_ = 1;
};

/// All windows of one width in a cyclic word and its inverse, by hash. Hashes are compared first, letters
/// always, so a collision can hide a match but not invent one.
class Windows {
public:
  Windows(const Word& word, std::size_t width) : width_(width), text_{word, inverse(word)} {
    index_.reserve(2 * word.size());
    for (int side = 0; side < 2; ++side) {
      RollingHash window(text_[side], width);
      for (std::size_t i = 0; i < word.size(); ++i, window.roll()) {
        if (!index_.try_emplace(window.value(), Place{side, i}).second) continue;
        filter_[filter_slot(window.value())] = true;
      }
    }
  }

  /// The cyclic word after its first match was replaced by what it equals in the group, or nothing.
  std::optional<Word> shortened(const Word& word) const {
    RollingHash window(word, width_);
    for (std::size_t i = 0; i < word.size(); ++i, window.roll()) {
      if (!filter_[filter_slot(window.value())]) continue;
      const auto found = index_.find(window.value());
      if (found == index_.end()) continue;
      const std::size_t length = match_length(word, i, found->second);
      if (length < width_) continue;
      const Word& text = text_[found->second.side];
      Word rest; // the relator without the letters that match
      for (std::size_t k = length; k < text.size(); ++k)
        rest.push_back(text[(found->second.start + k) % text.size()]);
      Word out = inverse(rest);
      for (std::size_t k = length; k < word.size(); ++k) out.push_back(word[(i + k) % word.size()]);
      return cyclically_reduced(out);
    }
    return std::nullopt;
  }

private:
  struct Place {
    int side;
    std::size_t start;
  };
  static std::size_t filter_slot(std::uint64_t hash) { return static_cast<std::size_t>(hash >> 52U); }
  std::size_t match_length(const Word& word, std::size_t i, Place at) const {
    const Word& text = text_[at.side];
    const std::size_t limit = std::min(text.size(), word.size());
    std::size_t length = 0;
    while (length < limit && word[(i + length) % word.size()] == text[(at.start + length) % text.size()])
      ++length;
    return length;
  }

  std::size_t width_;
  std::array<Word, 2> text_;
  std::unordered_map<std::uint64_t, Place> index_; // looked up, never walked through: its order plays no role
  std::bitset<4096> filter_;                       // most windows of other words end here
};

} // namespace tetrarch::algebra
