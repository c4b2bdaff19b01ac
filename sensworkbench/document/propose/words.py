# SPDX-License-Identifier: LGPL-2.1-or-later
# ruff: noqa: E501 - tables that are read by column
"""What names say: the place of a part in a machine, and the catalogue parts that guide and drive it.

English, German, French, Italian, Spanish, Korean, Chinese and Japanese words, romanised ones too, and the part numbers
of usual rails, blocks, screws and profiles.  Only ever evidence, to be weighed against what the shapes say.
"""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache


def plain(text: str) -> str:
    """Lower case without accents, words apart: "X-Achse_Schlitten01" -> "x achse schlitten 01"."""
    text = re.sub(r"(?<=[a-zà-ÿ])(?=[A-ZÀ-Ý])", " ", str(text))
    text = text.replace("ß", "ss").replace("Ä", "Ae").replace("Ö", "Oe").replace("Ü", "Ue")
    text = text.replace("ä", "ae").replace("ö", "oe").replace("ü", "ue")
    text = "".join(c for c in unicodedata.normalize("NFKD", text) if not "\u0300" <= c <= "\u036f")
    text = unicodedata.normalize("NFKC", text).lower()
    text = re.sub(r"[^\w]+|_", " ", text)
    text = re.sub(r"(?<=[^\W\d])(?=\d)|(?<=\d)(?=[^\W\d])", " ", text)
    return " ".join(text.split())


def _words(*alternatives: str) -> re.Pattern:
    """A pattern of whole words in Latin script, and of any place for the rest; the words are as `plain` writes them."""
    found = []
    for word in " ".join(alternatives).split("|"):
        word = word.strip()
        if word:
            found.append(
                rf"\b{word}\b" if word.isascii() else unicodedata.normalize("NFKC", unicodedata.normalize("NFKD", word))
            )
    return re.compile("|".join(found))


# -- the place of a part in the machine ------------------------------------------------------------------------------
ROLES = (  # tried in this order; the first that fits is taken
    ("work", _words(
        "work ?pieces?|werkstuecke?|vi[sc]e|schraubstock|etau|morsa|mordaza|fixture|spannvorrichtung|blank|rohteil|"
        "stock|spoil ?board|waste ?board|opferplatte|martyr|heat(ed)? ?bed|print ?bed|build ?plate|bed plate|"
        "druckbett|heizbett|plateau chauffant|hot ?bed|pallet|palette|공작물|고정구|工件|ワーク|gongjian")),
    ("tailstock", _words("tail ?stock|reitstock|contre ?pointe|contropunta|contrapunta|contrapunto|심압대|尾座|心押台|weizuo")),
    ("chuck", _words("chuck|drehfutter|backenfutter|mandrin|mandrino autocentrante|plato de garras|척|卡盘|チャック|kapan|"
                     "face ?plate")),
    ("headstock", _words("head ?stock|spindelstock|poupee|poupee fixe|床头箱|主轴箱床头|cabezal fijo|testa motrice")),
    ("toolpost", _words("tool ?posts?|stahlhalter|porte outils?|torretta|turret|revolver|portautensili|portaherramientas?|"
                        "공구대|刀架|刃物台|daojia|tool ?holder block|gang tool(ing)?")),
    ("saddle", _words("saddle|kreuzschlitten|querschlitten|cross ?slide|chariot transversal|carro transversal|slitta trasversale|"
                      "planschlitten|selle|새들|床鞍|サドル|chuangan|apron")),
    ("knee", _words("knee|konsole|winkeltisch|consola|mensola|console|니이|升降台|ニー|shengjiangtai")),
    ("column", _words("columns?|staender|saeulen?|colonnes?|colonna|columna|montante|기둥|컬럼|立柱|コラム|lizhu|pillar|tower")),
    ("gantry", _words("gantry|bridges?|portals?|portique|pont|portale|ponte|puente|portico|bruecke|traverse|traversa|"
                      "cross ?beam|querbalken|querhaupt|갠트리|横梁|龙门|ガントリー?|크로스빔|longmen|hengliang|y beam|x beam")),
    ("quill", _words("quill|pinole|ram|rams|stoessel|fourreau|canotto|cannotto|滑枕|ラム|huazhen|spindle ?head|spindelkopf|"
                     "spindelkasten|fraeskopf|head|kopf|tete|testa|cabezal|주축두|主轴箱|zhuzhouxiang|spindle (mount|holder|"
                     "plate|carriage|slide|block|clamp)|spindel ?(halter|halterung|aufnahme)|router (mount|holder|plate|clamp)|"
                     "tool ?head|print ?head|druckkopf")),
    ("tool", _words("spindles?|spindeln?|broche|mandrino|elettromandrino|husillo principal|router|trim router|milling motor|"
                    "fraes ?motor|fraese|fraeser|end ?mill|cutter|cutting tool|tools?|werkzeuge?|fresa|outil|utensile|herramienta|"
                    "collet|spannzange|nozzle|duese|hot ?end|extruder|laser|dremel|makita|kress|torch|plasma|pen|pen ?holder|"
                    "主轴|主軸|スピンドル|주축|공구|刀具|工具|zhuzhou|effector|probe|messtaster")),
    ("carriage", _words("carriages?|carts?|schlitten|schlittenplatte|chariots?|carros?|carrello|carrelli|wagen|trolley|slides?|"
                        "slitta|캐리지|왕복대|滑台|滑座|溜板|キャリッジ|拖板|huatai|huazuo|tuoban|laufwagen|support schlitten|"
                        "slide ?plate")),
    ("table", _words("tables?|work ?table|tisch|maschinentisch|tavola|mesa|plateau|bancale|테이블|工作台|テーブル|gongzuotai|"
                     "tableau|t ?slot plate|x table|y table")),
    ("bed", _words("beds?|machine ?bed|maschinenbett|bett|lit|bancada|bancata|banc|베드|床身|ベッド|chuangshen|beddo")),
    ("base", _words("bases?|base ?plate|frames?|base ?frame|full frame|gestell|maschinengestell|rahmen|grundrahmen|grundplatte|"
                    "grundgestell|unter ?gestell|fuss|fuesse|legs?|feet|foot|foundation|chassis|socle|bati|cadre|structure|"
                    "basamento|telaio|struttura|bastidor|estructura|marco|cabinet|enclosure|stand|gehaeuse|ground|floor|"
                    "베이스|프레임|底座|机座|机架|框架|フレーム|ベース|土台|dizuo|jizuo|jijia|kuangjia|dodai|fureemu|bench|"
                    "static|fixed|stationary|torsion box|c frame")),
)  # fmt: skip
FIXED = {"bed", "base", "column", "headstock", "tailstock"}
MOVING = {"gantry", "carriage", "saddle", "table", "knee", "quill", "toolpost"}
VERTICAL = {"quill", "knee"}
LEVEL = {"gantry", "table", "saddle"}

