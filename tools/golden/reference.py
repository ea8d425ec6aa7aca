# SPDX-License-Identifier: Apache-2.0
"""Turns values of the reference into the compact tables that the tests of families and of smoothing read.

Every double is written by repr, so it reads back exactly; the output depends on the input only.
"""
import collections
import json
import sys

SIGNS = {"asgiven": "as_given", "shortest": "shortest", "both": "shortest"}
TIMED = {"C1": "timed-c1", "C2": "timed-c2", "C3": "timed-c3", "C3s": "timed-sextic"}
HERMITE = {3: "hermite-c1", 5: "hermite-c2", 7: "hermite-c3"}
BLENDS = {"logparabola": "log-parabola", "circle": "circular"}
ENDS = {"repeat": "repeat", "linear": "natural", "quadratic": "quadratic", "omega": "clamped"}
REFLECTED_ENDS = {"reflect": "natural", "repeat": "repeat", "natural": "handle"}
SOLVED_ENDS = {"natural": "natural", "zero": "rest", "clamped": "clamped", "prescribed": "clamped", "secant": "secant"}

CONVENTIONS = """\
# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame, per unit of key time.
# Every number is the double nearest to a value computed with 60 digits."""
KEYS_NOTE = """\
# Key quaternions may be off unit norm: the reference normalises them with 60 digits before use.
# signs: as_given leaves them, shortest negates key i when its dot product with key i-1 is negative."""
CASES_NOTE = """\
# A case, numbered within its family, builds `family` through `sequence` of keys.csv. Lists are separated by blanks.
# parameters: name=value for all keys or one value per key, separated by semicolons; choices: name=word likewise. A
# clamped end has its body rate; key_rates, key_accelerations and key_jerks are those of all keys, one after the other
# (body frame); a period closes the curve. max_halfangle [rad] is the largest half rotation angle of any logarithm in
# the case: near pi the problem itself is ill-conditioned, in proportion to 1/(pi - max_halfangle)."""
NOT_CONVERGED_NOTE = """\
# Curves for which the reference's solvers found no solution; columns as in cases.csv."""
ROWS_NOTE = """\
# side left is the limit at the right end of the segment, right the limit at its left end or a point inside."""
ENERGIES_NOTE = """\
# acceleration is the integral of |alpha|^2 [rad^2/s^3], torque that of |J alpha + omega x J omega|^2 [N^2 m^2 s] for the
# principal moments of inertia J; empty where the reference does not state it."""
ENERGY_FAMILIES = {"tan": ("quintic", "repeat"), "sextic": ("sextic", "repeat"), "c2": ("timed-c2", "natural")}
ENERGIES = {"default": ("acc_default", "torque_default"), "closed_form": ("acc_closed_form", "torque_closed_form"),
            "acc_opt": ("acc_min", "torque_at_acc_opt"), "torque_opt": (None, "torque_min")}  # tensions -> energies
KEY_RATES = ("key_rates", "key_accelerations", "key_jerks")
CURVE_COLUMNS = ("family,sequence,signs,ends,start_rate,end_rate,choices,parameters,period," + ",".join(KEY_RATES))


def tensions(values, *names):
    """Parameters by name, those that the family does not have left out."""
    return dict(zip(names, values))


def clamped(params):
    return {"start_rate": params.get("omega_start"), "end_rate": params.get("omega_end")}


def uneven(knots):
    return any(abs((b - a) - (knots[1] - knots[0])) > 1e-12 for a, b in zip(knots, knots[1:]))


def squad_timed(params, knots):
    choices = {} if params["variant"] == "geier" else {"variant": params["variant"]}  # geier is the default
    return [{"family": "squad-timed", "ends": params["ends"], "choices": choices}]


def timed(params, knots):
    chosen = {"family": TIMED[params["scheme"]],
              "parameters": tensions(params["tau"], "tension", "tension2", "tension3")}
    if "ends" in params:
        return [{**chosen, "ends": ENDS[params["ends"]], **clamped(params)}]
    *times, back = knots
    return [{**chosen, "times": times, "period": back - times[0]}]


