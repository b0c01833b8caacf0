#!/usr/bin/env python3
"""Accuracy by world and distance, and whether the covariance is honest, from the CSVs of registration_evidence.

    tests/bench/registration/accuracy.py evidence.csv ...

Right is within 0.1 m and 0.5 degrees of the truth (real sets: their own limits), before any verdict. Standard library
only.
"""
import csv
import sys

BINS = [(0, 5), (5, 12), (12, 20), (20, 30), (30, 45)]
FEW_PAIRS = 3


def read(paths):
    return [{k: v if k == "set" else float(v) for k, v in r.items()} for path in paths for r in csv.DictReader(open(path))]


def quantile(values, q):
    values = sorted(values)
    return values[min(len(values) - 1, int(q * len(values)))] if values else float("nan")


def cell(rows):
    if len(rows) < FEW_PAIRS:
        return "-"
    right = [1000 * r["error_m"] for r in rows if r["right"]]
    median = f"{quantile(right, 0.5):.1f} mm " if right else ""
    return f"{median}({len(right)} of {len(rows)})"


def main():
    rows = [r for r in read(sys.argv[1:]) if not r["set"].startswith("across")]
    print("| set | " + " | ".join(f"{a} to {b} m" for a, b in BINS) + " |\n|---" + "|---" * len(BINS) + "|")
    for name in sorted({r["set"] for r in rows}):
        here = [r for r in rows if r["set"] == name]
        print(f"| {name} | " + " | ".join(cell([r for r in here if a <= r["distance"] < b]) for a, b in BINS) + " |")
    for tracker, name in ((1, "with the tracker"), (0, "without")):
        for kind, real in (("simulated", False), ("real", True)):
            good = [r for r in rows if r["true_overlap"] >= 0.3 and r["tracker"] == tracker
                    and r["set"].startswith("real") == real and r["set"] not in ("corridor", "field")]
            print(f"overlap 0.3 or more, {kind}, {name}: {sum(r['right'] for r in good):.0f} of {len(good)} right, "
                  f"{sum(r['right'] * r['accepted'] for r in good):.0f} of them accepted")
    placed = [r for r in rows if r["error_m"] < 0.5 and r["error_deg"] < 3 and r["matches"] > 0 and not r["open"]]
    for what, error, sigma in (("translation", "error_m", "sigma_m"), ("rotation", "error_deg", "sigma_deg")):
        ratio = [r[error] / r[sigma] for r in placed]
        print(f"{what}, error over deviation of the least known direction, {len(ratio)} pairs in the right place: " +
              ", ".join(f"{100 * q:.0f} % below {quantile(ratio, q):.1f}" for q in (0.5, 0.9, 0.99)))


if __name__ == "__main__":
    main()
