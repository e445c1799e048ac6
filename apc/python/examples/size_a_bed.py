# Sizes a bed for a CRJ-200, looks at it from several sides, and judges it. Run as a script, or cell by cell in an
# editor that knows "# %%".
#
#     PYTHONPATH=build/release/python python3 apc/python/examples/size_a_bed.py OUT

# %% What is asked
import pathlib
import sys

import numpy as np

import apc

out = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out/size_a_bed")
knot, foot = 1852 / 3600, 0.3048

# %% The shortest bed that stops it from 70 kt with the nose gear's drag within its limit
design = apc.design("acrp29_crj_200", folder=out)
bed = design.bed
print(f"{bed.length:.1f} m long, {bed.depth.max():.3f} m deep, {bed.volume:.0f} m³;",
      f"two methods differ by {100 * design.certificate.difference:.3f} %")

# %% One overrun in it
run = apc.simulate("CRJ-200", bed, "70 kt", mass="53000 lb", braking=0.25)
nose = run.history.gears.nose
print(f"{run.outcome} after {run.stop_distance:.1f} m; nose drag at most {nose.drag.max() / 1000:.1f} kN,",
      f"{100 * nose.drag.max() / run.gears.nose.drag_limit:.0f} % of its limit")

# %% Stop distance over exit speed, braked and not
speeds = np.arange(40, 81, 5)
study = apc.study("CRJ-200", bed, speeds * knot, masses="53000 lb", braking=[0.0, 0.25])
braked = study.braking > 0
assert np.all(np.diff(study.stop_distance[braked & np.isfinite(study.stop_distance)]) > 0)

# %% How sure is it?
reliability = apc.reliability(design.file, out, samples=400)[0]
value, low, high = reliability.arrest
print(f"arrests {100 * value:.1f} % of all overruns (95 %: {100 * low:.1f} to {100 * high:.1f} %);",
      f"97.5 % of the samples from at least {reliability.arrest_speed_975 / knot:.1f} kt")

# %% And does it meet the requirements, behind a runway end?
report = apc.report(design.file, out, site="example_runway_end")
print(", ".join(f"{count} {result}" for result, count in report.counts.items()), "-", report.page)

# %% Pictures, where matplotlib is installed
try:
    import matplotlib.pyplot as plot
except ImportError:
    print("matplotlib is not installed: no pictures")
else:
    figure, (section, distances, speed) = plot.subplots(3, 1, figsize=(8, 10), constrained_layout=True)
    section.fill_between(bed.distance, -bed.depth, 0, color="#e9dfc6")
    section.plot(nose.distance, -nose.rut, label="rut of the nose wheels")
    section.set(xlabel="distance from the leading edge, m", ylabel="height, m", title="The bed and the rut in it")
    section.legend()
    for name, rows in (("braked 0.25", braked), ("unbraked", ~braked)):
        distances.plot(study.speed[rows] / knot, study.stop_distance[rows], "o-", label=name)
    distances.axhline(bed.length, color="firebrick", linestyle="--", label="end of the bed")
    distances.set(xlabel="exit speed, kt", ylabel="stop distance, m")
    distances.legend()
    speed.plot(reliability.arrest_speeds / knot, 1 - np.linspace(0, 1, reliability.arrest_speeds.size))
    speed.axhline(0.975, color="firebrick", linestyle="--")
    speed.set(xlabel="exit speed, kt", ylabel="share of samples arrested")
    figure.savefig(out / "size_a_bed.png", dpi=110)
    print(out / "size_a_bed.png")