def general_family(params, knots):
    orders = (f"tension{m + 1}" for m in range(params["k"]))
    per_key = [list(values) for values in zip(*params["tensions"])]
    return [{"family": "family", "ends": REFLECTED_ENDS[params["ends"]],
             "parameters": {"order": params["k"], **tensions(per_key, *orders)}}]


def betas(params):
    return {"beta1": params["beta1"], "beta2": params["beta2"]}


def beta_of_points(**chosen):
    """Control point i at time i: the curve starts at time 1, the reference's at 0."""
    return lambda params, knots: [{**chosen, "times": [float(i) for i in range(len(params["beta1"]))], "shift": 1.0,
                                   "parameters": betas(params)}]


def hermite_given(params, knots):
    orders = zip(*params["rates"])  # all angular velocities, all accelerations, all jerks
    rates = {name: [x for rate in order for x in rate] for name, order in zip(KEY_RATES, orders)}
    cases = [{"family": HERMITE[params["degree"]], "choices": {"form": params["form"]}, **rates}]
    if params["degree"] == 3 and params["form"] == "cumulative":
        cases.append({"family": "hermite-cumulative", **rates})
    return cases


def hermite_stencil(params, knots):
    return [{"family": HERMITE[params["degree"]],
             "choices": {"stencil": str(params["points"]), "form": params["form"]}}]


def solved(family):
    """A curve whose key rates or control points solve equations with given ends."""
    return lambda params, knots: [{"family": family, "ends": SOLVED_ENDS[params["ends"]], **clamped(params),
                                   "parameters": {"nu": params["nu"]} if "nu" in params else {}}]


def global_c2(params, knots):
    if params["nu"] != 0:
        sys.exit("bmv: tensions are a matter of nu_exact")
    return solved("global-c2")({name: value for name, value in params.items() if name != "nu"}, knots)


def even_only(chosen):
    """The reference's plain B-splines have even weights on every knots: where those are even, they are ours."""
    return lambda params, knots: [] if uneven(knots) else [chosen]


METHODS = {  # of the reference -> (parameters, knots) -> what to build: one curve, or two names of it, or none
    "slerp": lambda p, knots: [{"family": "slerp"}],
    "squad": lambda p, knots: [{"family": "squad", "ends": p["end"]}],
    "squad_nonuniform": squad_timed,
    "tan": lambda p, knots: [{"family": "quintic", "ends": "repeat", "parameters": {"tension": p["alpha"]}}],
    "g3": lambda p, knots: [{"family": "sextic", "ends": "repeat", "parameters": {"tension": p["beta"]}}],
    "knotaware": timed,
    "knotaware_closed": timed,
    "family": general_family,
    "beta": beta_of_points(family="beta"),
    "beta_g2_local": beta_of_points(family="beta-g2", choices={"form": "local"}),
    "beta_g2": lambda p, knots: [{"family": "beta-g2", "choices": {"form": "global"}, "parameters": betas(p)}],
    "beta_interp": lambda p, knots: [{"family": "beta-through", "parameters": betas(p)}],
    "hermite_catmull": lambda p, knots: [{"family": "hermite-cumulative"}],
    "hermite_given": hermite_given,
    "hermite_stencil": hermite_stencil,
    "bspline3_approx": even_only({"family": "bspline", "parameters": {"degree": 3}}),
    "bspline3_interp": even_only({"family": "bspline-through", "ends": "natural"}),
    "kim_interp": lambda p, knots: [{"family": "bspline-through", "ends": "natural",
                                     "choices": {"phantom": p["phantom"]}}],
    "bmv": global_c2,
    "nu_exact": solved("nu-exact"),
    "nielson": solved("nu"),
    "rotation_spline": solved("rotation-spline"),
    "shoemake85": lambda p, knots: [{"family": "shoemake", "choices": {"timing": p["timing"]}}],
    "tcb": lambda p, knots: [{"family": "tcb", "ends": REFLECTED_ENDS[p["ends"]],
                              "parameters": {"tension": p["T"], "continuity": p["C"], "bias": p["B"]}}],
    "barry_goldman": lambda p, knots: [{"family": "barry-goldman"}],
    "blend": lambda p, knots: [{"family": BLENDS[p["prim"]], "parameters": {"order": p["k"]}}],
}


