"""Sentences that the program makes of its numbers, in Chinese: one table of clauses, with the numbers in their places.

A sentence of which a clause is not in the table stays English, whole.
"""

import re

from cadgen.messages import CHINESE, Message, shown

_N = r"([-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?)"
_FIGURES = {
    "worst end position error": "最坏终点位置误差",
    "worst end heading error": "最坏终点航向误差",
    "position error at the end with the measured play": "实测间隙下的终点位置误差",
    "heading error at the end with the measured play": "实测间隙下的终点航向误差",
    "position error on the run": "全程位置误差",
    "lift error with play": "含间隙的升程误差",
}
_FIGURE = "(" + "|".join(map(re.escape, _FIGURES)) + ")"
_PROFILE = r"([a-z]+(?:\+[a-z]+)?)"
# Clauses; longer ones before those that they contain.
_CLAUSES: tuple[tuple[str, str], ...] = (
    (
        rf"Drive wheel: radius {_N} mm, the car goes {_N} mm in a turn of the cam; the cam is right for this "
        r"wheel alone\.",
        r"驱动轮：半径 \1 mm，凸轮每转一周小车行驶 \2 mm；此凸轮仅适用于该车轮。",
    ),
    (
        rf"Drive wheel: the car goes {_N} mm in a turn of the cam; its radius follows from the ratio of "
        r"\[train\], which the design lacks\.",
        r"驱动轮：凸轮每转一周小车行驶 \1 mm；其半径由 [train] 的传动比得出，而设计中没有 [train]。",
    ),
    (
        rf"The path is closed and a turn of the cam is {_N} laps of {_N} mm;",
        r"路径闭合，凸轮一转为 \1 圈，每圈 \2 mm；",
    ),
    ("The path is closed and a turn of the cam is a lap;", "路径闭合，凸轮一转为一圈；"),
    (rf"nothing is blended, and runs are judged after {_N} laps\.", r"没有过渡段，按行驶 \1 圈后的结果评判。"),
    (r"nothing is blended, and runs are judged after a lap\.", "没有过渡段，按行驶一圈后的结果评判。"),
    (
        rf"The whole path is driven by cam angle {_N}°, before the closing blend\.",
        r"整条路径在凸轮转角 \1° 之前走完，其后才是过渡段。",
    ),
    (
        rf"The path takes the whole turn, so the closing blend steers the last {_N} mm: runs are judged to "
        rf"{_N}°, and at the end of the blend the car stands {_N} mm and {_N}° off the path's end "
        r"\(car\.drive_wheel_radius_mm puts the blend behind the path\)\.",
        r"路径占满整转，因此最后 \1 mm 由过渡段转向：运行评判至 \2°，过渡段结束时小车偏离路径终点 \3 "
        r"mm 和 \4°（给出 car.drive_wheel_radius_mm 可使过渡段位于路径之后）。",
    ),
    (
        r"Reckoned as if the rod slid without friction, which only a ball bearing does\.",
        "按从动杆无摩擦滑动计算，而只有球轴承能做到。",
    ),
    (
        rf"With a rod that rubs \(friction {_N} to {_N}\) and these plays the car would end up to {_N} mm off",
        r"若从动杆有摩擦（摩擦系数 \1 至 \2），在这些间隙下小车终点最多偏离 \3 mm",
    ),
    (rf"; the {_PROFILE} profile would end up to {_N} mm off", r"；\1最多偏离 \2 mm"),
    (
        r"\. Say in \[mechanics\] what the car has, and cadgen optimize compares what helps\.",
        "。请在 [mechanics] 中写明小车的情况，cadgen optimize 会比较各种办法。",
    ),
    (
        rf"Build: a brake on the disc itself with a drag of {_N} N·mm, a quarter more than the cam's {_N} N·mm "
        rf"at {_N}°, for a rod force of {_N} N; it takes {_N} J a turn\. The cam is made for that\.",
        r"制作：在凸轮盘上装制动件，阻力矩 \1 N·mm，比凸轮在 \3° 处的 \2 N·mm "
        r"大四分之一（从动杆压力 \4 N）；每转耗能 \5 J。凸轮按此制作。",
    ),
    (
        "Do: after a trial run set the micrometer of the base radius so that the end is met; the choice "
        r"goes by the ends after that trim, the figures in the table are before it\.",
        "操作：试车后用基圆半径的千分尺微调，使终点对准；方案按微调后的终点选择，表中数值为微调前。",
    ),
    (
        "Warning: the cam leads its gears at the least friction and drag and is held at the greatest, "
        r"which is the worst place to be: it may do either from run to run\.",
        "警告：摩擦与阻力最小时凸轮会超前齿轮，最大时则被保持住，这是最不利的情况：每次运行都可能不同。",
    ),
    (
        "Warning: friction alone holds the cam on its gears, and oil or shaking undoes that: only drag is "
        r"to be counted on\.",
        "警告：仅靠摩擦把凸轮压在齿轮上，油或振动会使其失效：只有阻力可靠。",
    ),
    (
        rf"Warning: the drag of {_N} N·mm does not hold the cam, which needs {_N} N·mm at {_N}°, and less is no "
        r"half cure\.",
        r"警告：\1 N·mm 的阻力保持不住凸轮，在 \3° 处需要 \2 N·mm；不足则没有作用。",
    ),
    (
        rf"Warning: the drag acts on the shaft, and the disc has {_N}° of play on it that no drag holds: "
        r"brake the disc itself, or take that play out\.",
        r"警告：阻力作用在轴上，而凸轮盘相对轴有 \1° 的间隙，任何阻力都保持不住：请直接制动凸轮盘，或消除该间隙。",
    ),
    (
        rf"Warning: near a friction of {_N} a change by {_N} moves the end of the run by {_N} mm\.",
        r"警告：摩擦系数在 \1 附近变化 \2 会使终点移动 \3 mm。",
    ),
    (
        rf"{_PROFILE} chosen: the least {_FIGURE}, {_N} mm, of {_N} that keep every limit",
        r"选用\1：在满足全部限制的 \4 个中，\2最小，为 \3 mm",
    ),
    (
        rf"{_PROFILE} refused: it has an? {_FIGURE} of {_N} (\S+), {_N} \S+ more than the {_N} allowed",
        r"\1不合格：\2为 \3 \4，超出允许值 \6 达 \5 \4",
    ),
    (
        rf", and has an? {_FIGURE} of {_N} (\S+), {_N} \S+ more than the {_N} allowed",
        r"；且\1为 \2 \3，超出允许值 \5 达 \4 \3",
    ),
    (rf"{_PROFILE} not chosen: its {_FIGURE} is {_N} mm", r"未选用\1：其\2为 \3 mm"),
    (rf"{_PROFILE} refused: it fails .+", r"\1不合格：有检查项未通过"),
    (
        rf"of the others, none of the profiles compared keeps the design's limits: the nearest, {_PROFILE}, has an? "
        rf"{_FIGURE} of {_N} (\S+), {_N} \S+ more than the {_N} allowed: raise the limit in \[optimize\], or take a "
        "train with less backlash",
        r"其余轮廓均不满足设计的限制：最接近的\1，\2为 \3 \4，超出允许值 \6 达 \5 \4：请放宽 "
        "[optimize] 中的限制，或采用侧隙更小的轮系",
    ),
    (
        rf"{_PROFILE} refused: smoothing takes at most {_N} % off the deflection errors of this lift, not {_N} %: aim "
        "lower, or compensate",
        r"\1不合格：平滑最多能消除此升程偏转误差的 \2 %，达不到 \3 %：请降低目标，或改用补偿",
    ),
    ("this design: ", "本设计："),
    ("plain cam, reordered", "未补偿凸轮，重排各级"),
    ("plain cam, trimmed", "未补偿凸轮，试车微调"),
    ("plain cam, drag that holds", "未补偿凸轮，加保持阻力"),
    ("plain cam", "未补偿凸轮"),
    ("compensated for one car", "按一辆车补偿"),
    ("compensated for all", "按全部情况补偿"),
    ("no play in one joint, compensated", "消除一处连接间隙，并补偿"),
    ("split wheel, compensated", "剖分齿轮，并补偿"),
    ("ball bearing, compensated", "球轴承，并补偿"),
    (r"the train with its stages reordered: (--set \S+)", r"重排各级的轮系：\1"),
    (
        rf"right for a play of {_N}° and a friction of {_N}, where it leaves {_N} mm: measure both on the car",
        r"适用于间隙 \1°、摩擦系数 \2，此时剩余 \3 mm：请在车上实测这两项",
    ),
    (
        rf"a wheel of two halves under springs on the camshaft, which takes out its own mesh only, {_N} of "
        rf"{_N}°; its springs must hold more torque than the cam gives",
        r"凸轮轴上用弹簧撑开的剖分齿轮，只消除自身啮合的间隙，即 \2° 中的 \1°；弹簧力矩须大于凸轮的力矩",
    ),
    (
        rf"{_N} ball bearings side by side of (\S+ x \S+ x \S+) mm on the rod",
        r"从动杆上并排 \1 个 \2 mm 的球轴承",
    ),
    (r"a ball bearing of (\S+ x \S+ x \S+) mm on the rod", r"从动杆上装一个 \1 mm 的球轴承"),
    (", and a cam for it: ((?:--set [^ ;]+ ?)+);", r"，并按其制作凸轮：\1；"),
    ("its cam keeps every check", "其凸轮全部检查合格"),
    (
        rf"after a trial run change the base radius at the micrometer by {_N} to {_N} µm, so that the end is "
        rf"met; set at a friction of {_N}, the end stays within {_N} mm more while friction stays from {_N} to "
        rf"{_N}",
        r"试车后用千分尺将基圆半径改变 \1 至 \2 µm，使终点对准；在摩擦系数 \3 "
        r"下调好后，摩擦系数保持在 \5 至 \6 之间时，终点再偏离不超过 \4 mm",
    ),
    (
        rf"a brake or felt on the disc itself, {_N} N·mm for a rod force of {_N} N: a quarter more than the "
        rf"cam's {_N} N·mm at {_N}° without friction \({_N} at the least friction\); it takes {_N} J a turn",
        r"在凸轮盘上装制动件或毛毡，阻力矩 \1 N·mm（从动杆压力 \2 N）：比凸轮在 \4° 处不计摩擦的 "
        r"\3 N·mm 大四分之一（最小摩擦时 \5）；每转耗能 \6 J",
    ),
    (rf", {_N} % of the drive's {_N} J", r"，为驱动能量 \2 J 的 \1 %"),
    (", which it has not got", "，能量不足"),
    (
        rf", and holds until the drag falls by {_N} % or the rod's force rises by {_N} %; a milder path there "
        "needs less, a larger base radius does not",
        r"；阻力下降 \1 % 或压力上升 \2 % 之前都能保持；该处路径更平缓则所需更小，加大基圆半径则无助",
    ),
    (
        rf"clamp, pin or glue (.+?): its (?:key|D-flat) has {_N}° of the {_N}° of return error",
        r"夹紧、销接或粘接\1：回程误差 \3° 中有 \2° 来自其键或扁位",
    ),
    (
        rf"preload the bearings of stage {_N}, which have {_N}° of the {_N}° of return error",
        r"给第 \1 级轴承预紧：回程误差 \3° 中有 \2° 来自这些轴承",
    ),
    (
        rf"Joints and bearings add up to {_N}° to the teeth's {_N}°: ",
        r"连接与轴承最多在轮齿的 \2° 之外再加 \1°：",
    ),
    (rf"Joints and bearings add up to {_N}°: ", r"连接与轴承最多增加 \1°："),
    ("Cheapest cure: ", "最省的办法："),
    (rf"(?:key|D-flat) of the cam {_N}°", r"凸轮的键或扁位 \1°"),
    (rf"bearings of stage {_N}", r"第 \1 级轴承"),
    ("the cam(?=：)", "凸轮"),
    (r"widen the turn there \((\S+)\)", r"请加宽该处弯道（\1）"),
    (
        r"raise cam\.blend_deg \(the closing blend steers there\)",
        "请加大 cam.blend_deg（该处由过渡段转向）",
    ),
    (
        r", raise cam\.base_radius_mm, or choose another checks\.pressure_angle_limit \(now (.+)\)",
        "，或加大 cam.base_radius_mm，或改选 checks.pressure_angle_limit",
    ),
    ("a sharp ridge wears: ", "尖脊易磨损："),
    (
        r"the chamfers of the broken edges meet on a sharp ridge: lower blank\.edge_break_mm, ",
        "尖脊上两侧倒棱相遇：请减小 blank.edge_break_mm，",
    ),
    (
        r"lower follower\.radius_mm or raise cam\.base_radius_mm",
        "减小 follower.radius_mm 或加大 cam.base_radius_mm",
    ),
    (r"a convex part sharper than the \w+ is undercut: ", "比从动件更尖的外凸处会失真："),
    (r"no profile gives this lift to this \w+: ?", "没有轮廓能使该从动件得到此升程："),
    ("two flanks cut each other off: ?", "两侧轮廓互相切断："),
    (
        r"make the disc thinner \(cam\.thickness_mm\) or ",
        "请减薄凸轮盘（cam.thickness_mm），或者",
    ),
    (
        r"this profile is not the \w+'s envelope: use --profile actual",
        "此轮廓不是从动件的包络线：请使用 --profile actual",
    ),
    (
        r"on so steep a flank the \w+ locks when the cam is turned on to its start: (.+) or raise "
        r"cam\.base_radius_mm",
        r"如此陡的轮廓会在凸轮转回起点时卡死从动件：\1，或加大 cam.base_radius_mm",
    ),
    (
        "lift, slope and second derivative must not jump: report this design",
        "升程及其一、二阶导数不得突变：请报告此设计",
    ),
    (
        r"the rod slips off the disc's rim: raise follower\.length_mm",
        "从动杆会滑出轮缘：请加大 follower.length_mm",
    ),
    (
        "the rod leans so far that it rides on the broken edge: leave the edges sharp "
        r"\(blank\.edge_break_mm\) or ",
        "从动杆倾斜过大而压在倒棱上：请保留锐边（blank.edge_break_mm），或者",
    ),
    (
        r"the rod meets the hub: lower blank\.hub\.diameter_mm or blank\.hub\.length_mm",
        "从动杆碰到轮毂：请减小 blank.hub.diameter_mm 或 blank.hub.length_mm",
    ),
    (
        r"choose a smaller machining\.cutter_diameter_mm",
        "请减小 machining.cutter_diameter_mm",
    ),
    (
        r"make the hole smaller or move it \(the design's \[blank\]\), or lower checks\.min_wall_mm",
        "请缩小或移动该孔（设计的 [blank]），或减小 checks.min_wall_mm",
    ),
    (
        "the profile leaves the planned path: use --profile compensated, or raise "
        r"optimize\.max_lift_error_um",
        "轮廓偏离规划路径：请使用 --profile compensated，或加大 optimize.max_lift_error_um",
    ),
    (
        r"move the path away from the field's edge, or lower course\.margin_mm",
        "请使路径远离场地边缘，或减小 course.margin_mm",
    ),
    (
        r"move the path away from (\S+), or lower course\.margin_mm",
        r"请使路径远离 \1，或减小 course.margin_mm",
    ),
    (
        "lead the path past it on the other side, or change its key side",
        "请使路径从另一侧绕过，或改变设计中的绕行方向",
    ),
    (
        "lead the path through the gates in their order and direction, or make them wider",
        "请使路径按顺序和方向通过各赛道门，或加宽赛道门",
    ),
    (r"let the path (?:start|finish) there, or change (\S+)", r"请使路径在该处开始或结束，或修改 \1"),
    (
        r"let the path (?:start|finish) in that direction, or change (\S+)",
        r"请使路径按该方向开始或结束，或修改 \1",
    ),
    (
        r"make the course keep more room, take play out of the gears, or set course\.judged = .planned.",
        "请为赛道留出更多余量，减小齿轮间隙，或修改 course.judged",
    ),
    (
        r"with play no run ends on a line: give course\.finish as a disc, at_mm with a radius_mm that holds where the "
        r"runs end, or set course\.judged = .planned.",
        "有间隙时没有一次运行恰好停在线上：请把 course.finish 改为圆（at_mm 与能容纳各次终点的 radius_mm），"
        "或修改 course.judged",
    ),
    (
        rf"with {_N} stages the camshaft turns the same way as the drive wheel, but the cam is made to turn against "
        r"it: put the disc on its shaft turned over, a hub with it, or add a stage",
        r"有 \1 级齿轮时凸轮轴与驱动轮转向相同，而凸轮按相反转向制作：请把凸轮盘（连同轮毂）翻面装到轴上，"
        "或增加一级齿轮",
    ),
    ("tips meet roots: ", "齿顶与齿根相碰："),
    ("lower addendum_factor or the profile shifts", "请减小 addendum_factor 或变位系数"),
    ("give more teeth", "请增加齿数"),
    (
        rf"thin the teeth, or set the axes apart \(the least play by the tolerances is {_N} µm\)",
        r"请减薄轮齿或加大中心距（按公差最小侧隙为 \1 µm）",
    ),
    ("thin the teeth, or set the axes apart", "请减薄轮齿或加大中心距"),
    ("give a longer collar, smaller hubs, or more thinning", "请加长轴套，减小轮毂，或增大减薄量"),
    ("the teeth contradict the formulas: report this design", "轮齿与公式矛盾：请报告此设计"),
)
# Keys, commands and units, the same in both languages.
_PLAIN = re.compile(r"--set \S+|--profile \w+|\[\w+\]|[a-z_]+(?:\.[a-z_0-9]+)+|[a-z]+_[a-z_]+|N·mm|cadgen \w+|µm|mm")
_ENGLISH = re.compile(r"[A-Za-z]{2,}")
_NAMES = ("smoothed+compensated", "actual", "compensated", "smoothed", "theoretical", "published", "optimized")


