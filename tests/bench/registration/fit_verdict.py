#!/usr/bin/env python3
"""Fits the verdict's probability to the CSVs of registration_evidence, and judges the verdict as it was compiled.

    tests/bench/registration/fit_verdict.py --train train.csv ...        # the coefficients of verdict.cpp
    tests/bench/registration/fit_verdict.py --test test.csv ... [--diagram reliability.svg]

A pose is right if it is in the right place (which of the places that look alike?) and precise enough there: two models,
whose probabilities are multiplied. Of --test, by the probability that the program itself stated: Brier score, the pairs
called right with 99 % or more that are wrong, the good pairs (true overlap 0.3 or more) that are refused. Standard
library only.
"""
import argparse
import csv
import math

# Of the coefficients' normal prior: separable classes must not give infinite certainty. The first, a constant, is free.
PRIOR_PRECISION, FREE = 0.5, 1e-3
REAL_COUNTS = 2  # a pair of a real set, of which there are few, as much as so many simulated ones
ACCEPTED = 0.85
MIN_OVERLAP, MAX_CONFLICT, OPEN_PROBABILITY = 0.3, 0.06, 0.2  # as in verdict.cpp
PLACE = ["1", "log conflict", "surface fit", "log held fit", "margin", "small margin with tracker", "without tracker"]
PRECISE = ["1", "log sigma", "log matches"]


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


def in_place(r):
    return r["error_m"] < 0.5 and r["error_deg"] < 3.0


def place_features(r):
    """As in verdict.cpp."""
    margin = max(-5.0, min(5.0, r["margin"]))
    return [1.0, math.log(r["conflict"] + 0.003), r["surface_fit"], math.log(r["held_fit"] + 0.01),
            margin, min(margin, 1.0) * r["tracker"], 1.0 - r["tracker"]]


def precise_features(r):
    """Sigma in units of what is right, 0.1 m and 0.5 degrees, and how many planes it rests on."""
    sigma = max(r["sigma_m"] / 0.1, r["sigma_deg"] / 0.5)
    return [1.0, math.log(min(sigma, 10.0) + 0.003), math.log(r["matches"] + 1.0)]


def succession(n):
    return (n + 0.5) / (n + 1.0)


def probability(models, r):
    place, precise = models
    placed = min(sigmoid(dot(place, place_features(r))), succession(r["facing"]), sigmoid(r["margin"]))
    return placed * sigmoid(dot(precise, precise_features(r)))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def precisions(n):
    return [FREE] + [PRIOR_PRECISION] * (n - 1)


def log_posterior(w, data):
    total = -0.5 * sum(p * v * v for p, v in zip(precisions(len(w)), w))
    for x, y in data:
        z = dot(w, x) if y else -dot(w, x)
        total -= math.log1p(math.exp(-z)) if z > -30 else -z
    return total


def fit(data):
    """Newton's method on (features, label), each step halved until it is one upwards."""
    n = len(data[0][0])
    w, height = [0.0] * n, log_posterior([0.0] * n, data)
    for _ in range(100):
        prior = precisions(n)
        gradient = [-p * v for p, v in zip(prior, w)]
        hessian = [[prior[i] * (i == j) for j in range(n)] for i in range(n)]
        for x, y in data:
            p = sigmoid(dot(w, x))
            for i in range(n):
                gradient[i] += (y - p) * x[i]
                for j in range(n):
                    hessian[i][j] += p * (1 - p) * x[i] * x[j]
        step = solve(hessian, gradient)
        for _ in range(30):
            better = [a + b for a, b in zip(w, step)]
            if log_posterior(better, data) >= height:
                break
            step = [0.5 * v for v in step]
        w, height = better, log_posterior(better, data)
        if max(abs(v) for v in step) < 1e-9:
            break
    return w


def barred(r):
    """The verdict's rules: what is never accepted, whatever the probability."""
    return undecided(r) or r["conflict"] > MAX_CONFLICT


def undecided(r):
    """Of these, what the scans agree on says nothing; the models are not fitted to them."""
    return r["open"] > 0 or min(r["overlap"], r["overlap_back"]) < MIN_OVERLAP


def called(w, r):
    p = probability(w, r)
    if r["open"] > 0:
        return min(p, OPEN_PROBABILITY)
    return min(p, 0.5) if barred(r) else p


def restate(rows, w):
    """What the verdict would state with these coefficients."""
    for r in rows:
        r["p"] = called(w, r)
        r["accepted"] = float(r["p"] >= ACCEPTED and not barred(r))


