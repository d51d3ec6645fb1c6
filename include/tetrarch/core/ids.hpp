// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Global ids (classes of local simplices) as distinct types, and tables indexed by them.
///
/// An `EdgeId` is not a `FaceId` and not an `int`: comparing or mixing them does not compile. Data about
/// edges lives in a `Table<EdgeId, T>` beside the triangulation, never inside it.

#include <compare>
#include <cstddef>
#include <vector>

namespace tetrarch {

/// The number of a class; ids of different kinds are different types.
template <class Kind>
struct Id {
  int value = -1;

  constexpr Id() = default;
  constexpr explicit Id(int v) : value(v) {}
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexKind>;
using EdgeId = Id<struct EdgeKind>;
using FaceId = Id<struct FaceKind>;

/// A vector that only its own kind of id can index.
template <class Key, class T>
class Table {
public:
  Table() = default;
  explicit Table(int size, const T& value = T()) : data_(static_cast<std::size_t>(size), value) {}
  explicit Table(std::vector<T> data) : data_(std::move(data)) {}

  int size() const { return static_cast<int>(data_.size()); }
  decltype(auto) operator[](Key k) { return data_[static_cast<std::size_t>(k.value)]; }
  decltype(auto) operator[](Key k) const { return data_[static_cast<std::size_t>(k.value)]; }
  auto begin() { return data_.begin(); }
  auto end() { return data_.end(); }
  auto begin() const { return data_.begin(); }
  auto end() const { return data_.end(); }
  const std::vector<T>& values() const { return data_; }
  friend bool operator==(const Table&, const Table&) = default;

private:
  std::vector<T> data_;
};

/// All ids 0 .. count-1, for `for (EdgeId e : all<EdgeId>(skeleton.edge_count()))`.
template <class Key>
class all {
public:
  explicit constexpr all(int count) : count_(count) {}
  struct iterator {
    int at;
    constexpr Key operator*() const { return Key(at); }
    constexpr iterator& operator++() {
      ++at;
      return *this;
    }
    friend constexpr bool operator==(iterator, iterator) = default;
  };
  constexpr iterator begin() const { return {0}; }
  constexpr iterator end() const { return {count_}; }

private:
  int count_;
};

} // namespace tetrarch