class Told(Message):
    """Sentence with its Chinese."""

    chinese: str

    def translated(self, language: str) -> str:
        """Text in a language."""
        return self.chinese if language == CHINESE else str(self)


def told(english: str, chinese: str) -> str:
    """A sentence with its Chinese; the sentence alone where there is none."""
    if (isinstance(english, Message) and english.arguments) or shown(english, CHINESE) != english or english == chinese:
        return english
    made = str.__new__(Told, english)
    made.template, made.arguments, made.chinese = str(english), {}, chinese
    return made


def generated(sentence: str) -> str:
    """A sentence in both languages; English in both where a clause of it is not known."""
    chinese = str(sentence)
    for pattern, words in _CLAUSES:
        chinese = re.sub(pattern, words, chinese)
    for english, words in _FIGURES.items():
        chinese = chinese.replace(english, words)
    for name in _NAMES:
        chinese = re.sub(
            rf"(?<![A-Za-z+.-])(?<!--profile ){re.escape(name)}(?![A-Za-z+-])", shown(name, CHINESE), chinese
        )
    if chinese == sentence or is_english(chinese):
        return sentence
    chinese = re.sub(r"(?<=[\u4e00-\u9fff]), ?", "，", chinese)
    chinese = re.sub(r"(?<=[\u4e00-\u9fff]) (?=[\u4e00-\u9fff])", "", chinese)
    return told(sentence, re.sub(r"(?<=[。；：，]) +", "", chinese))


def is_english(text: str) -> bool:
    """Whether a text has English words beside keys, commands and units."""
    return bool(_ENGLISH.search(_PLAIN.sub(" ", text)))
