"""Checks in Chinese: their names by their codes, and the words of their places."""

import re

from cadgen.check import Check, CheckCode
from cadgen.page.document import Text, Words

_NAMES: dict[str, str] = {
    CheckCode.PRESSURE_ANGLE_RISE: "压力角，推程",
    CheckCode.PRESSURE_ANGLE_RETURN: "压力角，回程",
    CheckCode.CONVEX_RADIUS_THEORY: "外凸曲率半径，理论轮廓",
    CheckCode.CONVEX_RADIUS_PROFILE: "外凸曲率半径，实际轮廓",
    CheckCode.LOST_LIFT_UNDERCUT: "升程损失，轮廓失真",
    CheckCode.LOST_LIFT_CROSSING: "升程损失，轮廓自交",
    CheckCode.LOST_LIFT_FACE_CHANGE: "升程损失，承载面切换",
    CheckCode.ROD_PUSHED_OUT: "从动件被顶出",
    CheckCode.ROD_FALLS_SHORT: "从动件未达升程",
    CheckCode.WRONG_FACE: "承载面错误",
    CheckCode.BLEND_LIFT: "过渡段未达升程",
    CheckCode.BLEND_PRESSURE_ANGLE_RISE: "压力角，过渡段推程",
    CheckCode.BLEND_PRESSURE_ANGLE_RETURN: "压力角，过渡段回程",
    CheckCode.ROD_PAST_RIM: "从动杆伸出轮缘",
    CheckCode.LEAN_OVER_CHAMFERS: "从动杆倾斜与倒棱",
    CheckCode.ROD_ABOVE_HUB: "从动杆与轮毂间距",
    CheckCode.CUTTER_RADIUS: "允许最大铣刀半径",
    CheckCode.THINNEST_WALL: "最薄壁厚",
    CheckCode.CLOSURE: "轮廓闭合",
    CheckCode.BLEND_START: "过渡段起点连续性",
    CheckCode.CHANCE_WORSE: "比旧凸轮更差的概率",
    CheckCode.RUNS_EXPLAINED: "实测运行可被解释",
    CheckCode.EDGES_BROKEN_MORE: "倒棱再大 0.1 mm",
    CheckCode.LIFT_ERROR_WITH_PLAY: "含间隙的升程误差",
    CheckCode.CAM_RUNS_AHEAD: "凸轮超前力矩",
    CheckCode.CAM_HOLDS: "凸轮保持裕度",
    CheckCode.BEARING_WIDTH: "轴承宽度",
    CheckCode.ROOT_CLEARANCE: "顶隙",
    CheckCode.CONTACT_RATIO: "重合度",
    CheckCode.CONTACT_RATIO_FORMULA: "重合度与公式之差",
    CheckCode.TEETH_JAM: "轮齿卡死",
    CheckCode.TEETH_HOLD: "轮齿相互啮合",
    CheckCode.OVERLAP_WITHIN_PLAY: "侧隙内的干涉",
    CheckCode.OVERLAP_PAST_PLAY: "侧隙外的干涉",
    CheckCode.PLAY_AS_CUT: "侧隙实测与计算之差，加工状态",
    CheckCode.PLAY_GREATEST: "侧隙实测与计算之差，最大",
    CheckCode.PLAY_LEAST: "侧隙实测与计算之差，最小",
    CheckCode.RETURN_ERROR: "回程误差实测与计算之差",
    CheckCode.COURSE_POST: "与立柱的间距",
    CheckCode.COURSE_WALL: "与墙的间距",
    CheckCode.COURSE_ZONE: "与禁区的间距",
    CheckCode.COURSE_EDGE: "与场地边缘的间距",
    CheckCode.COURSE_SIDE: "绕行方向",
    CheckCode.COURSE_GATES: "通过的赛道门",
    CheckCode.COURSE_GATE_MARGIN: "赛道门最小余量",
    CheckCode.COURSE_START: "起点位置",
    CheckCode.COURSE_START_HEADING: "起点航向",
    CheckCode.COURSE_FINISH: "终点位置",
    CheckCode.COURSE_FINISH_HEADING: "终点航向",
    CheckCode.COURSE_BLEND: "过渡段最小余量",
    CheckCode.COURSE_BLEND_PLAY: "过渡段最小余量，有间隙",
    CheckCode.COURSE_POST_PLAY: "与立柱的间距，有间隙",
    CheckCode.COURSE_WALL_PLAY: "与墙的间距，有间隙",
    CheckCode.COURSE_ZONE_PLAY: "与禁区的间距，有间隙",
    CheckCode.COURSE_EDGE_PLAY: "与场地边缘的间距，有间隙",
    CheckCode.COURSE_SIDE_PLAY: "绕行方向，有间隙",
    CheckCode.COURSE_GATES_PLAY: "通过的赛道门，有间隙",
    CheckCode.COURSE_GATE_MARGIN_PLAY: "赛道门最小余量，有间隙",
    CheckCode.COURSE_FINISH_PLAY: "终点位置，有间隙",
    CheckCode.COURSE_FINISH_HEADING_PLAY: "终点航向，有间隙",
    CheckCode.BODIES_OVERLAP: "零件干涉",
    CheckCode.LAP_DRIFT: "每圈偏移",
    CheckCode.LAP_TURN: "每圈航向偏转",
    CheckCode.LAP_DRIFT_PLAY: "每圈偏移，有间隙",
    CheckCode.LAP_TURN_PLAY: "每圈航向偏转，有间隙",
    CheckCode.LAPS_DRIFT_PLAY: "全部圈数后的偏移，有间隙",
    CheckCode.LAPS_TURN_PLAY: "全部圈数后的航向偏转，有间隙",
    CheckCode.LAP_FURTHEST_PLAY: "最后一圈的最大偏离，有间隙",
    CheckCode.STEERING_ANGLE: "转向角",
}
# Words of places; longer ones first.
_PLACES = (
    (r"where the car does not drive", "小车不行驶处"),
    (r"lightening hole (\d+) and profile", r"减重孔 \1 与轮廓"),
    (r"cam angle ([\d.]+)°", r"凸轮转角 \1°"),
    (r"polar angle ([\d.]+)°", r"极角 \1°"),
    (r"motor ([\d.]+)° \(play ([\d.]+)°\)", r"电机 \1°（间隙 \2°）"),
    (r"\((\d+) in all\)", r"（共 \1 处）"),
    (r"\(local\)", "（局部）"),
    (r"corner ([\d.]+)°", r"尖角 \1°"),
    (r"inner (\d+) %, outer (\d+) %", r"内侧 \1 %，外侧 \2 %"),
    (r"(\S+) \(wheels alone\)", r"\1（仅车轮）"),
    (r"by the drive wheel", "驱动轮处"),
    (r"by the front wheel", "前轮处"),
    (r"by the idle wheel", "从动轮处"),
    (r"by the outline", "车身外形处"),
    (r"fork at \(([-\d]+), ([-\d]+)\) mm", r"前叉位于 (\1, \2) mm"),
    (r"([\d.]+) mm along", r"沿程 \1 mm"),
    (r"([\d.]+) mm (?:from|off) its middle", r"距其中心 \1 mm"),
    (r"missed by ([\d.]+) mm", r"偏出 \1 mm"),
    (r"all, (\d+) in order", r"全部，按序 \1 个"),
    (r"return error ([\d.]+)°", r"回程误差 \1°"),
    (r"times what is needed", "倍于所需"),
    (r"N·mm without friction", "N·mm（不计摩擦）"),
    (r"at the finish; ([\d.]+) mm with the steering trimmed by ([\d.]+)°", r"终点处；转向微调 \2° 后为 \1 mm"),
    (r"whole train", "整个轮系"),
    (r"stage (\d+)", r"第 \1 级"),
    (r"\bleast\b", "最小"),
    (r"\bgreatest\b", "最大"),
    (r"^none$", "无"),
    (r"^all\b", "全部"),
)


def check_name(check: Check) -> Text:
    """Name of a check in both languages; English in both for a check of a kind that was added."""
    return Words(check.name, _NAMES.get(check.code.value, check.name))


def place_words(place: str) -> Text:
    """Place of a check in both languages."""
    chinese = place
    for pattern, words in _PLACES:
        chinese = re.sub(pattern, words, chinese)
    return Words(place, chinese.replace(", ", "，"))
