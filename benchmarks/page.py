# SPDX-License-Identifier: Apache-2.0
"""The tables of docs/benchmarks.md."""
import re

from page_block import fill_block

# What contraction into fused multiply-adds would give is left out by default: ratios may be that much smaller.
WITHOUT_CONTRACTION = {"v4": 0.88, "v3": 0.75}
# text, member of ratios.json, target on v4, target on v3, unit, whether contraction matters
AT_LEAST = [
    ("times an Eigen product, same curve", "vs_eigen_product", 15, 12, "×", True),
    ("times an Eigen slerp with binary search", "vs_eigen_slerp", 8, 6, "×", True),
    ("times smooth's fitted cubic", "vs_smooth", 20, 16, "×", True),
    ("times SciPy's RotationSpline", "vs_scipy", 80, 60, "×", True),
    ("times basalt's So3Spline<4>, with rates", "vs_basalt_rates", 70, 50, "×", True),
    ("of the peak of products and sums", "fma_fraction", 0.75, 0.65, "", True),
    ("times the formula with libm, many curves, double", "many_curves_vs_libm", 12, 10, "×", True),
    ("times the formula with libm, many curves, float", "many_curves_float_vs_libm", 12, 10, "×", True),
    ("times the formula with libm, single times, searches included", "random_access_vs_libm", 5, 5, "×", True),
    ("times SciPy, making the curve and its records", "setup_vs_scipy", 30, 30, "×", False),
    ("times SciPy, making `rotation-spline` of 10 keys", "rotation_spline_vs_scipy_10", 60, 60, "×", False),
    ("… of 1000 keys", "rotation_spline_vs_scipy_1000", 3, 3, "×", False),
    ("… of 10000 keys", "rotation_spline_vs_scipy_10000", 3, 3, "×", False),
]
AT_MOST = [
    ("times the fastest other kernel, a sample of `rational`", "rational_vs_fastest", 0.8, 0.8, "×", False),
    ("times the time of only writing 32 B", "write_multiple", 4, 5, "×", True),
    ("single time on 1000 keys, search included", "random_access_ns", 60, 60, "ns", False),
    ("one key more, online: 99.9 % are within", "online_append_ns_p999", 300, 300, "ns", False),
    ("making the curve, per key (`timed-c2`)", "setup_ns_per_key", 250, 250, "ns", False),
    ("making `auto`, per key", "auto_ns", 1500, 1500, "ns", False),
    ("largest error of a component, double", "max_error_double", 1e-15, 1e-15, "", False),
    ("largest error of a component, float", "max_error_float", 3e-7, 3e-7, "", False),
]
STATED = [("a sample with its angular velocity and acceleration", "rates_ns", "ns"),
          ("… times an Eigen product with the same rates", "vs_eigen_rates", "×"),
          ("compiling all records, per key (not needed for sampling)", "compile_ns_per_key", "ns"),
          ("making `measured`, per key", "measured_ns", "ns"),
          ("… times making `rotation-spline` of 10000 keys", "measured_vs_rotation_spline", "×"),
          ("a sample of `auto`", "auto_sample_ns", "ns"),
          ("a sample of `rational`", "rational_ns", "ns")]


def shown(number, unit=""):
    if number is None:
        return "not measured"
    text = f"{number:.1e}" if number < 1e-3 else f"{number:.3g}" if number < 1000 else f"{number:.0f}"
    return f"{text} {unit}".strip()


def targets_table(results):
    isa = results["isa"]
    weaker = 1.0 if results["contraction"] else WITHOUT_CONTRACTION.get(isa, 1.0)
    yield from ("| what | measured | target | |", "|---|---|---|---|")
    for rows, sign, exponent in ((AT_LEAST, "≥", 1), (AT_MOST, "≤", -1)):
        for text, member, on_v4, on_v3, unit, contraction in rows:
            found, target = results[member], {"v4": on_v4, "v3": on_v3}.get(isa)
            if target is not None and contraction:
                target *= weaker**exponent
            met = None if None in (found, target) else found >= target if sign == "≥" else found <= target
            verdict = {None: "", True: "met", False: "**missed**"}[met]
            wanted = f"{sign} {shown(target, unit)}" if target is not None else "none for this instruction set"
            yield f"| {text} | {shown(found, unit)} | {wanted} | {verdict} |"
    for text, member, unit in STATED:
        yield f"| {text} | {shown(results[member], unit)} | stated | |"


def columns_of(run, group):
    return [(number, n) for number in ("double", "float") for n in run.sizes(f"{group}/ours/{number}")]


def group_table(run, group, title, columns):
    yield f"| {title} | " + " | ".join(f"{number}, {n}" for number, n in columns) + " |"
    yield "|---" * (len(columns) + 1) + "|"
    for name in run.contenders(group):
        if "per segment" not in name:
            cells = [run.ns(f"{group}/{name}/{number}/{n}") for number, n in columns]
            yield f"| {name} | " + " | ".join("" if ns is None else shown(ns) for ns in cells) + " |"


