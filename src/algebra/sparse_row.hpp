// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A row of a sparse matrix: its entries that are not zero, by column.
///
/// Short rows are sorted lists. A row that has grown long becomes a search tree, so that subtracting a short
/// row from it costs by the length of the short one: a generator that is in every relation is changed once
/// for each relation, and would cost the square otherwise.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace tetrarch::algebra {

template <class S>
class SparseRow {
public:
  struct Entry {
    int column;
    S value;
  };

  SparseRow() = default;
  /// Sorted by column, none zero.
  explicit SparseRow(std::vector<Entry> entries) { assign(std::move(entries)); }

  std::size_t size() const { return is_long() ? tree_.size() : list_.size(); }
  const S* find(int column) const {
    if (is_long()) {
      const auto at = tree_.find(column);
      return at != tree_.end() ? &at->second : nullptr;
    }
    const auto at = first_from(list_.begin(), list_.end(), column);
    return at != list_.end() && at->column == column ? &at->value : nullptr;
  }
  /// The entry of a row that has one.
  Entry only() const {
    return is_long() ? Entry{tree_.begin()->first, tree_.begin()->second} : list_.front();
  }
  /// `visit(column, value)`, by column.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const Entry& e : list_) visit(e.column, e.value);
    for (const auto& [column, value] : tree_) visit(column, value);
  }
  /// Changes entries to `changes`, sorted by column, where 0 takes an entry away. O(changes * log size), or
  /// O(size + changes) in a short row.
  void change(const std::vector<Entry>& changes) {
    if (!is_long()) return merge(changes);
    for (const Entry& e : changes) {
      if (e.value == 0)
        tree_.erase(e.column);
      else
        tree_.insert_or_assign(e.column, e.value);
    }
  }

private:
  /// Beyond this many entries, merging lists costs more than searching the tree.
  static constexpr std::size_t longest_list = 256;

  bool is_long() const { return !tree_.empty(); }
  template <class It>
  static It first_from(It first, It last, int column) {
    return std::lower_bound(first, last, column, [](const Entry& e, int c) { return e.column < c; });
  }
  void assign(std::vector<Entry> entries) {
    list_ = std::move(entries);
    if (list_.size() <= longest_list) return;
    for (Entry& e : list_) tree_.emplace_hint(tree_.end(), e.column, std::move(e.value));
    list_ = {};
  }
  void merge(const std::vector<Entry>& changes) {
    std::vector<Entry> merged;
    merged.reserve(list_.size() + changes.size());
    auto old = list_.begin();
    for (const Entry& e : changes) {
      const auto next = first_from(old, list_.end(), e.column);
      std::move(old, next, std::back_inserter(merged));
      old = next != list_.end() && next->column == e.column ? next + 1 : next;
      if (e.value != 0) merged.push_back(e);
    }
    std::move(old, list_.end(), std::back_inserter(merged));
    assign(std::move(merged));
  }

  std::vector<Entry> list_;
  std::map<int, S> tree_; ///< of a long row, whose list is empty
};

} // namespace tetrarch::algebra