def text(value):
    """A field: nothing, a word, a number, or numbers separated by blanks."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    if isinstance(value, list):
        return " ".join(repr(float(x)) for x in value)
    return repr(float(value))


def named(values):
    return ";".join(f"{name}={text(value)}" for name, value in values.items())


def origin(sources):
    names = ", ".join(f"{name} (format {g['format']}, seed {g['seed']})" for name, g in sources.items())
    return f"# Made by tools/make_golden.py from {names}."


def curve_fields(chosen, sequence, signs):
    """What to build from which keys, in the order of CURVE_COLUMNS."""
    return ",".join([chosen["family"], sequence, SIGNS[signs], chosen.get("ends", ""), text(chosen.get("start_rate")),
                     text(chosen.get("end_rate")), named(chosen.get("choices", {})),
                     named(chosen.get("parameters", {})), text(chosen.get("period")), *(text(chosen.get(name)) for name in KEY_RATES)])


class Sequences:
    """The keys that the cases use, by name: as many names as a sequence has sets of key times."""

    def __init__(self, sequences):
        self.sequences, self.used = sequences, {}

    def own_times(self, sequence):
        given = self.sequences[sequence]
        return given["knots"] if isinstance(given["knots"], list) else [float(i) for i in range(len(given["keys"]))]

    def name(self, sequence, times):
        """Under which the sequence at these times is written; none but even times are there besides its own."""
        own = self.sequences[sequence]["knots"]
        name = f"{sequence}-even" if isinstance(own, list) and times != own else sequence
        if self.used.setdefault(name, (sequence, times)) != (sequence, times):
            sys.exit(f"sequence {name} is used with two sets of key times, wanted one")
        return name

    def lines(self):
        return [",".join([name, text(t), *map(text, q)]) for name, (sequence, times) in self.used.items()
                for t, q in zip(times, self.sequences[sequence]["keys"], strict=True)]


def motion_line(number, row, shift):
    segment, t, side, *motion = row
    return ",".join([number, str(segment), text(t + shift), side, *(text(x) for part in motion for x in part)])


def tables(sources):
    """File name -> text."""
    keys, cases, rows, not_converged, counts = [], [], {}, [], collections.Counter()
    for g in sources.values():
        sequences = Sequences(g["sequences"])
        for case in g["cases"]:
            for chosen in METHODS[case["method"]](case["params"], case["knots"]):
                family = chosen["family"]
                number, name = str(counts[family]), sequences.name(case["seq"], chosen.get("times", case["knots"]))
                counts[family] += 1
                cases.append(f"{number},{curve_fields(chosen, name, case['sign'])},{text(case['max_halfangle'])}")
                rows.setdefault(family, []).extend(
                    motion_line(number, row, chosen.get("shift", 0.0)) for row in case["rows"])
        for sequence, signs, method, params, _ in g["skipped"]:
            times = sequences.own_times(sequence)
            not_converged += [curve_fields(chosen, sequences.name(sequence, times), signs)
                              for chosen in METHODS[method](params, times)]
        keys += sequences.lines()
    head = origin(sources) + "\n" + CONVENTIONS + "\n"

    def table(note, columns, lines):
        return head + note + "\n" + columns + "\n" + "\n".join(lines) + "\n"

    return {"keys.csv": table(KEYS_NOTE, "sequence,t,qw,qx,qy,qz", keys),
            "cases.csv": table(CASES_NOTE, f"case,{CURVE_COLUMNS},max_halfangle", cases),
            "not_converged.csv": table(NOT_CONVERGED_NOTE, CURVE_COLUMNS, not_converged),
            **{f"{family}.csv": table(ROWS_NOTE, "case,segment,t,side,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz", lines)
               for family, lines in rows.items()}}


def auto_tables(g):
    """The same for golden_auto.json, which has keys and rows of its own and was computed in double precision."""
    head = (f"# Made by tools/make_golden.py from golden_auto.json (format {g['format']}), computed in double precision.\n"
            + CONVENTIONS.splitlines()[0] + "\n")
    limits = g["tolerance"]
    note = f"# Agreement to be reached, relative to max(1, |.|): q {limits['q']}, w {limits['omega']}, a {limits['alpha']}.\n"
    keys, rows = [], []
    guarded = "smooth25"  # whose polynomial auto does not wholly believe: its rows are those of make_auto_golden.py
    for name, case in g["cases"].items():
        if name == guarded:
            continue
        keys += [",".join([name, text(t), *map(text, q)]) for t, q in zip(case["times"], case["keys"], strict=True)]
        rows += [",".join([name, text(t), *(text(x) for part in motion for x in part)]) for t, *motion in case["rows"]]
    return {"auto_keys.csv": head + "sequence,t,qw,qx,qy,qz\n" + "\n".join(keys) + "\n",
            "auto.csv": head + note + "sequence,t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n" + "\n".join(rows) + "\n"}


def energy_table(cases):
    """The energies of energies_golden.json at its tensions."""
    lines = []
    for case in cases:
        family, ends = ENERGY_FAMILIES[case["family"]]
        for tensions_of, (acceleration, torque) in ENERGIES.items():
            per_key = [list(values) for values in zip(*case[tensions_of], strict=True)]
            parameters = named(tensions(per_key, "tension", "tension2"))
            lines.append(",".join([family, case["seq"], SIGNS[case["sign"]], ends, "", "", "", parameters, "", "", "", "",
                                   text(case["J"]), text(case.get(acceleration)), text(case[torque])]))
    head = "# Made by tools/make_golden.py from energies_golden.json.\n" + CONVENTIONS.splitlines()[1] + "\n"
    return {"energies.csv": head + ENERGIES_NOTE + "\n" + f"{CURVE_COLUMNS},inertia,acceleration,torque\n"
            + "\n".join(lines) + "\n"}


def golden(source):
    """The 60-digit reference values for the tests of families.

    Reads golden.json, golden_methods.json, golden_auto.json and energies_golden.json and makes keys.csv (the sequences), cases.csv
    (what to build from them), one table of expected motions per family, not_converged.csv (what the reference could not solve) and
    energies.csv.
    """
    read = {name: json.loads((source / f"{name}.json").read_text()) for name in ("golden", "golden_methods", "golden_auto", "energies_golden")}
    made = tables({f"{name}.json": read[name] for name in ("golden", "golden_methods")})
    made |= auto_tables(read["golden_auto"]) | energy_table(read["energies_golden"])
    return {f"tests/data/golden/{name}": text for name, text in made.items()}


# ---------------------------------------------------------------- smoothing

SMOOTH_NOTE = "# Quaternions: Hamilton, body to world, sign of no meaning. Rates: body frame, rad and s. The minimiser and its costs.\n"
FIGURES = ("cost", "data", "penalty", "logdet", "reml_sigma_known", "trace_hat_per_axis")


def numbers(values):
    return ",".join(repr(float(value)) for value in values)


def case_row(number, case):
    texts = [str(number), case["name"].replace(",", ""), str(case["order"]), case["loss"], case["start"], str(int(case["bias"]))]
    return ",".join(texts) + "," + numbers([case["lam"], case["c"], *(case[figure] for figure in FIGURES), *case["b"]])


def node_rows(number, case):
    gyro, weight = case["gyro"] or [[0, 0, 0]] * len(case["t"]), case["wg"] or 0
    for i, t in enumerate(case["t"]):
        yield f"{number}," + numbers([t, *case["keys"][i], case["w"][i], *gyro[i], weight, *case["q"][i], *case["omega"][i],
                                      *case["alpha"][i]])


def smooth(source):
    """The reference values of smoothing in golden_smooth.json."""
    cases = json.loads((source / "golden_smooth.json").read_text("utf-8"))["cases"]
    case_head = "case,name,order,loss,start,bias,lambda,threshold,cost,data,penalty,log_determinant,reml,trace,bx,by,bz\n"
    node_head = "case,t,qw,qx,qy,qz,weight,gx,gy,gz,gyro_weight,found_qw,found_qx,found_qy,found_qz,wx,wy,wz,ax,ay,az\n"
    rows = (row for i, c in enumerate(cases) for row in node_rows(i, c))
    return {"tests/data/golden/smooth_cases.csv": SMOOTH_NOTE + case_head + "".join(case_row(i, c) + "\n" for i, c in enumerate(cases)),
            "tests/data/golden/smooth_nodes.csv": SMOOTH_NOTE + node_head + "".join(row + "\n" for row in rows)}