def losses(run):
    """Where another one is faster."""
    for group in ("one_curve", "many"):
        for number, n in columns_of(run, group):
            ours = min(ns for form in ("ours", "ours bundled") if (ns := run.ns(f"{group}/{form}/{number}/{n}")))
            for name in run.contenders(group):
                theirs = run.ns(f"{group}/{name}/{number}/{n}")
                if not name.startswith("ours") and theirs is not None and theirs < ours:
                    where = f"{group.replace('_', ' ')}, {number}, {n}"
                    yield f"- {where}: {name} takes {shown(theirs)} ns, ours {shown(ours)} ns"


def contenders_table(run, scipy):
    """ns per sample, contender after contender."""
    columns = columns_of(run, "one_curve")
    yield from group_table(run, "one_curve", "ns per sample", columns)
    if "sample_ns" in scipy:
        cells = [shown(scipy["sample_ns"]) if column == ("double", 1_000_000) else "" for column in columns]
        yield f"| SciPy {scipy['version']} RotationSpline | " + " | ".join(cells) + " |"


def segments_table(run):
    yield from ("| samples per segment | records made on the way | records kept |", "|---|---|---|")
    found = (re.fullmatch(r"ours, samples per segment/(\d+)", name) for name in run.contenders("one_curve"))
    for count in sorted(int(match[1]) for match in found if match):
        made, kept = (f"one_curve/{form}, samples per segment/{count}/double" for form in ("ours", "ours compiled"))
        samples = run.sizes(made)[-1]
        yield f"| {count} | {shown(run.ns(f'{made}/{samples}'))} ns | {shown(run.ns(f'{kept}/{samples}'))} ns |"


def baked_table(run):
    forms = ("itself", "baked", "baked float")
    yield from ("| method | the curve itself | baked, 10⁻⁹ rad | baked, `float`, 10⁻⁶ rad |", "|---|---|---|---|")
    for method in sorted({name.split("/")[1] for name in run.entries if name.startswith("baked/")}):
        cells = [run.ns(f"baked/{method}/{form}") for form in forms]
        yield f"| `{method}` | " + " | ".join("" if cell is None else shown(cell) + " ns" for cell in cells) + " |"


def motion_table(run):
    yield from ("| method | orientation, ω, α and jerk at one time |", "|---|---|")
    for name in run.entries:
        if name.startswith("motion/"):
            yield f"| `{name.split('/')[1]}` | {shown(run.ns(name))} ns |"


def sets_table(runs):
    yield from ("| instruction set | ours, double | ours, float | peak, 10⁹ products and sums/s | Eigen product |",
                "|---|---|---|---|---|")
    for run in runs:
        cells = [run.ns(f"one_curve/{name}/1000000") for name in ("ours/double", "ours/float", "Eigen product/double")]
        peak = run.ns("limit/fma")
        cells.insert(2, 1.0 / peak if peak else None)
        yield f"| {run.context['isa']} | " + " | ".join("" if cell is None else shown(cell) for cell in cells) + " |"


def limits(run):
    one, two = (run.ns(f"limit/fma_on/threads:{n}") for n in (1, 2))
    size = max(run.sizes("one_curve/ours on two threads/double"), default=0)
    ours = run.ns(f"one_curve/ours/double/{size}"), run.ns(f"one_curve/ours on two threads/double/{size}")
    fresh = run.ns(f"fresh_pages/ours/double/{size}")
    faster = f"{one / two:.2f}" if one and two else "–"
    ours_faster = f"{ours[0] / ours[1]:.2f}" if None not in ours else "–"
    plain, streaming = (shown(run.ns(f"limit/write_{kind}")) for kind in ("plain", "streaming"))
    return (f"Writing 32 B: plain {plain} ns, streaming {streaming} ns. "
            f"Two threads are {faster} times as fast as one at products and sums, {ours_faster} times at sampling. "
            f"Into memory that was never touched a sample costs {shown(fresh)} ns.")


def page_text(results, runs, scipy):
    run = runs[0]
    kind = "with" if results["contraction"] else "without"
    yield f"{results['machine']}; {results['date']}; {results['compiler']}; instruction set {results['isa']},"
    yield f"{kind} contraction into fused multiply-adds; load at the start {results['load']:.1f}, that is of other programs:"
    yield "times would be shorter without them, ratios are of one run."
    yield from ("", *targets_table(results), "", limits(run), "")
    slower = list(losses(run))
    yield from (["Where another one is faster:", "", *slower, ""] if slower else [])
    for title, table in (("One curve", contenders_table(run, scipy)), ("Short segments", segments_table(run)),
                         ("Many curves", group_table(run, "many", "ns per curve", columns_of(run, "many"))),
                         ("Baked curves", baked_table(run)), ("Single motions", motion_table(run)),
                         ("Instruction sets", sets_table(runs))):
        yield from (f"## {title}", "", *table, "")


def fill(page, results, runs, scipy):
    start, end = "<!-- measured: written by benchmarks/ratios.py -->\n", "<!-- end of what is measured -->"
    fill_block(page, start, end, page_text(results, runs, scipy))
