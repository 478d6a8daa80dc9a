"""Names of keys and points in English and Chinese; terms as in docs/glossary.md."""

from functools import cache

from cadgen.design.keys import without_unit
from cadgen.viewer.page.document import Words

# Groups of controls: code, heading, parts of the design.
GROUPS = (
    ("car", Words("Car", "小车"), ("car",)),
    ("cam", Words("Cam and follower", "凸轮与从动件"), ("cam", "follower")),
    ("path", Words("Path", "路径"), ("path",)),
    ("course", Words("Course and field", "赛道与场地"), ("course", "field")),
    ("blank", Words("Disc", "凸轮盘"), ("blank",)),
    ("gears", Words("Gears", "齿轮"), ("train",)),
    ("play", Words("Play and friction", "间隙与摩擦"), ("play", "mechanics")),
    ("limits", Words("Limits", "限值"), ("checks", "optimize")),
)

CHANGE = Words("Change the design", "修改设计")
NO_SCRIPT = Words("Editing needs scripts: allow them for this address.", "编辑需要脚本：请为此地址启用脚本。")

_ZH = {
    "across": "对边尺寸",
    "addendum factor": "齿顶高系数",
    "angle": "角度",
    "base radius": "基圆半径",
    "bearing clearance": "轴承游隙",
    "bearing span": "轴承跨距",
    "blend": "过渡段",
    "bore diameter": "孔径",
    "centre distance": "中心距",
    "circle diameter": "分布圆直径",
    "clearance": "间距",
    "d flat": "平面位置",
    "dedendum factor": "齿根高系数",
    "depth": "深度",
    "diameter": "直径",
    "direction": "方向",
    "drag greatest": "最大阻力矩",
    "drag least": "最小阻力矩",
    "drive energy": "驱动能量",
    "drive torque": "驱动力矩",
    "drive wheel offset": "驱动轮偏距",
    "drive wheel radius": "驱动轮半径",
    "drive": "驱动轴",
    "driven": "从动轮",
    "driver": "主动轮",
    "edge break": "倒棱",
    "field": "场地",
    "friction greatest": "最大摩擦系数",
    "friction least": "最小摩擦系数",
    "from": "起始",
    "front overhang": "前悬",
    "front wheel diameter": "前轮直径",
    "front wheel width": "前轮宽度",
    "grade": "精度等级",
    "greatest": "最大",
    "ground clearance": "离地间隙",
    "heading tolerance": "航向允差",
    "heading": "航向",
    "height": "高度",
    "hole diameter": "孔的直径",
    "holes": "孔数",
    "hub": "轮毂",
    "idle wheel offset": "从动后轮偏距",
    "inner face": "内端面",
    "intermediate": "中间轴",
    "joint across": "连接处对边",
    "joint clearance greatest": "连接最大间隙",
    "joint clearance least": "连接最小间隙",
    "keyway": "键槽",
    "laps per turn": "凸轮每转圈数",
    "laps": "圈数",
    "least": "最小",
    "left overhang": "左侧外伸",
    "length": "长度",
    "lightening": "减重孔",
    "lost lift limit": "升程损失限值",
    "margin": "余量",
    "mark": "标记",
    "max end heading": "终点最大航向误差",
    "max end position": "终点最大位置误差",
    "max lift error": "最大升程误差",
    "max run position": "途中最大位置误差",
    "max steering angle": "最大转向角",
    "measured": "实测值",
    "mid plane": "中面位置",
    "min convex radius": "最小凸半径",
    "min wall": "最小壁厚",
    "module": "模数",
    "nominal": "名义值",
    "obstacle radius": "障碍半径",
    "offset": "路径偏距",
    "outer face": "外端面",
    "outline": "外形",
    "output": "输出轴",
    "pin diameter": "销直径",
    "pressure angle": "压力角",
    "profile shift": "变位系数",
    "rack tip radius factor": "齿条顶圆角系数",
    "radius": "半径",
    "rim": "轮缘厚",
    "rod force": "从动杆压力",
    "rod rate": "从动杆刚度",
    "set screw": "紧定螺钉",
    "smoothing": "平滑量",
    "spacing": "间距",
    "step": "步长",
    "teeth": "齿数",
    "thickness": "厚度",
    "tip chamfer": "齿顶倒角",
    "to": "终止",
    "web": "辐板",
    "wheel diameter": "车轮直径",
    "wheel width": "车轮宽度",
    "wheelbase": "轴距",
    "width": "宽度",
}
# Sections whose name is that of their group, or goes without saying.
_SILENT = ("car", "cam", "path", "course", "train", "play", "mechanics", "checks", "optimize", "blank")

_POINTS = {
    "waypoints_mm": Words("waypoint", "路径点"),
    "control_points_mm": Words("control point", "控制点"),
    "gates": Words("gate", "赛道门"),
    "posts": Words("post", "立柱"),
    "walls": Words("wall", "墙"),
    "zones": Words("zone", "禁区"),
    "start": Words("start", "起点"),
    "finish": Words("finish", "终点"),
    "field": Words("field", "场地"),
}
_PLACES = {
    "at_mm": Words("", ""),
    "from_mm": Words(", begin", "，起端"),
    "to_mm": Words(", end", "，末端"),
    "corner_mm": Words(", corner", "，角点"),
}


@cache  # of some hundred keys; they are named after every change
def key_words(key: str) -> Words:
    """Name of a key: `train.stages.2.driver.teeth` is stage 2, driver, teeth."""
    parts = [part for part in key.split(".") if part not in _SILENT]
    names: list[Words] = []
    while parts:
        part = parts.pop(0)
        if part == "stages" and parts:
            number = parts.pop(0)
            names.append(Words(f"stage {number}", f"第 {number} 级"))
            continue
        if part in _POINTS and parts and parts[0].isdecimal():
            names.append(point_words(part, int(parts.pop(0)), ""))
            continue
        if part in ("start", "finish"):
            names.append(_POINTS[part])
            continue
        if part == "size_mm":
            names.append(Words("width", "宽度") if parts.pop(0) == "1" else Words("height", "高度"))
            continue
        name = without_unit(part).replace("_", " ") if part[1:2] != "_" else without_unit(part)
        names.append(Words(name, _ZH.get(name, name)))
    if len(names) > 1 and names[0].en == "follower":
        names[0] = Words("rod", "从动杆")
    return Words(", ".join(name.en for name in names), "，".join(name.zh for name in names))


def kind_words(kind: str) -> Words:
    """Name of a kind of item on the course."""
    return _POINTS[kind]


def point_words(kind: str, number: int, part: str) -> Words:
    """Name of a point.

    Args:
        kind: key or section that it stands in.
        number: number of the item, from 1; 0 for one that is alone.
        part: key of its place in the item, or the number of the point in it.
    """
    name = _POINTS[kind]
    place = _PLACES.get(part) or (Words(f", point {part}", f"，第 {part} 点") if part else Words("", ""))
    numbered = Words(f"{name.en} {number}", f"{name.zh} {number}") if number else name
    return Words(numbered.en + place.en, numbered.zh + place.zh)