HEADING = ("| pairs of | pairs | wrong poses | Brier | accepted | wrong | p >= 0.99 | wrong | good | of them right but "
           "refused |\n|---|---|---|---|---|---|---|---|---|---|")


def report(title, rows):
    accepted = [r for r in rows if r["accepted"]]
    good = [r for r in rows if r["true_overlap"] >= 0.3]
    sure = [r for r in accepted if r["p"] >= 0.99]
    wrong = lambda some: sum(1 for r in some if not r["right"])
    brier = sum((r["p"] - r["right"]) ** 2 for r in rows) / max(1, len(rows))
    print(f"| {title} | {len(rows)} | {wrong(rows)} | {brier:.3f} | {len(accepted)} | {wrong(accepted)} | "
          f"{len(sure)} | {wrong(sure)} | {len(good)} | {sum(1 for r in good if r['right'] and not r['accepted'])} |")


def report_all(title, rows):
    print(HEADING)
    for name in sorted({r["set"] for r in rows}):
        report(name, [r for r in rows if r["set"] == name])
    report(title, rows)
    for r in rows:
        if r["accepted"] and not r["right"]:
            print("  accepted and wrong:", " ".join(f"{k} {v}" for k, v in r.items()))


def diagram(path, rows):
    """Observed share of right poses against the probability, ten bins and 90 % intervals of Wilson, as SVG."""
    bins = [[] for _ in range(10)]
    for r in rows:
        bins[min(9, int(10 * r["p"]))].append((r["p"], r["right"]))
    x = lambda v: 50 + 340 * v
    y = lambda v: 360 - 340 * v
    out = ['<svg xmlns="http://www.w3.org/2000/svg" width="420" height="410" font-family="sans-serif" font-size="12">',
           '<rect width="420" height="410" fill="white"/>',
           f'<path d="M{x(0)} {y(1)}V{y(0)}H{x(1)}" fill="none" stroke="black"/>',
           f'<path d="M{x(0)} {y(0)}L{x(1)} {y(1)}" stroke="#bbb"/>',
           f'<text x="{x(.5)}" y="398" text-anchor="middle">probability that the verdict states</text>',
           f'<text transform="translate(14 {y(.5)}) rotate(-90)" text-anchor="middle">share that was right</text>']
    for v in (0, 0.5, 1):
        out.append(f'<text x="{x(v)}" y="376" text-anchor="middle">{v}</text>')
        out.append(f'<text x="{x(0) - 8}" y="{y(v) + 4}" text-anchor="end">{v}</text>')
    for b in bins:
        if not b:
            continue
        n, mean, share = len(b), sum(p for p, _ in b) / len(b), sum(k for _, k in b) / len(b)
        z2 = 1.645 ** 2
        centre = (share + z2 / (2 * n)) / (1 + z2 / n)
        half = math.sqrt(z2 * (share * (1 - share) / n + z2 / (4 * n * n))) / (1 + z2 / n)
        out.append(f'<path d="M{x(mean):.1f} {y(centre - half):.1f}V{y(centre + half):.1f}" stroke="#369"/>')
        out.append(f'<circle cx="{x(mean):.1f}" cy="{y(share):.1f}" r="4" fill="#369"/>')
        out.append(f'<text x="{x(mean) + 7:.1f}" y="{y(share) + 14:.1f}" fill="#666">{n}</text>')
    with open(path, "w") as file:
        file.write("\n".join(out + ["</svg>"]) + "\n")


def read(paths):
    rows = [r for path in paths for r in csv.DictReader(open(path))]
    return [{k: v if k == "set" else float(v) for k, v in r.items()} for r in rows]


def fit_both(rows):
    judged = [r for r in rows for _ in range(REAL_COUNTS if r["set"].startswith("real") else 1) if not undecided(r)]
    return (fit([(place_features(r), float(in_place(r))) for r in judged]),
            fit([(precise_features(r), r["right"]) for r in judged if in_place(r)]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--train", nargs="+", default=[])
    parser.add_argument("--test", nargs="+", default=[])
    parser.add_argument("--diagram")
    options = parser.parse_args()
    if options.train:
        train = read(options.train)
        w = fit_both(train)
        for names, values in zip((PLACE, PRECISE), w):
            print(", ".join(f"{name} {value:.3f}" for name, value in zip(names, values)))
        restate(train, w)
        report_all("fitted to, all", train)
    if options.test:
        test = read(options.test)
        report_all("tested on, all", test)
        if options.diagram:
            diagram(options.diagram, test)


if __name__ == "__main__":
    main()
