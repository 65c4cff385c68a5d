#!/usr/bin/env python3
"""Evaluations per second of PySPH and of Erode on the same machine: see README.md."""

import json
import re
import resource
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HOME = ROOT / "target" / "peers"

# Name, example and its options, steps, workload of `erode bench`.
CLASSES = [
    ("liquid", ["dam_break_2d"], 400, "liquid-plane"),
    ("elastic solid", ["solid_mech.rings"], 100, "solid-plane"),
]


def install():
    """A virtual environment with PySPH."""
    python = HOME / "bin" / "python"
    if not python.exists():
        venv.create(HOME, with_pip=True)
    # Its examples print arrays of one number as numbers, which newer versions of NumPy refuse.
    wanted = ["pysph", "numpy<2", "setuptools"]
    subprocess.run([python, "-m", "pip", "install", "-q", *wanted], check=True)
    return HOME / "bin" / "pysph"


def seconds(pysph, example, steps):
    """Processor time and number of particles of a run with so many steps."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        run = [pysph, "run", *example, "--max-steps", str(steps), "-d", folder]
        run += ["--disable-output", "--no-openmp"]
        done = subprocess.run(run, capture_output=True, text=True)
    text = done.stdout + done.stderr
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    particles = sum(int(n) for n in re.findall(r"^  (?!Total)\w+: (\d+)$", text, re.M))
    # What fails behind the run is a picture that nobody asked for.
    if particles == 0 or "Run took" not in text:
        sys.exit(f"PySPH did not run {example[0]}:\n{text[-2000:]}")
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return used, particles


def of_pysph(pysph, example, steps):
    """Million evaluations per second: a long run less a short one, so that compiling and setting up do not count."""
    seconds(pysph, example, 2)
    short, _ = seconds(pysph, example, 10)
    long, particles = seconds(pysph, example, 10 + steps)
    return 1e-6 * steps * particles / (long - short), particles


def of_erode(workload):
    """Million evaluations per second of processor time, one thread."""
    file = HOME / "erode.json"
    run = ["cargo", "run", "--release", "-q", "-p", "erode", "--", "bench", "--case", workload]
    subprocess.run([*run, "--json", file], check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
    found = json.loads(file.read_text())["workloads"][0]
    return found["runs"][0]["rate_per_processor_second"], found["particles"]


def main():
    pysph = install()
    print("million evaluations per particle and second of processor time, one thread")
    for name, example, steps, workload in CLASSES:
        theirs, n = of_pysph(pysph, example, steps)
        ours, m = of_erode(workload)
        print(f"{name:14} PySPH {theirs:6.3f} ({n} particles)   Erode {ours:6.3f} ({m} particles)   ratio {ours / theirs:5.1f}")


if __name__ == "__main__":
    main()
