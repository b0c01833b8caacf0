#!/usr/bin/env python3
"""The paper's two outdoor scenes, 10 m and 35 m between two sweeps of a simulated robot: paths without and with
embodiment, the paper's and ours, on the map that Scanway makes of the sweeps; pictures and tables on stdout.

usage: paper_paths.py SCANWAY DIR [--runs N]     (SCANWAY: the program; DIR: for logs, maps and pictures)
"""
import argparse
import json
import pathlib
import shutil
import statistics
import subprocess

ROBOT = pathlib.Path(__file__).resolve().parents[3] / "launch/robots/era_mobi_simulated.yaml"
# Name, world and seed, poses of the two sweeps in it, start and goal in the map (the first sweep's place is its origin).
SCENES = [
    ("10 m", ("yard", 1), ["-20,1,0.0831", "-10.035,1.83,0.0831"], "1,-1", "16.2,-14.8"),
    ("35 m", ("street", 2), ["-19,-14.5,0", "16,-14.5,0"], "4,-3", "37,-3"),
]
# The stages of what the paper calls FPFH: from the cloud to a rough pose.
ROUGH = ("voxels", "surfaces", "neighbours", "normals", "fpfh", "matching", "hypotheses", "checks")
# And of a first plan.
PLANNING = ("prepare", "search", "smooth", "measure")
MODES = {
    "point": "without embodiment",
    "paper": "the paper's, sigma 1 cm",
    "footprint": "ours, the footprint",
}


def run(scanway, *words):
    result = subprocess.run([scanway, *map(str, words)], check=True, capture_output=True, text=True)
    return result.stdout


def make_map(scanway, scene, folder):
    """Simulates and replays a scene; returns the seconds of each stage, both scans together."""
    name, (world, seed), poses, _, _ = scene
    log = folder / "sweeps.lcm"
    if not log.exists():
        places = [word for pose in poses for word in (f"--pose={pose}",)]
        run(scanway, "simulate", "sweep", "--world", world, "--seed", seed, "--thin", 2, *places, "-o", log)
    run(scanway, "replay", log, "-o", folder / "map", "--robot", ROBOT)
    report = json.loads((folder / "map/report.json").read_text())
    scans = report["scans"]
    assert all(scan["verdict"] == "accepted" for scan in scans), f"{name}: not registered"
    seconds = {}
    for scan in scans:
        for stage, value in scan["seconds"].items():
            seconds[stage] = seconds.get(stage, 0.0) + value
    return seconds


def plan(scanway, scene, folder, mode):
    _, _, _, start, goal = scene
    words = ["plan", folder / "map/costmap.yaml", f"--start={start}", f"--goal={goal}", "--robot", ROBOT]
    # In the paper a cell without an obstacle is free.
    words += ["--mode", mode, "--unknown", "free", "--json", "-o", folder / mode]
    answer = json.loads(run(scanway, *words))
    assert answer["status"] == "ok", f"{mode}: {answer['status']}"
    shutil.copy(folder / mode / "path.png", folder / f"{mode}.png")
    return answer


def spread(values):
    deviation = statistics.stdev(values) if len(values) > 1 else 0.0
    return f"{statistics.mean(values):.2f} ± {deviation:.2f}"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("scanway")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    times = {}
    print("| scene | path | length, m | clearance from the centre or the footprint, m | at | seconds to drive |")
    print("|---|---|---|---|---|---|")
    for scene in SCENES:
        folder = options.folder / scene[0].replace(" ", "")
        folder.mkdir(parents=True, exist_ok=True)
        rows = [make_map(options.scanway, scene, folder) for _ in range(options.runs)]
        times[scene[0], "FPFH"] = [sum(row.get(stage, 0.0) for stage in ROUGH) for row in rows]
        times[scene[0], "ICP"] = [row.get("icp", 0.0) for row in rows]
        for mode, what in MODES.items():
            answers = [plan(options.scanway, scene, folder, mode) for _ in range(options.runs)]
            times[scene[0], mode] = [sum(a["seconds"][stage] for stage in PLANNING) for a in answers]
            answer = answers[0]
            x, y = answer["clearance_at_m"]
            print(f"| {scene[0]} | {what} | {answer['length_m']:.2f} | {answer['clearance_m']:.3f} "
                  f"| ({x:.2f}, {y:.2f}) | {answer['duration_s']:.1f} |")
    paper = {"FPFH": ("38.4 ± 6.4", "38.7 ± 6.1"), "ICP": ("2.9 ± 1.7", "3.0 ± 1.8"), "paper": ("2.4 ± 0.3", "2.5 ± 0.4")}
    names = {"FPFH": "FPFH and matching", "ICP": "ICP", "paper": "D* Lite, paper's cost", "footprint": "D* Lite, footprint"}
    print(f"\n| seconds, mean ± deviation of {options.runs} | the paper's, 10 m | ours | the paper's, 35 m | ours |")
    print("|---|---|---|---|---|")
    for key, name in names.items():
        first, second = paper.get(key, ("-", "-"))
        print(f"| {name} | {first} | {spread(times['10 m', key])} | {second} | {spread(times['35 m', key])} |")


if __name__ == "__main__":
    main()
