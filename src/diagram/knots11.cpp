// SPDX-License-Identifier: GPL-2.0-or-later
/// The knots of eleven crossings, by their codes of Dowker and Thistlethwaite.
///
/// Source: Hoste, Thistlethwaite and Weeks, "The first 1,701,936 knots" (1998), in whose order they are; the
/// codes as they stand in Bar-Natan, Morrison and others, "The Knot Atlas" (katlas.org, KnotTheory).
#include "tetrarch/diagram/names.hpp"

#include "tetrarch/diagram/read.hpp"

#include <charconv>
#include <cstddef>

namespace tetrarch::diagram {
namespace {

constexpr std::size_t letters = 11;
constexpr std::size_t step = letters + 1; // a blank behind each

/// a is 2, b is 4, ...; large letters are negative.
constexpr std::string_view alternating =
    "bdegahjckfi bdegaicjfkh bdegaicjkfh bdegaickjfh bdegajhckfi bdehaijcgkf bdehaijckfg bdehaijckgf "
    "bdehaijkcfg bdehaijkcgf bdehajicgkf bdehajkicgf bdehakjicgf bdfagicjekh bdfagicjkeh bdfagickjeh "
    "bdfahcjekgi bdfahcjiekg bdfahicjkge bdfaicjkehg bdfaickjehg bdfaigcjkeh bdfaigckjeh bdfaihcjkge "
    "bdfaijcekgh bdfajicekgh bdfgaikjehc bdfhaijkecg bdfhaikjecg bdfiahjcekg bdgahickjef bdgahickjfe "
    "bdgahijcekf bdgahijckfe bdgahikcjfe bdgahjcfkei bdgahjickfe bdgaihjcekf bdgaijckfeh bdgaijhckef "
    "bdgaijhckfe bdgajhcfkei bdgajhcifke bdgajhicfke bdgajickfeh bdgajihcfke bdgajkicfhe bdgeahjckfi "
    "bdgeaicjkfh bdgeaickjfh bdgeajhckfi bdgfaikjehc bdghaijkefc bdghaijkfec bdhaijkcgef bdhaijkcgfe "
    "bdhajkicfge bdhajkicgfe bdhakjicgfe bdheaijckfg bdheaijckgf bdheaijkcfg bdheaijkcgf bdheajkicgf "
    "bdheakjicgf bdhfaijkecg bdhfaikjecg bdhgaijkefc bdhgaijkfec bdifahjcekg befgakijcdh befgakijdch "
    "befghaijkcd befgiacjkdh befgiackjdh befgiajdkch befgiakjdhc befgjahckdi befgjaidkch befgkaijcdh "
    "befgkaijdch befhakijcgd befhakijdgc befhakjicgd befhakjidgc befhiajcdkg befhiajdckg befhiajkdcg "
    "befhiakcjdg befhiakjdcg befhjakidcg befhkaijdgc befhkajidgc befiadjkchg befiadkjchg befigakdjch "
    "befihajkdcg befihakjdcg befjhaidkcg befjhakdgci begfajikcdh begfiacjkdh begfiackjdh begfjahckdi "
    "beghajdckfi beghajicdkf beghajidckf beghajkicdf beghajkidcf beghakjicdf beghakjidcf beghiajckfd "
    "beghiajkdfc begiahckjdf begiajckfdh begiajdkcfh begiakdjchf begifadjkch begifadkjch begifakcjdh "
    "begifakdjch begihajkdfc begjadikcfh begjahdkfci begjahidkcf begjahkdfci begjakidfch begjhacfkdi "
    "begjhaikfcd begjhaikfdc begkiajcdfh behfiajckdg behgajdckfi behgajdickf behgfaijkdc behgiadjkfc "
    "behgiajckfd behgiajkfdc behiajkdcgf behiakjdcgf behifadjkgc behifajkcdg behifajkdcg behifakjcdg "
    "behifakjdcg behigajkcfd behjakidfcg behjfaickdg behjfaidkgc behjfaikdgc behjgaikfcd behjgaikfdc "
    "beifadjkchg beifadkjchg beifahjdkgc beifgadjkch beifhajdkcg beigahjdkcf beigakdjchf beigakjdfch "
    "beigfadjkch beighacjkfd beighajdkfc beighajkfcd beihajkdcgf beihakjdcgf beihfadjkgc beihgajdkfc "
    "beihgajkcfd beijahcdkgf beijakcdfgh beikgajdcfh bejgadikcfh bfghiakcjde bfghiakcjed bfghiakjdce "
    "bfghiakjdec bfghiakjedc bfghijacdke bfghijacked bfghijadcke bfghijakdec bfghijakedc bfghikajdec "
    "bfghikajedc bfghjaeckdi bfghjakdcei bfghjiacked bfghkiajecd bfgihakjdce bfgijaekcdh bfgijaekdch "
    "bfgijhakedc bfgjhiakecd bfgjihakedc bfgjkiadech bfhgiadkjec bfhgiakcjed bfhgijacked bfhgjaeckdi "
    "bfhgjiacked bfhigjadcke bfhijakecdg bfhijakedcg bfhijgaekdc bfhijgakcde bfhijgakced bfhijgakedc "
    "bfhjgiadkec bfhjigaekdc bfhjigakedc bfhkiadcjeg bfhkiajecgd bfhkjiacged bfighakjecd bfigjakdech "
    "bfigjhadkce bfihjgadkec bfihjgakced bfijgaekdch bfijghaekcd bfijghaekdc bfijhakdecg bfijhakedcg "
    "bfijhgaekcd bfijhgaekdc bfikhadjecg bfikjgadceh bfjigaekdch bfjihakedcg bgeficajkdh bgehkiajcfd "
    "bgejkiadcfh bghijkafcde bghijkafced bghijkafedc bghikjafdce bghjikafedc bgijkcadefh bgijkhaefcd "
    "bgijkhaefdc bgijkhafecd bgijkhafedc bgikhjadfce bgjkhiafedc bgjkihafedc bgkjihafedc cdeihjkbagf "
    "cdeihkjbagf cdfagibjkeh cdfahibjkge cdfaihbjkge cdfaijbekgh cdfajibekgh cdfjhikbeag cdfjihkbeag "
    "cdgahijbkfe cdgahjibkfe cdgaijbkfeh cdgajibkfeh cdghbijakfe cdghbjiakfe cdhajkibfge cdhgbijakfe "
    "cdhgbjiakfe cefghikjbad cefgjikdbah cefijhkbadg cefjhikdbag cefjihkbadg cefkhidjbag cefkihjbagd "
    "ceghjbiakfd cegiajkbfdh cegjaibkfdh cegjbiakdfh cehfbijkadg cehfbikjadg cehfiajkbdg cehfiakjbdg "
    "cehfjaibkdg cehgbijkafd cehgiajkbfd cehgjbiakdf cehgjiakfbd cehigajbkfd cehijadbkfg cehijbdakgf "
    "cehjbidkafg cehjiadkbfg cehkbijadfg cehkbijadgf cehkbijdafg cehkbijdagf cehkiajdbfg cehkiajdbgf "
    "cehkjiadfbg ceiahjkbdgf ceiahkjbdgf ceigajkdfbh ceighbkjfad ceigjbkdfah ceikhbdjfag cejgaidkfbh "
    "cfekhijdbag cfghijbaked cfghjibaked cfgijabkedh cfgijbakedh cfgjiabkedh cfgjibakedh cfhgijakbed "
    "cfhgjiakbed cfhigbjkade cfhikbjeadg cfhjkbieagd cfhjkiaebgd cfhkiajbdge cfhkibjadeg cfhkibjaedg "
    "cfhkijadbeg cfhkjbidaeg cfhkjbieagd cfhkjiadbeg cfhkjiaebgd cfigkbjdeah cfihgbjkaed cfihkbjdaeg "
    "cfikgbjdaeh cfikhbjdeag cfikhbjedag cgeiakjbfdh cgfhjibaked cghijkabfde cghijkabfed cghijkbafde "
    "cghijkbafed cghjkiabefd cghjkiabfed cghjkibaefd cghjkibafed cghkjiabfed cghkjibafed cgihjkbdafe "
    "cgihkjbdafe chfijbkeadg chfjibkeadg cihfbajkedg cihfbakjedg cihgbajkefd cihgjbakfde cihgjbakfed "
    "dfhikbjaceg dfhjaikcbeg dghijkabcfe dghijkacbfe dghijkcbafe dghikjabcfe dghikjacbfe dghikjcbafe "
    "dgihjkbacfe dgihkjbacfe dhgikjcbafe eghijkabcdf eghijkabdcf eghijkbadcf fghijkabcde ";
constexpr std::string_view nonalternating =
    "bdegaHJcKFI bdeGahjCkfi bdeGaHJCKFI bdegaicJfKH bdegaIcjFkh bdegaIcJFKH bdeGaiCjfkh bdeGaICJFKH "
    "bdegaIcJKFH bdeGaiCjkfh bdeGaICJKFH bdeGaICKJFH bdehaIJcKFG bdeHaijCkfg bdeHaIJCKFG bdehaIJcKGF "
    "bdeHaijCkgf bdeHaIJCKGF bdeHaIJKCFG bdeHaIJKCGF bdfaGIcJEKH bdFagiCjekh bdFaGICJEKH bdfagIcJKEH "
    "bdfaGIcJKEH bdFagiCjkeh bdFaGICJKEH bdfaGIcKJEH bdFagiCkjeh bdFaGICKJEH bdfaHcJEKGI bdFahCjekgi "
    "bdFaHCJEKGI bdfaHIcJKGE bdFahiCjkge bdFaHICJKGE bdFaICJKEHG bdFaICKJEHG bdfaIHcJKGE bdFaihCjkge "
    "bdFaIHCJKGE bdfaIJcEKGH bdFaijCekgh bdFaIJCEKGH bdfaJIcEKGH bdFajiCekgh bdFaJICEKGH bdFHaIJKECG "
    "bdFHaIKJECG bdFIaHJCEKG bdgaHIcKJEF bdGahiCkjef bdGaHICKJEF bdgaHIcKJFE bdGahiCkjfe bdGaHICKJFE "
    "bdGaHIJCEKF bdgaHIJcKFE bdGahijCkfe bdGaHIJCKFE bdGaHIKCJFE bdgaHJIcKFE bdGahjiCkfe bdGaHJICKFE "
    "bdgaihJceKF bdgaIHjcEkf bdgaIHJcEKF bdGaihjCekf bdGaIHJCEKF bdGaIJCKFEH bdgaJhcifKE bdGajhCifke "
    "bdGajHCIFke bdGaJhCifKE bdGaJHCIFKE bdgaJhicfKE bdGajHICFke bdGaJHICFKE bdGaJICKFEH bdgeaIcJKFH "
    "bdHaJKICFGE bdHFaIJKECG bdHFaIKJECG bdIFaHJCEKG befGhaIjkCd befGHaIJKCD befgiajdKcH befhiaJcdKG "
    "befHIajCDkg befhiaJdcKG befHIajDCkg befJHaIDKCG begFaJikcDh begfajiKcdH begFaJiKcDH beGFaJIKCDH "
    "begfIacJKDH beGFiaCjkdh beGFIaCJKDH begfIacKJDH beGFiaCkjdh beGFIaCKJDH begfJahcKDI beGHaJKICDF "
    "beghaJKidcF beGHajkIDCf beGHaJKIDCF beGHiajCkfd beGhiajKdfC begHIajkDfc beGHIaJKDFC begiajdKcfH "
    "beGihajKdfC begihaJkdFc begIHajkDfc beGIHajKDfC beGIHaJKDFC beGjaHIDKcF begJahidkCf beGJaHIDKCF "
    "beHFiaJCkdG beHFIaJCKDG beHGfaIJKDC behGIaDjkFc beHIgajkCfd beIFaHJDKGC beiFHaJDkcG beIGHaCJKFD "
    "beIGHaJDKFC beIGHaJKFCD beiHGajDkfc beIHGaJDKFC beIJaHCDKGF beIKGaJDCFH bfgHkIaJECd bfHgiadKjeC "
    "bfHGijaCked bfHGIJaCKED bfhgJIacKED bfHGjiaCked bfHGJIaCKED bfHJGIaDKEC bfHkIaJECGd bfiGhakJecD "
    "bgEJKiaDCfH bgejkIadcFh bgEJKIaDCFH bgIJKCaDEFH cdeihJKbaGF cdeihKJbaGF cdfaHIbJKGE cdfaIJbEKGH "
    "cdfjhiKbeaG cdfjHIkbEag cdfjihKbeaG cEfghIkjBad cEFgHIkjBAd cefijhKbadG cefIJhkbaDg cEfjhIkdBag "
    "cefjihKbadG cEfkhIdjBag cEFkHIdjBAg cEghJBIakFD cEghjBiakfd ceGiajkBfdh cegjaIbkFdh cegjbIakdFh "
    "cEHfIAjkBDg cehfiaKJbdG cEHfIAkjBDg ceHfjaiBkdg cEhfjAibkdg cEhgjBiakdf cEHgJIAkFBD ceHijadBkfg "
    "cEhijAdbkfg cEhijBdakgf cEJgAIdkFBh cFHgIJAkBED cFHgJIAkBED cFhigBjkade cGeIakjBfDh cGeiakjBfdh "
    "cihgJbakfDE ";
static_assert(alternating.size() == 367 * step && nonalternating.size() == 185 * step);

std::string dt_text(std::string_view code) {
  std::string text = "DT[";
  for (const char c : code) {
    const int value = c >= 'a' ? 2 * (c - 'a' + 1) : -2 * (c - 'A' + 1);
    text += (text.back() == '[' ? "" : ", ") + std::to_string(value);
  }
  return text + "]";
}

} // namespace

std::optional<std::string> eleven_crossing_code(std::string_view name) {
  if (name.starts_with('K')) name.remove_prefix(1);
  if (!name.starts_with("11a") && !name.starts_with("11n")) return std::nullopt;
  const std::string_view table = name[2] == 'a' ? alternating : nonalternating;
  name.remove_prefix(3);
  if (name.starts_with('_')) name.remove_prefix(1);
  int number = 0;
  const auto [end, wrong] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (wrong != std::errc() || end != name.data() + name.size() || number < 1 ||
      number > static_cast<int>(table.size() / step))
    return std::nullopt;
  return dt_text(table.substr(static_cast<std::size_t>(number - 1) * step, letters));
}

std::vector<std::string> eleven_crossing_names() {
  std::vector<std::string> names;
  for (const auto& [kind, table] : {std::pair{"K11a", alternating}, {"K11n", nonalternating}})
    for (std::size_t k = 1; k <= table.size() / step; ++k) names.push_back(kind + std::to_string(k));
  return names;
}

} // namespace tetrarch::diagram
