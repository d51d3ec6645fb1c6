// SPDX-License-Identifier: GPL-2.0-or-later
/// The codes of handlebody-knots, theta curves, handcuff graphs and links by name.
///
/// Sources. Handlebody-knots of genus two to six crossings: Ishii, Kishimoto, Moriuchi, Suzuki, "A table of
/// genus two handlebody-knots up to six crossings" (2012); each is a neighborhood of the graph. Theta curves
/// to six crossings: Litherland; Moriuchi, "An enumeration of theta-curves with up to seven crossings"
/// (2009); handcuff graphs to six crossings: Moriuchi, "A table of handcuff graphs with up to seven
/// crossings" (2007). Links to nine crossings: Thistlethwaite; numbers as in Livingston and Moore, "LinkInfo"
/// (linkinfo.sitehost. iu.edu). The images are those of the published codes; mirror images are not told apart
/// in these tables.
#include "tetrarch/diagram/names.hpp"

#include "tetrarch/diagram/read.hpp"

#include <array>
#include <span>
#include <string>

namespace tetrarch::diagram {
namespace {

/// A planar diagram code with a letter for each arc, a to z, then A to Z: crossings begin with the lower
/// strand, a dot stands before a vertex.
struct NamedCode {
  std::string_view name;
  std::string_view code;
};

constexpr std::array<NamedCode, 21> handlebody_knots{{
    {"4_1", ".acd .ikh eifj afbg gbhc jdke"},
    {"5_1", ".aje .kmd bich kglf gbha emfl idjc"},
    {"5_2", ".adg .fcm heif bjci jbka dkel lhmg"},
    {"5_3", ".adi .chm jfkg ebfc akbl lemd gihj"},
    {"5_4", ".adc .kmj albk lcmb dheg hfie fjgi"},
    {"6_1", ".aef .mol jdkc bjci mhng hbia fogn dlek"},
    {"6_2", ".ajd .cok enfm gbhc nioh afbg lemd iljk"},
    {"6_3", ".adi .cjo gkhl lfmg ebfc ambn neod jhki"},
    {"6_4", ".aid .coj emfn gchb nfog albk ldme jikh"},
    {"6_5", ".aie .hod bjck fmgn lgmh kalb neof icjd"},
    {"6_6", ".aie .hod jckb fmgn lgmh albk neof cjdi"},
    {"6_7", ".adi .cjo gkhl enfm lcmb agbf neod jhki"},
    {"6_8", ".aei .hod bgcf gjhk kdlc manb emfl iojn"},
    {"6_9", ".adk .coj gmhn lfmg ebfc ahbi iejd nkol"},
    {"6_10", ".acd .mlo ekfj minh iojn ahbg fcgb keld"},
    {"6_11", ".afe .mol jgkh bicj mcnd haib dneo fkgl"},
    {"6_12", ".adg .cof hnim bkcl lfme jakb djei nhog"},
    {"6_13", ".adg .cof mhni bkcl lfme jakb djei gnho"},
    {"6_14", ".ael .odk nboa bncm ldmc hfie jhkg fjgi"},
    {"6_15", ".ael .odk anbo mbnc cldm hfie jhkg fjgi"},
    {"6_16", ".adc .mol anbm ncob gdhe khli ekfj igjf"},
}};

constexpr std::array<NamedCode, 26> theta_curves{{
    {"0_1", ".abc .acb"},
    {"3_1", ".abc .ade bfgh hidc igfe"},
    {"4_1", ".abc .ade befg hidc ijkf gkjh"},
    {"5_1", ".abc adef bghi ijkc dkle .fmg mljh"},
    {"5_2", ".abc adef bghi jkdc lgfe mjih .kml"},
    {"5_3", ".abc adef .bfg ghic djke hlmi jmlk"},
    {"5_4", ".abc .ade bfgh hijc dklm mgfe ilkj"},
    {"5_5", ".abc .ade befg hidc jkgf klmh imlj"},
    {"5_6", ".abc .ade befg ghic dijk lmhf mlkj"},
    {"5_7", ".abc adef .bgh ijdc klme fmlg hkji"},
    {"6_1", ".abc adef ghib jkdc klme .fng hoji lonm"},
    {"6_2", ".abc adef fghb ijkc .dkl emno gpih jqml qpon"},
    {"6_3", ".abc adef bghi jkdc lmfe .gmn ojih konl"},
    {"6_4", ".abc adef bghi ijkc dlme fmng nojh .kol"},
    {"6_5", ".abc .ade bfgh hidc jkfe lmig nokj onml"},
    {"6_6", ".abc adef .bfg hidc jkle glkm noih onmj"},
    {"6_7", ".abc adef fghb ijdc klge mnih .jop pqlk qonm"},
    {"6_8", ".abc adef .bgh ijdc klfe lmng hoji onmk"},
    {"6_9", ".abc adef .bfg hijc dkle glmh inoj konm"},
    {"6_10", ".abc adef .bfg hijc dkle gmnh inoj koml"},
    {"6_11", ".abc .ade bfgh hijc dklm mnfe nlog iokj"},
    {"6_12", ".abc adef fghb ijkc dlme .gmn hopi jpqk lqon"},
    {"6_13", ".abc .ade bfgh hijc djkl mgfe inok lonm"},
    {"6_14", ".abc adef bghi jkdc lmne fnmg .hlo pqji rsok srqp"},
    {"6_15", ".abc .ade bfgh hijc djkl mnfe noig omlk"},
    {"6_16", ".abc .ade bfgh ijdc jkle lmnf oihg opqk mqpn"},
}};

constexpr std::array<NamedCode, 13> handcuff_graphs{{
    {"0_1", ".aab .bcc"},
    {"2_1", ".abc .ade befg gfdc"},
    {"4_1", ".abc .ade befg hidc jkgf kjih"},
    {"5_1", ".abc adef .bfg hidc ijke gklm mljh"},
    {"6_1", ".abc adef bghi jklc dlme .fng ojih konm"},
    {"6_2", ".abc adef bghi jkdc lmfe gmnh .ioj konl"},
    {"6_3", ".abc adef bghi ijkc dlme .fng nojh omlk"},
    {"6_4", ".abc adef bghi jkdc lgfe mnoh ionj .kml"},
    {"6_5", ".abc adef .bfg ghic djke hlmi jnok lonm"},
    {"6_6", ".abc .ade bfgh hijc dklm mnoe fong ilkj"},
    {"6_7", ".abc adef .bfg hidc jkle gmno ojih knml"},
    {"6_8", ".abc adef .bfg hijc dkle gmno onih mlkj"},
    {"6_9", ".abc adef .bgh ijdc klme fmlg hnoi jonk"},
}};

constexpr std::array<NamedCode, 130> links{{
    {"L2a1", "abcd dcba"},
    {"L4a1", "abcd defa bghc ehgf"},
    {"L5a1", "abcd efba fghc dhij jige"},
    {"L6a1", "abcd efga bghc dijk klfe ljih"},
    {"L6a2", "abcd efba ghdc hije fklg ilkj"},
    {"L6a3", "abcd efba ghdc ijfe klhg lkji"},
    {"L6a4", "abcd efga bghi ijkc dkle fljh"},
    {"L6a5", "abcd defa bghi ijkc ekjl lhgf"},
    {"L6n1", "abcd aefg bghi ijkc kled ljhf"},
    {"L7a1", "abcd efga bhic djke fklm mnhg nlji"},
    {"L7a2", "abcd efba fghc dijk klme gmln njih"},
    {"L7a3", "abcd defa bghc eijk klmf gmln njih"},
    {"L7a4", "abcd efba ghdc ijke fkjl lmng hnmi"},
    {"L7a5", "abcd defa bghc ehij klmf gmni jnlk"},
    {"L7a6", "abcd defa bghc eijk klmf gnih nmlj"},
    {"L7a7", "abcd defa bghi jkec lhgf imnj knml"},
    {"L7n1", "abcd efba cghi dijk klme mngf nljh"},
    {"L7n2", "abcd aefg ghib jkdc klme mnhf inlj"},
    {"L8a1", "abcd defa bghi jkec lmgf mnoh iopj kpnl"},
    {"L8a2", "abcd efga bghc dijk klme fnoh iopj lpnm"},
    {"L8a3", "abcd efga bhic djke flhg mnoi jopk lpnm"},
    {"L8a4", "abcd efga bghc dijk klme fmno pjih lpon"},
    {"L8a5", "abcd defa bghc ehij klmf gmln nopi jpok"},
    {"L8a6", "abcd efba ghdc ijke fkjl mnhg nopi lpom"},
    {"L8a7", "abcd efga bhic djke flmn nohg opji pmlk"},
    {"L8a8", "abcd efga bhic dije fklm mnog hopj kpnl"},
    {"L8a9", "abcd efga bhic dije fjkl lmng hnop pomk"},
    {"L8a10", "abcd defa bghc ehij klmf gnoi jplk ponm"},
    {"L8a11", "abcd efba ghdc ijke flmn nohg opji pmlk"},
    {"L8a12", "abcd efba ghdc ijfe klhg lmni jopk mpon"},
    {"L8a13", "abcd defa bghc ehij klgf lmni jopk mpon"},
    {"L8a14", "abcd efba ghdc ijfe klhg mnji oplk ponm"},
    {"L8a15", "abcd defa bghi jkec lhgf imno opkj pnml"},
    {"L8a16", "abcd defa bghc eijk klmf gmno opih pnlj"},
    {"L8a17", "abcd efba ghdc hije fklm mnog ionp plkj"},
    {"L8a18", "abcd defa bghc eijk klmf gnoh iopj lpnm"},
    {"L8a19", "abcd defa bghi ijkc eklm mngf opjh ponl"},
    {"L8a20", "abcd efga bhic djkl lmfe nohg pkji mpon"},
    {"L8a21", "abcd defa bghi jklc elkm nhgf iopj mpon"},
    {"L8n1", "abcd aefg bhij jkdc eklm mnof ophg pnli"},
    {"L8n2", "abcd aefg bhij jkdc klme mnof goph pnli"},
    {"L8n3", "abcd efba ghdc ijke klmf gmno hopi pnlj"},
    {"L8n4", "abcd efba ghdc ijke fklm gmno opih pnlj"},
    {"L8n5", "abcd efba ghdc eijk klmf gmno opih pnlj"},
    {"L8n6", "abcd aefg bhic djkl elmf gnoh pkji ponm"},
    {"L8n7", "abcd aefg bhij kldc elmf nohg pkji mpon"},
    {"L8n8", "abcd aefg hijb kldc elmf nohg ipkj mpon"},
    {"L9a1", "abcd efba ghdc hije fklm mnog iopq qrkj rpnl"},
    {"L9a2", "abcd defa bghc eijf gklm mnoh iopq qrkj rpnl"},
    {"L9a3", "abcd efga bghc dijk lmfe noih opqj kqrl mrpn"},
    {"L9a4", "abcd efga bhic djke flmn ophg qkji lqrm nrpo"},
    {"L9a5", "abcd defa bghi jklc elmn ohgf ipkj pqrm nrqo"},
    {"L9a6", "abcd efba ghdc ijke flmn nmog hpqi jrlk rqpo"},
    {"L9a7", "abcd defa bghc eijk klmf gnop poqh iqrj lrnm"},
    {"L9a8", "abcd efga bghc dijk klme fnop qjih lrnm rqpo"},
    {"L9a9", "abcd efba ghdc ijke fklm mnog hopi jqrl nrqp"},
    {"L9a10", "abcd defa bghc eijk klmf gmno opih pqrj lrqn"},
    {"L9a11", "abcd defa bfgh hijc ejkl mnog ionp pqrk lrqm"},
    {"L9a12", "abcd efba ghdc ijfe jklg hmno opqi kqpr rnml"},
    {"L9a13", "abcd defa bghc ehij klmf gnoi jpqk lrnm rqpo"},
    {"L9a14", "abcd defa bghc eijf gklh imno opqj kqpr rnml"},
    {"L9a15", "abcd efba ghdc hije fklg imno opqj kqpr rnml"},
    {"L9a16", "abcd efba fghc dijk lmge njih kopq qrml rpon"},
    {"L9a17", "abcd defa bghc ehij klmf gmln opji pqrk nrqo"},
    {"L9a18", "abcd efba ghdc ijfe klhg mnoi jonp pqrk lrqm"},
    {"L9a19", "abcd defa bghi ijkc eklm mngf opjh pqrl nrqo"},
    {"L9a20", "abcd efba ghic dijk klme fmno opqg hqrj lrpn"},
    {"L9a21", "abcd efba ghdc ijke flmn nopg hpqi jrlk rqom"},
    {"L9a22", "abcd efba ghdc ijke fklm mnog hopq qrji rpnl"},
    {"L9a23", "abcd defa bghc ehij klmf gmno opqi jrlk rqpn"},
    {"L9a24", "abcd defa bghc ehij klmf gmno pqri jrlk qpon"},
    {"L9a25", "abcd defa bghc ehij klmf gnoi jplk pqrm nrqo"},
    {"L9a26", "abcd defa bfgh hijc eklm nopg ipqj kqrl mron"},
    {"L9a27", "abcd efga bhic djfe klmg hmno pkji lqrn orqp"},
    {"L9a28", "abcd efba ghdc ijke fklm nohg opji pqrl mrqn"},
    {"L9a29", "abcd efba ghdc ijke fklm nohg pqji rnml orqp"},
    {"L9a30", "abcd efba ghdc ijke flmn oihg jpqk lqpr ronm"},
    {"L9a31", "abcd defa bghi ijkc eklm nogf pqjh rnml orqp"},
    {"L9a32", "abcd defa bghi ijkc elmn nogf opqh jqrk lrpm"},
    {"L9a33", "abcd defa bghi jkec lmnf goph ipqj kqrl mron"},
    {"L9a34", "abcd defa bghc ehij klmf gmno pqji rnlk orqp"},
    {"L9a35", "abcd defa bghc ehij jklf gmno opki pqrl mrqn"},
    {"L9a36", "abcd defa bghc eijf gklh imnj knop pqrl mrqo"},
    {"L9a37", "abcd defa bghc ehij klgf lmni jnop pqrk mrqo"},
    {"L9a38", "abcd defa bghc eijk klmf gmnh inop qrlj rqpo"},
    {"L9a39", "abcd efba ghdc ijfe klhg lmni jopq qrmk rpon"},
    {"L9a40", "abcd efba ghdc ijfe jklg hlmn opki qrnm rqpo"},
    {"L9a41", "abcd efba ghdc ijke flmn nopg hpqr rqji omlk"},
    {"L9a42", "abcd efba ghic djkl lmne fopg hpqr rkji mqon"},
    {"L9a43", "abcd defa bghi jklc elkm nhgf iopj mpqr rqon"},
    {"L9a44", "abcd defa bghc eijk lmnf gnmo pjih kqrl orqp"},
    {"L9a45", "abcd efba ghdc ijke fkjl mnog honp pqri lrqm"},
    {"L9a46", "abcd defa bghi jkec klmf gmno opqh iqrj lrpn"},
    {"L9a47", "abcd defa bghi ijkc ekjl mngf opqh lqrm nrpo"},
    {"L9a48", "abcd defa bghc eijk lmnf goih pqrj krql mpon"},
    {"L9a49", "abcd efba ghdc hije fjkl mnog ionp pqrk lrqm"},
    {"L9a50", "abcd efga bhic dije fklm mnog hpqj kqrl nrpo"},
    {"L9a51", "abcd efba fghc dijk klme gmno opih pqrj lrqn"},
    {"L9a52", "abcd efba fghc dijk klme gnop poqh iqrj lrnm"},
    {"L9a53", "abcd defa bghi jklc elmn ohgf ipqj kqrm nrpo"},
    {"L9a54", "abcd efga bhic djke flhg mnoi jonp pqrk lrqm"},
    {"L9a55", "abcd defa bghi jkec lhgf imno opqj kqpr rnml"},
    {"L9n1", "abcd defa bghc eijk lmgf hnoi jopq kqrl rpnm"},
    {"L9n2", "abcd defa bghc ijke lmgf hnoi jopq kqrl mrpn"},
    {"L9n3", "abcd defa bghc ijke lmgf hnoi jopq qrlk rpnm"},
    {"L9n4", "abcd efba ghdc ijfe gklm hmno opqi qrkj rpnl"},
    {"L9n5", "abcd efba ghdc ijfe gklm mnoh opqi jqrk rpnl"},
    {"L9n6", "abcd efba ghdc eijk klmf nohg iopq qrlj rpnm"},
    {"L9n7", "abcd efba cghi djke lmgf mnoh opqi jqrk lrpn"},
    {"L9n8", "abcd efba cghi djke lmgf mnoh iopq jqrk rpnl"},
    {"L9n9", "abcd defa bghi cjkl lmne ohgf pkji mpqr rqon"},
    {"L9n10", "abcd defa bghi cjkl elmn ohgf pkji pqrm nrqo"},
    {"L9n11", "abcd defa bghi jklc lmne ohgf ipkj mpqr rqon"},
    {"L9n12", "abcd defa bghc ijke lmnf gnmo hpqi jrlk rqpo"},
    {"L9n13", "abcd efba cghi ijkd elmn nogf pqjh qrlk rpom"},
    {"L9n14", "abcd efba cghi dijk klme mnof gopq qrjh rpnl"},
    {"L9n15", "abcd efba cghi dijk lmne nogf pqjh kqrl rpom"},
    {"L9n16", "abcd efba ghic dijk klme fmno gopq qrjh rpnl"},
    {"L9n17", "abcd efba ghdc ijke fklm gmno pqih qrlj rpon"},
    {"L9n18", "abcd efba ghdc eijk flmn opqg qrih rlkj ponm"},
    {"L9n19", "abcd aefg bhij kldc elmn ohgf opqi jqrk rpnm"},
    {"L9n20", "abcd defa ghib cjkl lkme fnhg opji pqrm nrqo"},
    {"L9n21", "abcd defa ghib cjkl lkme fnhg iopj mpqr rqon"},
    {"L9n22", "abcd defa bghi jklc elkm nhgf opji pqrm nrqo"},
    {"L9n23", "abcd efga bghi jedc klmf hmno iopq qrkj lrpn"},
    {"L9n24", "abcd efba fghc dhij klme gmno iopq qrkj rpnl"},
    {"L9n25", "abcd efba cghi djke fklm gmno opqh iqrj lrpn"},
    {"L9n26", "abcd aefg bhic djkl elmf gmno opqh rkji rqpn"},
    {"L9n27", "abcd aefg bhij kldc elmn nopf gpqh rkji rqom"},
    {"L9n28", "abcd aefg hijb kldc elmf gnoh iopq qrkj rpnm"},
}};

struct Family {
  std::string_view prefix;
  std::span<const NamedCode> members;
};
constexpr std::array<Family, 4> families{
    {{"hk", handlebody_knots}, {"theta", theta_curves}, {"handcuff", handcuff_graphs}, {"", links}}};

/// "PD[X[1, 2, 3, 4], ...]"
std::string spelled_out(std::string_view code) {
  std::string text = "PD[";
  bool first_in_node = true;
  for (const char c : code) {
    if (c == ' ') {
      text += "], ";
      first_in_node = true;
    } else {
      if (first_in_node) text += c == '.' ? "V[" : "X[";
      if (c != '.') {
        if (!first_in_node && text.back() != '[') text += ", ";
        text += std::to_string(c >= 'a' ? c - 'a' + 1 : c - 'A' + 27);
      }
      first_in_node = false;
    }
  }
  return text + "]]";
}

} // namespace

std::optional<Diagram> tabulated_diagram(std::string_view name) {
  for (const Family& family : families) {
    if (!name.starts_with(family.prefix)) continue;
    const std::string_view rest = name.substr(family.prefix.size());
    for (const NamedCode& member : family.members)
      if (member.name == rest) return read_diagram(spelled_out(member.code), std::string(name));
  }
  return std::nullopt;
}

std::vector<std::string> tabulated_names() {
  std::vector<std::string> names;
  for (const Family& family : families)
    for (const NamedCode& member : family.members)
      names.push_back(std::string(family.prefix) + std::string(member.name));
  return names;
}

} // namespace tetrarch::diagram
