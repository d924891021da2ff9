# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestWindow.py <plugin> <Macros> <baselines> [<new.png>]: what a user does in ParaView's
window, from a source to the surface, its graph, the inspection view and the help page.

Compares what is there with what has to be: layouts, views, what is shown and by what it is colored,
messages; and the window with a picture of it. The picture is compared in blocks, so that fonts and the
shading of single triangles do not matter; <new.png> is where it is written, to take the place of the
baseline where it is meant to change. Baselines are Window-5.11.png and so on, for each version of
ParaView that is known; the window of others is not compared.
"""

import json
import pathlib
import sys
import tempfile

import numpy

from ParaViewWindow import (
    PANEL, Window, apply, check, event, macro, menu, paraview_version, picture, read_png, write_png)

SIZE = (1180, 780)
BLOCK = 16  # pixels
DIALOG = "pqClientMainWindow/SelectInputDialog"
# Writes down what is in the window; a number is appended for each time.
FACTS = """
import json, pathlib
from paraview import servermanager, simple
def facts_of(display):
    array = list(display.ColorArrayName) if hasattr(display, "ColorArrayName") else []
    kind = str(display.Representation).strip("'")
    return [display.Input.SMProxy.GetXMLName(), display.Input.Port, kind, array]
sources = simple.GetSources()
views = simple.GetViews()
layouts = servermanager.ProxyManager().GetProxiesInGroup("layouts")
shown = [facts_of(display) for view in simple.GetViews(viewtype="RenderView")
         for display in view.Representations
         if display.Visibility and hasattr(display, "Input") and hasattr(display, "Representation")]
cells = {{key[0]: source.GetDataInformation(0).GetNumberOfCells() for key, source in sources.items()}}
place = pathlib.Path({folder!r})
number = len(list(place.glob("*.json")))
(place / f"{{number}}.json").write_text(json.dumps({{
    "sources": sorted(cells), "cells": cells, "layouts": len(layouts), "shown": shown,
    "views": sorted(view.GetXMLName() for view in views)}}))
"""
GRAPH = """
from paraview import simple
result = simple.GetActiveSource()
simple.Hide(result)
simple.Show(simple.OutputPort(result, 1))
simple.Render()
simple.SetActiveSource(result)
"""


def help_page():
    """The help button opens the page of the filter."""
    return [event(f"{PANEL}/Help", "activate"),
            check("pqClientMainWindow/pqHelpWindow/1QTextBrowser0", "documentTitle",
                  "Orthogonal Slice Reconstruction")]


def steps(look_while_undone):
    filters = "Orthogonal Slices"
    information = ("pqClientMainWindow/informationDock/informationWidgetFrame/informationScrollArea/"
                   "qt_scrollarea_viewport/informationWidget")
    # One stack takes the slicer's contours, which are active, and asks nothing.
    sequence = [menu("menuSources", "SphereSource", "Alphabetical"), apply(),
                menu("menuFilters", "OrthogonalSlicer", filters), apply(),
                menu("menuFilters", "ParallelSliceReconstruction", filters), apply(),
                check(f"{information}/dataArraysTable", "modelItemData", "0.0,Disagreement"),
                event(f"{PANEL}/Delete", "activate"),
                menu("menuFilters", "OrthogonalSliceReconstruction", filters)]
    # The dialog asks for the three inputs by name; ports of the slicer in the pipeline's tree.
    for number, family in enumerate(("XSlices", "YSlices", "ZSlices")):
        sequence += [event(f"{DIALOG}/buttonFrame/{family}", "set_boolean", "true"),
                     event(f"{DIALOG}/pipelineView", "currentChanged", f"/0/0/0/{number}|0")]
    sequence += [event(f"{DIALOG}/buttonBox/1QPushButton0", "activate"), apply(),
                 check(f"{information}/dataType", "text", "Polygonal Mesh"),
                 # From ParaView 5.13 on, a macro ends what can be done again.
                 menu("menu_Edit", "actionEditUndo"), *([macro("Facts")] if look_while_undone else []),
                 menu("menu_Edit", "actionEditRedo"), picture("surface"), macro("Facts"),
                 macro("Graph"), macro("Facts"), macro("Inspect Slices"), macro("Facts")]
    return sequence


def require(condition, sentence):
    if not condition:
        raise AssertionError(sentence)


def check_facts(facts):
    """What the user sees: Apply undone, done again, with the graph, with the inspection view."""
    *undone, applied, graph, inspected = facts
    require(applied["views"] == ["RenderView"], f"Apply leaves the views {applied['views']}")
    require(applied["layouts"] == 1, f"there are {applied['layouts']} layouts")
    name = "OrthogonalSliceReconstruction"
    plain = [name, 0, "Surface", [None, ""]]
    require(applied["shown"] == [plain], f"Apply shows {applied['shown']}")
    for before in undone:
        require(plain not in before["shown"], f"undone, there is {before['shown']}")
    colored = [name, 1, "Surface", ["CELLS", "SliceRmsDisagreement"]]
    require(graph["shown"] == [colored], f"the graph is shown as {graph['shown']}")
    require(inspected["views"] == ["RenderView"] * 3 + ["XYChartView"],
            f"the inspection view consists of {inspected['views']}")
    require(inspected["layouts"] == 2, f"there are {inspected['layouts']} layouts")


def blocks(pixels):
    """The mean color of each block."""
    height, width = (length // BLOCK for length in pixels.shape[:2])
    parts = pixels[:height * BLOCK, :width * BLOCK].astype(float)
    return parts.reshape(height, BLOCK, width, BLOCK, 3).mean(axis=(1, 3))


def check_picture(found, baseline):
    """As the picture, but for a fiftieth of the blocks: the numbers in the status bar, the mouse."""
    require(found.shape == baseline.shape, f"the window is {found.shape}, not {baseline.shape}")
    difference = numpy.abs(blocks(found) - blocks(baseline)).max(axis=2)
    share = (difference > 24.0).mean()
    require(share < 0.02, f"{100 * share:.1f} % of the window look different")


def main(plugin, macros, baselines, new=None):
    version = paraview_version()
    baseline = pathlib.Path(baselines) / f"Window-{version.rsplit('.', 1)[0]}.png"
    with tempfile.TemporaryDirectory() as folder:
        window = Window(plugin, [macros], SIZE)
        pictures = window.play(steps(version.startswith("5.11.")) + help_page(), ["surface"],
                               {"Facts": FACTS.format(folder=folder), "Graph": GRAPH})
        messages = [line for line in window.log.splitlines() if "WARN|" in line or "ERR|" in line]
        require(not messages, f"slices that agree have messages:\n{window.log}")
        paths = sorted(pathlib.Path(folder).glob("*.json"))
        check_facts([json.loads(path.read_text()) for path in paths])
    if new:
        write_png(new, pictures["surface"], 64)
    if baseline.exists():
        check_picture(pictures["surface"], read_png(baseline))
    print("window: all checks passed")


if __name__ == "__main__":
    main(*sys.argv[1:])