_LETTER = re.compile(
    r"\b(?:axis|achse|axe|asse|eje) ?([xyz])\b|\b([xyz]) ?(?:\d+ )?(?:axis|achse|axe|asse|eje|축|軸|轴|zhou|jiku)"
    r"|(?:^|(?<!\d) |(?<=\d) (?![xyz] \d))([xyz])(?= |$)|\b([xyz])(?:achse|axis|carriage|slide|schlitten|table|tisch|car|gantry|plate|assembly)\b"
    r"|(?:축|軸|轴) ?([xyz])"
)
LATHE = _words("lathe|drehbank|drehmaschine|torno|tornio|선반|旋盘|旋盤|车床|chechuang|senban|tail ?stock|reitstock|tool ?post|"
               "stahlhalter|tour|chuck|drehfutter|turning")  # fmt: skip
CROSS_SLIDE = _words(
    "cross ?slide|planschlitten|querschlitten|chariot transversal|carro transversal|slitta trasversale|横滑板|中拖板"
)
MILL = _words(
    "table|tisch|gantry|portal|column|staender|knee|konsole|quill|mill|milling|fraes\\w*|router|spindle head|mesa|tavola|工作台|立柱"
)
PRINTER = _words("hot ?end|extruder|nozzle|heat(ed)? ?bed|printer|drucker|filament|build ?plate|druckbett|print ?head|imprimante|"
                 "heizbett|e 3 d|bowden")  # fmt: skip
LEVEL_HEAD = _words("laser|plasma|pen|plotter|print ?head|tool ?head|cutting head|extruder|hot ?end|druckkopf")
DELTA = _words("delta|kossel|effector|rostock|diagonal rod|hexapod|stewart|tripod|parallel robot|tricept|hexaglide")
ROBOT = _words("robot|robot arm|robotic|manipulator|shoulder|elbow|forearm|upper arm|wrist|scara|oberarm|unterarm|gripper|"
               "joint [1-6]|j [1-6]|link [1-6]|end effector|bras|gelenk [1-6]|로봇|机器人|ロボット")  # fmt: skip
ROTARY = _words("rotary|rotary table|rundtisch|rundachse|drehtisch|schwenk\\w*|trunnion|cradle|[abc] axis|[abc] achse|axis [abc]|"
                "4 th axis|5 th axis|fourth axis|fifth axis|indexer|dividing head|teilapparat|plateau tournant|mesa rotativa|"
                "회전|转台|ロータリー|swivel|tilting")  # fmt: skip


