# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""Plot how errors fall with the number of planes:

    pvpython PlotConvergence.py figures.csv picture.png

The file is one that CompareConvergence has written (--csv). One diagram for each solid: the RMS
distance of the surfaces' points between the contours, a straight line if it falls with a power of the
number of planes. Ruled surfaces have no such points. ParaView's Python has Matplotlib.
"""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot

STYLES = {
    "smooth": ("smooth patches", "#b5382a", 2.2),
    "fan": ("fans, least squares", "#2e5cb8", 1.6),
    "fan-centroid": ("fans, centroid", "#288c40", 1.6),
    "coons": ("Coons", "#8a5fb0", 1.6),
    "volume-xyz": ("volume, xyz", "#666666", 1.2),
    "volume-z": ("volume, z", "#999999", 1.2),
}


def read(name):
    curves = defaultdict(lambda: defaultdict(list))
    with open(name, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            curves[row["solid"]][row["method"]].append((int(row["planes"]), float(row["inner_rms"])))
    return curves


def draw(axes, solid, methods):
    for method, (label, color, width) in STYLES.items():
        if method in methods:
            planes, errors = zip(*methods[method])
            axes.loglog(planes, errors, marker="o", markersize=3, color=color, linewidth=width,
                        label=label)
    planes, errors = zip(*methods["smooth"])
    guide = [1.6 * errors[0] * (planes[0] / n) ** 4 for n in planes]
    axes.loglog(planes, guide, linestyle=":", color="#b5382a", linewidth=1, label="fourth power")
    axes.set_title(solid)
    ticks = sorted({n for curve in methods.values() for n, _ in curve})
    axes.set_xticks(ticks)
    axes.set_xticklabels([str(n) for n in ticks])
    axes.minorticks_off()
    axes.grid(True, color="#dddddd", linewidth=0.6)


def main(figures, picture):
    curves = read(figures)
    figure, all_axes = pyplot.subplots(1, len(curves), figsize=(3.2 * len(curves), 3.6), sharey=True)
    for axes, (solid, methods) in zip(all_axes, curves.items()):
        draw(axes, solid, methods)
    all_axes[0].set_ylabel("RMS distance inside patches")
    all_axes[len(curves) // 2].set_xlabel("planes on each axis")
    handles, labels = all_axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=len(labels), frameon=False, fontsize=9)
    figure.tight_layout(rect=(0, 0.07, 1, 1))
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
