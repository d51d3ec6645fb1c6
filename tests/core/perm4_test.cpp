// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/perm4.hpp"

#include "tetrarch/core/tet.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

using namespace tetrarch;

TEST_CASE("permutations are ranked in the lexicographic order of their images", "[perm4]") {
  std::string text = "0123";
  int rank = 0;
  do { // std::next_permutation is the witness
    const Perm4 p(text[0] - '0', text[1] - '0', text[2] - '0', text[3] - '0');
    CHECK(p.rank() == rank);
    CHECK(p.str() == text);
    CHECK(Perm4::from_rank(rank) == p);
    ++rank;
  } while (std::next_permutation(text.begin(), text.end()));
  CHECK(rank == Perm4::count);
}

TEST_CASE("(p * q)[i] is p[q[i]], and inverse and sign follow", "[perm4]") {
  for (int a = 0; a < Perm4::count; ++a) {
    const Perm4 p = Perm4::from_rank(a);
    CHECK(p * p.inverse() == Perm4());
    for (int b = 0; b < Perm4::count; ++b) {
      const Perm4 q = Perm4::from_rank(b);
      for (int i = 0; i < 4; ++i) CHECK((p * q)[i] == p[q[i]]);
      CHECK((p * q).sign() == p.sign() * q.sign());
    }
  }
  CHECK(Perm4::swap(1, 3) == Perm4(0, 3, 2, 1));
  CHECK(Perm4::swap(1, 3).sign() == -1);
}

TEST_CASE("opposite edges sum to five and faces are read from outside", "[tet]") {
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    CHECK(edge_number[i][j] == e);
    CHECK(edge_number[j][i] == e);
    const auto [k, l] = edge_vertex[opposite_edge(e)];
    CHECK(i + j + k + l == 6);
    CHECK(edge_frame(i, j)[0] == i);
    CHECK(edge_frame(i, j)[1] == j);
    CHECK(edge_frame(j, i).sign() == 1);
  }
  for (int f = 0; f < 4; ++f) {
    const OrientedTetFace face = outward({0, f});
    CHECK(face.face() == f);
    CHECK(Perm4(f, face.a, face.b, face.c).sign() == 1);
    CHECK(face == OrientedTetFace{0, face.b, face.c, face.a});
    CHECK_FALSE(face == face.reversed());
  }
}
