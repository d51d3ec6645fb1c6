#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records what Regina calls small circle bundles, for tests/bundle/circle_bundle_test.cpp.

Usage: /usr/bin/python3 tests/oracle/record_bundles.py > tests/oracle/regina_bundles.txt
(Debian's regina-normal; its module imports only in the system's own Python.)

One bundle a line, fields separated by tabs: signature, what it is meant to be, Regina's name of it. The signatures
are those of tests/bundle/bundles.hpp, small_bundles(); Regina simplifies a triangulation first, and tries a few times
where it then has no name.
"""
import regina

BUNDLES = [
    ("sphere, e = 0", "mvLLwPMQQedfjhgkiljlklrcuagfrctruoa"),
    ("sphere, e = 1", "mvLLwPAQQedfjhgkiljlklrcuagfvcqrpoq"),
    ("sphere, e = 2", "mvLLwPAQQedfihgkjljkllrcutgfvrqjkaq"),
    ("sphere, e = 3", "svLLwPPzwAMQQedfihkljjmonqqpprrrrcutgvarjqtoplrvips"),
    ("torus, e = 0", "gvLQQedfedffrwawrhh"),
    ("torus, e = 1", "gvLQQcdefeffnwnpkhe"),
    ("torus, e = 2", "mvLLwPPQQedfihkjljkjllrcutgvnurkjdd"),
    ("genus 2, e = -2", "svLAvQAwMvPQQedfijjgikjmorqpqprrrwahakwvirbpcfvrwfw"),
    ("genus 2, e = 0", "svLAvQALMvMQQedfijjgikjloprqqrrqrwahakwvarrprfsgrff"),
    ("genus 2, e = 1", "svLALQzwMLLQQedfggihiikloqprrqqrrwapltrnnraadtlrwkk"),
    ("genus 3, e = -4", "EvLAvQAwMvPwQMMzLvPQQedfijjgikjmorqpsrrutuwyADBCCBDDrwahakwvirbpcfwafwnokfmtthpjsjc"),
    ("projective plane, e = 1",
     "EvLvwLMvLAvAAvAMQQQQQefjhmkqlvproAsyuBwDxvAzyDBCzACDrutgvctjaqgfaouctvpkjxqhiqqrkkb"),
    ("projective plane, e = 2",
     "EvLvwLMvLAvAAvAMQQQQQefjhmkqlvprozsyuBDwxvzAyDCBAACDrutgvctjaqgfpouctdjkjeehdmufwfb"),
    ("projective plane, e = 3",
     "EvLvwLMvLAvAAvAMQQQQQefjhmkqluprozsyvBwDxvAzyDBCAACDrutgvctjuqgfpoujtvpkrlmhiqqfwkb"),
    ("Klein bottle, e = 0", "gLALQbcceffflpkktua"),
    ("Klein bottle, e = 1", "gLALQbccfefflpkusue"),
    ("three crosscaps, e = -1", "mLALLPALQbcceghgiilklllpkkljfdlptoc"),
]


def name(signature):
    for _ in range(20):
        tri = regina.Triangulation3.fromIsoSig(signature)
        tri.intelligentSimplify()
        known = regina.StandardTriangulation.recognise(tri)
        if known and known.manifold():
            return known.manifold().name()
        signature = tri.isoSig()
    return "?"


print("# Regina %s" % regina.versionString())
for meant, signature in BUNDLES:
    print("%s\t%s\t%s" % (signature, meant, name(signature)))