@lru_cache(maxsize=8192)
def role(label: str) -> str:
    """The place in the machine that a name states ("bed", "gantry", "tool" …), or "" where it states none."""
    text = plain(label)
    return next((name for name, pattern in ROLES if pattern.search(text)), "")


@lru_cache(maxsize=8192)
def letter(label: str) -> str:
    """X, Y or Z where a name states an axis by its letter, else ""."""
    found = {next(g for g in m.groups() if g) for m in _LETTER.finditer(plain(label))}
    return found.pop().upper() if len(found) == 1 else ""


# -- catalogue parts -------------------------------------------------------------------------------------------------
HARDWARE = (  # tried in this order on the name as written
    ("fastener", r"\bM\d+(\.\d)?\s*[x×*]\s*\d+|\bM\d+[-_ ]?(nut|mutter|washer|screw|bolt)|\b(DIN|ISO|EN|JIS|GB)[ _-]?\d{3,5}|"
                 r"\b(washers?|scheibe|unterlegscheibe|bolts?|schrauben?|SHCS|BHCS|FHCS|rivets?|t[-_ ]?nut|hex ?nut|rondelle|boulon|"
                 r"grub|set ?screw|cap ?screw|socket ?head|machine ?screw|screw[-_ ]M\d|standoff|spacer|circlip|dowel|o[-_ ]?ring|"
                 r"insert|drop ?in|볼트|와셔|ボルト|螺钉|螺丝|螺栓|垫圈)"),
    ("loose", r"\b(belt|riemen|courroie|cinghia|correa|cable|kabel|drag ?chain|e[-_ ]?chain|energie ?kette|schleppkette|chain|wires?|"
              r"hose|schlauch|tube|bellows?|balg|faltenbalg|way ?cover|bowden)\w*|벨트|ベルト|皮带|拖链|케이블|belt\d|bellow"),
    ("support", r"\b(SK|SHF|SHA|SH)[-_ ]?\d+\b|\b(BK|BF|FK|FF|EK|EF|AK|WBK)[-_ ]?\d{1,2}|shaft ?(support|mount|holder|clamp)|"
                r"rod ?(support|holder|clamp|mount|end)|wellenbock|wellenhalter|screw ?(mount|support)|festlager|loslager|support ?unit|"
                r"bearing ?(mount|support) ?(end)?"),
    ("block", r"\b(HGH|HGW|HGL|EGH|EGW|QHH|QHW|RGH|RGW|HSR\d+[ABCR]|SHS\d+[CVR]|LSD|KWVE|KWE|TRH|TRS|BRH)[-_ ]?\d*|"
              r"\bMG[NW][-_ ]?\d+[-_ ]?[CH]\b|\bMG[NW][-_ ]?\d+[-_ ]?(block|carriage)|\b(SBR|TBR|SBS)[-_ ]?\d+[-_ ]?(L|S)?UU|"
              r"\b(SCS|SCE|SCV|SC|SMA)[-_ ]?\d+(L|V|S)?[-_ ]?(UU)?\b|\b(LM|LME|LMK|LMF|LMH|LB|KH|RJ4?J?P?|RJMP)[-_ ]?\d+[-_ ]?(L|LUU|UU|S)?\b|"
              r"linear[-_ ]?(bearing|lager|bushing|block)|linear[-_ ]?kugellager|kugelbuchse|bushing|buchse|douille|boccola|cojinete ?lineal|"
              r"(rail|guide|slide|linear|bearing|runner|führungs?|fuehrungs?)[-_ ]?(block|wagen|carriage|runner|slider)|laufwagen|"
              r"gleit(lager|buchse|stein)|patin|pattino|carro ?HG|滑块|블록|ブロック|huakuai"),
    ("wheel", r"v[-_ ]?wheel|v[-_ ]?slot[-_ ]?wheel|(?<!hand)(?<!hand[-_ ])\bwheels?|delrin|\brollers?\b|laufrolle|\bgalets?\b|ruedas?|\brullo|"
              r"eccentric|exzenter|홀휠|滚轮|ホイール|POM[-_ ]?wheel|track ?roller"),
    ("nut", r"ball[-_ ]?nut|lead[-_ ]?screw[-_ ]?nut|kugel(gewinde)?mutter|spindelmutter|trapez(gewinde)?mutter|\bDSG\d+|nut[-_ ]?(housing|mount|block)|"
            r"(SFU|DFU|SFS|SFE)\w*[-_ ]?nut|\bnut\b|mutter\b|chiocciola|ecrou|écrou|tuerca|螺母|너트|ナット|anti[-_ ]?backlash"),
    ("rail", r"\b(HGR|EGR|QHR|RGR|LSR|HSR|SHS|SSR|LWLG?|TRHR|TKVD|TKSD|SBR|TBR|SBS|SVR)[-_ ]?\d+|\bMG[NW][-_ ]?\d+[-_ ]?R|\bMG[NW][-_ ]?\d+[-_ ]?\d{2,4}|"
             r"\brails?\b|(linear|guide|führungs?|fuehrungs?)[-_ ]?(rail|way|guide|schiene|bahn)|linear[-_ ]?(führung|fuehrung|guide)|profilschiene|"
             r"\bschienen?\b|guide ?ways?|\bways?\b|guid[ae]s? lineal|guida lineare|rotaia|glissi[eè]re|레일|レール|导轨|導軌|daogui|RailH|\w+Rail\b|"
             r"\btracks?\b|LM ?guide"),
    ("screw", r"\b(SFU|DFU|SFS|SFK|SFE|DFS|BNFN|SFY|DFM)[-_ ]?\d*|ball[-_ ]?screw|lead[-_ ]?screw|kugel(roll)?(gewinde)?spindel|kugelgewinde\w*|"
              r"gewindespindel|trapez(gewinde)?spindel|leitspindel|\bTr?[-_ ]?8[-_ x]?\d*\b|acme|threaded[-_ ]?(rod|bar)|gewindestange|vis[-_ ]?(a|à)[-_ ]?billes|"
              r"vis[-_ ]?m[eè]re|vite[-_ ]?(a ricircolo|madre)|husillo|볼(스크류|나사)|ボールねじ|丝杠|丝杆|sigang|\bscrew[-_ ]?(shaft|rod)\b"),
    ("motor", r"nema[-_ ]?\d+|stepper|\bmotors?\b|servo|schrittmotor|moteur|モーター|모터|电机|步进"),
    ("extrusion", r"v[-_ ]?slot|t[-_ ]?slot|c[-_ ]?beam|extrusion|alu(minium|minum)?[-_ ]?profil\w*|profil(e|s)?[-_ ]?\d|\bitem[-_ ]?profil|makerbeam|openbeam|"
                  r"\b(2020|2040|2060|2080|3030|3060|4040|4080|4545|4590|8020|1515|1530|2525)\b|\b(20|30|40|45|15)\s?[x×]\s?(20|30|40|60|80|45|90|15)\b|型材|프로파일"),
    ("shaft", r"(smooth|linear|guide|precision|hardened|chrome)[-_ ]?(rod|shaft|bar)|\brods?\b|\bshafts?\b|\bwellen?\b|führungswelle|fuehrungswelle|"
              r"\bstangen?\b|\btiges?\b|\bbarra?\b|\basta\b|varilla|샤프트|シャフト|光轴|guide ?post|linear ?axle|\baxles?\b"),
    ("bearing", r"\b(6[0-9]{2,3}|32\d\d|72\d\d|70\d\d|MR\d+)[-_ ]?(ZZ|2RS|RS|Z|LB)?\b|ball[-_ ]?bearing|kugellager|roulement|cuscinetto|rodamiento|thrust"),
    ("drive", r"pulley|riemenscheibe|coupl(er|ing)|kupplung|gear|zahnrad|sprocket|encoder|handwheel|handrad|limit ?switch|endstop|endschalter|sensor"),
)  # fmt: skip
_HARDWARE = [(kind, re.compile(pattern, re.I)) for kind, pattern in HARDWARE]
_LENGTH = re.compile(r"(?:[-_ x×]|\bL ?=? ?)(\d{2,4})(?: ?mm)?(?:\b|_|$)", re.I)
_TAIL = re.compile(r"(?<=\D)0\d\d$")  # what FreeCAD appends to a copy


@lru_cache(maxsize=8192)
def hardware(label: str) -> str:
    """ "rail", "block", "shaft", "screw", "nut", "wheel", "extrusion", "support", "fastener", "loose" …, or ""."""
    text = unicodedata.normalize("NFKC", _TAIL.sub("", str(label))).replace("_", " ")
    return next((kind for kind, pattern in _HARDWARE if pattern.search(text)), "")


def length(label: str) -> float | None:
    """The length in mm that a part number states ("HGR20-600": 600), or None."""
    text = _TAIL.sub("", str(label)).replace("_", "-")
    found = [float(v) for v in _LENGTH.findall(text) if 50 <= float(v) <= 6000]
    return found[-1] if found else None
