#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the tables in expected/ from closed forms: a body that turns at one constant rate after the other.

Keys at 0, 1 and 3 s, their epoch a time stamp of 14 digits; 1 rad about x in the first second, then 0.5 rad about the
body's y; positions (0, 0, 0), (2, 0, 0), (2, 4, -2). Slerp follows that exactly.
"""
import decimal
import math
import pathlib

EPOCH = decimal.Decimal("1311868163.8697")
FOLDER = pathlib.Path(__file__).resolve().parent / "expected"


def product(a, b):
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (aw * bw - ax * bx - ay * by - az * bz, aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx, aw * bz + ax * by - ay * bx + az * bw)


def about_x(angle):
    return (math.cos(angle / 2), math.sin(angle / 2), 0.0, 0.0)


def about_y(angle):
    return (math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0)


def to_world(q, v):
    w, x, y, z = q
    return product(product(q, (0.0, *v)), (w, -x, -y, -z))[1:]


def motion(t):
    """Orientation, body rate, position and velocity at t seconds; at 1 s those of the second part."""
    if t < 1.0:
        return about_x(t), (1.0, 0.0, 0.0), (2.0 * t, 0.0, 0.0), (2.0, 0.0, 0.0)
    u = (t - 1.0) / 2.0
    return product(about_x(1.0), about_y(0.5 * u)), (0.0, 0.25, 0.0), (2.0, 4.0 * u, -2.0 * u), (0.0, 2.0, -1.0)


def table(header, separator, rows):
    lines = [header] if header else []
    return "\n".join(lines + [separator.join(str(cell) for cell in row) for row in rows]) + "\n"


def samples():
    for k in range(7):
        t = decimal.Decimal(k) / 2
        yield EPOCH + t, *motion(float(t))


def main():
    position, rate, velocity, rest = "px,py,pz", "wx,wy,wz", "vx,vy,vz", (0.0, 0.0, 0.0)
    keys = [(EPOCH + t, *motion(float(t))) for t in (0, 1, 3)]
    files = {
        "keys.csv": table(f"t,qw,qx,qy,qz,{position}", ",", [(t, *q, *p) for t, q, w, p, v in keys]),
        "slerp.csv": table(f"t,qw,qx,qy,qz,{position},{rate},ax,ay,az,jx,jy,jz,{velocity},apx,apy,apz", ",",
                           [(t, *q, *p, *w, *rest, *rest, *v, *rest) for t, q, w, p, v in samples()]),
        "slerp_world.csv": table(f"t,qw,qx,qy,qz,{position},wx_world,wy_world,wz_world,{velocity}", ",",
                                 [(t, *q, *p, *to_world(q, w), *v) for t, q, w, p, v in samples()]),
        "slerp.tum": table("", " ", [(t, *p, *q[1:], q[0]) for t, q, w, p, v in samples()]),
        "slerp_euroc.csv": table("#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],"
                                 "q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []", ",",
                                 [(int(t * 10**9), *p, *q) for t, q, w, p, v in samples()]),
    }
    for name, text in files.items():
        (FOLDER / name).write_text(text, "utf-8")


if __name__ == "__main__":
    main()
