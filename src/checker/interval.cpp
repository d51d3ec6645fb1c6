// SPDX-License-Identifier: GPL-2.0-or-later
#include "interval.hpp"

namespace tetrarch::checker {

thread_local mpfr_prec_t Interval::bits = 64;

Interval::Interval(const std::string& text) {
  mpfi_init2(x_, bits);
  mpfr_strtofr(&x_->left, text.c_str(), nullptr, 0, MPFR_RNDD);
  mpfr_strtofr(&x_->right, text.c_str(), nullptr, 0, MPFR_RNDU);
}

Interval Interval::middle() const {
  Interval result;
  mpfr_t m;
  mpfr_init2(m, bits);
  mpfi_mid(m, x_);
  mpfi_set_fr(result.x_, m);
  mpfr_clear(m);
  return result;
}

} // namespace tetrarch::checker
