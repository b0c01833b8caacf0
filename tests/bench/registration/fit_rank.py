#!/usr/bin/env python3
"""Fits the verdict's logistic models to the CSV of registration_evidence, and tests each on the sets left out.

    registration_evidence ../shared/data > evidence.csv
    tests/bench/registration/fit_verdict.py evidence.csv

Prints the coefficients of verdict.cpp: the rank (log-odds of one pose by its own evidence) and the probability (by the
rank of the best pose and its margin to the next). Standard library only.
"""
import collections
import csv
import math
import sys

PRIOR_PRECISION = 0.2  # of the coefficients' normal prior: separable classes must not give infinite certainty
MAX_MARGIN = 5.0


def solve(a, b):
    n = len(b)
    m = [row[:] + [b[i]] for i, row in enumerate(a)]
    for i in range(n):
        p = max(range(i, n), key=lambda r: abs(m[r][i]))
        m[i], m[p] = m[p], m[i]
        for r in range(n):
            if r != i:
                f = m[r][i] / m[i][i]
                m[r] = [x - f * y for x, y in zip(m[r], m[i])]
    return [m[i][n] / m[i][i] for i in range(n)]


def sigmoid(z):
    return 1.0 / (1.0 + math.exp(-max(-40.0, min(40.0, z))))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def fit(rows):
    """Newton's method; rows are (features, label, weight)."""
    n = len(rows[0][0])
    w = [0.0] * n
    for _ in range(60):
        gradient = [-PRIOR_PRECISION * v for v in w]
        hessian = [[PRIOR_PRECISION * (i == j) for j in range(n)] for i in range(n)]
        for x, y, weight in rows:
            p = sigmoid(dot(w, x))
            for i in range(n):
                gradient[i] += weight * (y - p) * x[i]
                for j in range(n):
                    hessian[i][j] += weight * p * (1 - p) * x[i] * x[j]
        step = solve(hessian, gradient)
        w = [a + max(-2.0, min(2.0, b)) for a, b in zip(w, step)]
        if max(abs(s) for s in step) < 1e-9:
            break
    return w


def features(r):
    return [1.0, r["surface_fit"], math.log(r["conflict"] + 0.003)]


def by_pair(rows):
    pairs = collections.defaultdict(list)
    for r in rows:
        pairs[r["pair"]].append(r)
    return pairs.values()


def best_rows(rows, w):
    result = []
    for pair in by_pair(rows):
        ranked = sorted(pair, key=lambda r: -dot(w, features(r)))
        best = ranked[0]
        if best["right"] < 0:
            continue
        rank = dot(w, features(best))
        margin = min([MAX_MARGIN] + [rank - dot(w, features(r)) for r in ranked[1:]])
        result.append(([1.0, rank, margin], best["right"], 1.0, best))
    return result


def train(rows):
    w = fit([(features(r), r["right"], 1.0) for r in rows if r["right"] >= 0])
    v = fit([row[:3] for row in best_rows(rows, w)])
    return w, v


def main():
    rows = [{k: v if k == "set" else float(v) for k, v in r.items()} for r in csv.DictReader(open(sys.argv[1]))]
    groups = sorted({r["set"].replace("across_", "") for r in rows})
    print("left out                     pairs  Brier   right<0.9  wrong>=0.9")
    for group in groups:
        w, v = train([r for r in rows if r["set"].replace("across_", "") != group])
        test = best_rows([r for r in rows if r["set"].replace("across_", "") == group], w)
        p = [sigmoid(dot(v, x)) for x, _, _, _ in test]
        brier = sum((a - t[1]) ** 2 for a, t in zip(p, test)) / len(test)
        lost = sum(1 for a, t in zip(p, test) if t[1] == 1 and a < 0.9)
        wrong = [(round(a, 3), t[3]) for a, t in zip(p, test) if t[1] == 0 and a >= 0.9]
        print(f"{group:28s} {len(test):5d}  {brier:.4f}  {lost:9d}  {len(wrong):10d}")
        for entry in wrong:
            print("    ", entry)
    w, v = train(rows)
    print("rank: 1, surface_fit, log(conflict + 0.003):", [round(x, 3) for x in w])
    print("probability: 1, rank, margin:", [round(x, 3) for x in v])


if __name__ == "__main__":
    main()
