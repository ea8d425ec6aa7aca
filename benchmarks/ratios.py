#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""From measurements to ratios: ratios.py FOLDER [--document PAGE]

Reads the measurements that run.py left in FOLDER, writes FOLDER/ratios.json and, if asked, fills the page.
"""
import argparse
import datetime
import json
import os
import pathlib
import platform
import re

FMA_PER_SAMPLE = 99  # counted in the machine code of the prototype: 99 vector instructions per 8 samples
RATIOS = "ratios.json"


def machine():
    cpus = pathlib.Path("/proc/cpuinfo")
    text = cpus.read_text("utf-8") if cpus.exists() else ""
    fields = {name: found[1].strip() for name in ("model name", "cpu family", "model")
              if (found := re.search(rf"^{name}\s*:(.*)$", text, re.M))}
    name = fields.get("model name") or platform.processor() or platform.machine()
    family = f" (family {fields['cpu family']}, model {fields['model']})" if "cpu family" in fields else ""
    return f"{name}{family}, {os.cpu_count()} cores, {platform.system()}"


class Run:
    """The medians of one run of orispline_bench."""

    def __init__(self, path):
        document = json.loads(path.read_text("utf-8"))
        self.context = document["context"]
        self.entries = {}
        for entry in document["benchmarks"]:
            if entry.get("aggregate_name", "median") == "median":
                name = re.sub(r"/(repeats:\d+|iterations:\d+|real_time)", "", entry["run_name"])
                self.entries[name] = entry

    def ns(self, name):
        """Nanoseconds per item; None where it was not measured."""
        entry = self.entries.get(name)
        return 1e9 / entry["items_per_second"] if entry else None

    def counter(self, name, counter):
        return self.entries.get(name, {}).get(counter)

    def sizes(self, start):
        """The numbers that end the names which start so."""
        found = (re.fullmatch(re.escape(start) + r"/(\d+)", name) for name in self.entries)
        return sorted(int(match[1]) for match in found if match)

    def contenders(self, group):
        found = (re.fullmatch(rf"{group}/(.+)/(double|float)/(\d+)", name) for name in self.entries)
        return sorted({match[1] for match in found if match}, key=lambda name: (not name.startswith("ours"), name))


def divided(a, b):
    return a / b if a is not None and b else None


def added(*parts):
    return None if None in parts else sum(parts)


def resampling(run):
    sizes = run.sizes("one_curve/ours/double")
    usual = max((n for n in sizes if n <= 1_000_000), default=0)
    most = max(sizes, default=0)
    ours = run.ns(f"one_curve/ours/double/{usual}")
    writes = [ns for name in ("limit/write_plain", "limit/write_streaming") if (ns := run.ns(name))]
    return {
        "vs_eigen_product": divided(run.ns(f"one_curve/Eigen product/double/{usual}"), ours),
        "vs_eigen_slerp": divided(run.ns(f"one_curve/Eigen slerp/double/{usual}"), ours),
        "vs_smooth": divided(run.ns(f"one_curve/smooth fitted cubic/double/{usual}"), ours),
        "fma_fraction": divided(divided(run.ns("limit/fma"), 1.0 / FMA_PER_SAMPLE), ours),
        "write_multiple": divided(run.ns(f"one_curve/ours/double/{most}"), min(writes, default=None)),
        "sample_ns": ours,
        "rates_ns": run.ns("rates/ours"),
        "vs_basalt_rates": divided(run.ns("rates/basalt So3Spline<4>"), run.ns("rates/ours")),
        "vs_eigen_rates": divided(run.ns("rates/Eigen product"), run.ns("rates/ours")),
    }


def across_curves(run):
    """The best form that the library has for curves with common key times, against the formula with libm."""
    results = {}
    for number, name in (("double", "many_curves_vs_libm"), ("float", "many_curves_float_vs_libm")):
        count = max(run.sizes(f"many/formula/{number}"), default=0)
        ours = [ns for form in ("ours", "ours bundled") if (ns := run.ns(f"many/{form}/{number}/{count}"))]
        results[name] = divided(run.ns(f"many/formula/{number}/{count}"), min(ours, default=None))
    return results


def construction(run):
    keys = max(run.sizes("setup/keyframes"), default=0)

    def part(name):
        return run.ns(f"setup/{name}/{keys}")

    return {
        "setup_ns_per_key": added(part("keyframes"), part("timed-c2")),
        "compile_ns_per_key": part("compile"),
        "auto_ns": added(part("keyframes"), part("auto")),
        "measured_ns": added(part("keyframes"), part("measured")),
        "measured_vs_rotation_spline": divided(part("measured"), run.ns("setup/rotation-spline/10000")),
        "auto_sample_ns": run.ns("auto/ours"),
    }


def rational(run):
    """A sample of `rational` beside that of the fastest other kernel for double."""
    usual = max((n for n in run.sizes("one_curve/ours/double") if n <= 1_000_000), default=0)
    most = max(run.sizes("many/ours bundled/double"), default=0)
    others = ("baked/timed-c2/itself", "baked/timed-c2/baked", "baked/squad/baked", "auto/ours",
              f"one_curve/ours/double/{usual}", f"many/ours bundled/double/{most}")
    ours = run.ns("baked/rational/itself")
    return {"rational_ns": ours,
            "rational_vs_fastest": divided(ours, min((ns for name in others if (ns := run.ns(name))), default=None))}


def fits(run, scipy):
    """Making SciPy's curve, by the number of keys."""
    return {f"rotation_spline_vs_scipy_{count}": divided(scipy.get(str(count)), run.ns(f"setup/rotation-spline/{count}"))
            for count in (10, 1000, 10_000)}


def ratios_of(run, scipy):
    context, fit_ns = run.context, scipy.get("fit_ns_per_key", {})
    results = {"machine": machine(), "date": datetime.date.today().isoformat(), "compiler": context["compiler"],
               "load": context.get("load_avg", [None])[0], "isa": context["isa"],
               "contraction": context["contraction"] == "true"}
    results |= resampling(run) | across_curves(run) | construction(run) | rational(run) | fits(run, fit_ns)
    results |= {"random_access_ns": run.ns("random/ours"),
                "random_access_vs_libm": divided(run.ns("random/Eigen product"), run.ns("random/ours")),
                "online_append_ns_p999": run.counter("online/append", "p999"),
                "max_error_double": float(context["max_error_double"]),
                "max_error_float": float(context["max_error_float"]),
                "vs_scipy": divided(scipy.get("sample_ns"), results["sample_ns"]),
                "setup_vs_scipy": divided(fit_ns.get("1000"),
                                          added(results["setup_ns_per_key"], results["compile_ns_per_key"]))}
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--document", type=pathlib.Path)
    chosen = parser.parse_args()
    runs = [Run(chosen.folder / name) for name in json.loads((chosen.folder / "runs.json").read_text("utf-8"))]
    peer = chosen.folder / "scipy.json"
    scipy = json.loads(peer.read_text("utf-8")) if peer.exists() else {}
    results = ratios_of(runs[0], scipy)
    (chosen.folder / RATIOS).write_text(json.dumps(results, indent=2) + "\n", "utf-8")
    from page import fill, targets_table  # beside this file
    print("\n".join(targets_table(results)))
    if chosen.document:
        fill(chosen.document, results, runs, scipy)


if __name__ == "__main__":
    main()
