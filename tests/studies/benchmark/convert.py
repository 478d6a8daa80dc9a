"""Raw logs of others -> columns of the benchmark: `python tests/studies/benchmark/convert.py RAW OUT`.

Lines `time: S ticks: STEER TRACTION model_pose: X Y HEADING tracker_pose: X Y HEADING`, as the log has them from which
the forklift's record was taken: absolute ticks of the steering (8192 a turn, from half a turn on negative), incremental
ticks of the traction wheel in 32 bits that overflow, poses in m and rad. Nothing is fetched here: fetch a log where its
licence allows it, and give its path.
"""

import math
import re
import sys
from pathlib import Path

STEERING_TURN, TRACTION_TURN, OVERFLOW = 8192, 5000, 2**32
K_STEER, K_TRACTION = 0.1, 0.0106141  # of the log's own header: rad a turn of the encoder, m a turn
_LINE = re.compile(r"time: *(\S+) +ticks: *(\d+) +(\d+) .*tracker_pose: *(\S+) +(\S+) +(\S+)")


def converted(text: str, *, ahead_mm: float = 1500.0) -> list[str]:
    """Lines of a record: the rear axle's centre, `ahead_mm` behind the sensor, in the frame of its first pose.

    Args:
        text: raw log.
        ahead_mm: place of the sensor ahead of the rear axle, mm.
    """
    out = ["run,t_s,distance_mm,steering_deg,x_mm,y_mm,heading_deg"]
    first = before = None
    way = 0.0
    for match in map(_LINE.search, text.splitlines()):
        if match is None:
            continue
        time, steer, traction = float(match[1]), int(match[2]), int(match[3])
        x, y, heading = (float(match[n]) for n in (4, 5, 6))
        steer = steer - STEERING_TURN if steer > STEERING_TURN / 2 else steer
        if before is not None:
            step = (traction - before + OVERFLOW // 2) % OVERFLOW - OVERFLOW // 2
            way += 1e3 * K_TRACTION * step / TRACTION_TURN
        before = traction
        place = 1e3 * complex(x, y) - ahead_mm * complex(math.cos(heading), math.sin(heading))
        if first is None:
            first = (time, place, heading)
        seen = (place - first[1]) * complex(math.cos(first[2]), -math.sin(first[2]))
        turned = math.degrees(math.remainder(heading - first[2], 2 * math.pi))
        angle = math.degrees(K_STEER * steer / STEERING_TURN * 2 * math.pi)
        out.append(f"1,{time - first[0]:.3f},{way:.2f},{angle:.3f},{seen.real:.1f},{seen.imag:.1f},{turned:.3f}")
    return out


if __name__ == "__main__":
    raw, out = sys.argv[1:]
    Path(out).write_text("\n".join(converted(Path(raw).read_text(encoding="utf-8"))) + "\n", encoding="utf-8")
