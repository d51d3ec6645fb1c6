// SPDX-License-Identifier: GPL-2.0-or-later
#include "program.hpp"

int main(int, char** argv) {
  return tetrarch::program::run_program("tetrarch", argv);
}
