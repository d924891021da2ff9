# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window on a display of its own (Xvfb), worked as a user would, and looked at.

    window = Window("/path/of/the/plugin", macros=["/path/of/macros"])
    pictures = window.play(events, scratch)

`events` are elements of ParaView's own test scripts, as event(), check(), pause() and picture() make
them, in the order in which they happen. Each picture is taken from the screen and comes back as an
array of NumPy (height, width, 3). What ParaView prints is in `window.log`.
"""

import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import time
import zlib
from xml.sax.saxutils import quoteattr

import numpy

PANEL = "pqClientMainWindow/propertiesDock/propertiesPanel"
SETTINGS = """[General]
GeneralSettings.ShowWelcomeDialog=false
[MainWindow]
Size=@Size({width} {height})
Position=@Point(0 0)
"""
# Copies what the display shows once the window is drawn; a macro, so that a step can be a picture.
MACRO = """
import shutil
shutil.copyfile({framebuffer!r}, {raw!r})
"""


def event(place, command, arguments=""):
    return (f"<pqevent object={quoteattr(place)} command={quoteattr(command)} "
            f"arguments={quoteattr(arguments)} />")


def check(place, name, value):
    return (f"<pqcheck object={quoteattr(place)} property={quoteattr(name)} "
            f"arguments={quoteattr(value)} />")


def pause(milliseconds):
    return event("pqClientMainWindow", "pause", str(milliseconds))


def menu(name, action, submenu=""):
    """An entry of a menu or of its submenu, by their names in Qt."""
    bar = "pqClientMainWindow/menubar"
    return event(f"{bar}/{name}" + (f"/{submenu}" if submenu else ""), "activate", action)


def apply():
    return event(f"{PANEL}/Accept", "activate")


def macro(name):
    return menu("menu_Macros", name)


def picture(name):
    """The screen after all that was asked for before has been drawn."""
    return pause(700) + "\n" + macro(f"Picture {name}")


class Window:
    """One run of ParaView after another, each with settings of its own and an empty pipeline."""

    def __init__(self, plugin, macros=(), size=(1200, 800)):
        self.plugin = pathlib.Path(plugin)
        self.macros = [str(folder) for folder in macros]
        self.size = size
        self.log = ""

    def play(self, events, names=(), timeout=120):
        """The pictures `names` by name. RuntimeError with what ParaView printed if a step fails."""
        with tempfile.TemporaryDirectory() as scratch:
            scratch = pathlib.Path(scratch)
            display = self.start_display(scratch)
            try:
                self.run(events, names, scratch, display[1], timeout)
            finally:
                display[0].terminate()
                display[0].wait()
            return {name: read_framebuffer(scratch / f"{name}.raw") for name in names}

    def start_display(self, scratch):
        """Xvfb on the first free display; it keeps its picture in a file."""
        reading, writing = os.pipe()
        width, height = self.size
        command = ["Xvfb", "-displayfd", str(writing), "-noreset", "-nolisten", "tcp",
                   "-fbdir", str(scratch), "-screen", "0", f"{width}x{height}x24"]
        process = subprocess.Popen(command, pass_fds=[writing], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as pipe:
            return process, pipe.readline().strip()

    def run(self, events, names, scratch, display, timeout):
        settings = scratch / "home" / ".config" / "ParaView"
        settings.mkdir(parents=True)
        text = SETTINGS.format(width=self.size[0], height=self.size[1])
        for version in ("5.11.0", "5.13.2"):
            (settings / f"ParaView{version}.ini").write_text(text)
        macros = scratch / "macros"
        macros.mkdir()
        for name in names:
            (macros / f"Picture {name}.py").write_text(MACRO.format(
                framebuffer=str(scratch / "Xvfb_screen0"), raw=str(scratch / f"{name}.raw")))
        script = scratch / "script.xml"
        script.write_text('<?xml version="1.0" ?>\n<pqevents>\n' + "\n".join(events) + "\n</pqevents>\n")
        environment = dict(os.environ, HOME=str(scratch / "home"), DISPLAY=f":{display}",
                           QT_QPA_PLATFORM="xcb", PV_MACRO_PATH=":".join(self.macros + [str(macros)]),
                           XDG_RUNTIME_DIR=str(scratch))
        for name in ("XDG_CONFIG_HOME", "XAUTHORITY", "LD_LIBRARY_PATH"):
            environment.pop(name, None)
        command = [shutil.which("paraview"), "--dr", f"--plugin-search-paths={self.plugin.parent}",
                   "--plugins=OrthogonalSlices", f"--test-directory={scratch}",
                   f"--test-script={script}", "--exit"]
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=timeout)
        self.log = done.stdout
        if done.returncode != 0:
            raise RuntimeError(f"ParaView ended with {done.returncode}:\n{done.stdout}")


def read_framebuffer(path):
    """The picture in a file as Xvfb keeps it: a window dump of X11 with 32 bits for each pixel."""
    data = path.read_bytes()
    head = struct.unpack(">25I", data[:100])
    start = head[0] + 12 * head[19]
    width, height, line = head[4], head[5], head[12]
    rows = numpy.frombuffer(data, numpy.uint8, line * height, start).reshape(height, line)
    pixels = rows[:, :4 * width].reshape(height, width, 4)
    return pixels[:, :, [2, 1, 0] if head[7] == 0 else [1, 2, 3]].copy()


def write_png(path, pixels, colors=256):
    """A PNG with a palette: the colors that occur most, each other one by the nearest of them."""
    height, width, _ = pixels.shape
    coarse = (pixels.astype(int) >> 2).reshape(-1, 3) @ [4096, 64, 1]
    keys, places, counts = numpy.unique(coarse, return_inverse=True, return_counts=True)
    chosen = keys[numpy.argsort(-counts, kind="stable")[:colors]]

    def parts(key):
        return numpy.stack([key >> 12, (key >> 6) & 63, key & 63], axis=1)

    distance = ((parts(keys)[:, None, :] - parts(chosen)[None, :, :]) ** 2).sum(axis=2)
    indices = distance.argmin(axis=1)[places.reshape(-1)].astype(numpy.uint8)
    palette = numpy.zeros((len(chosen), 3))
    total = numpy.bincount(indices, minlength=len(chosen))
    for channel in range(3):
        values = pixels.reshape(-1, 3)[:, channel]
        sums = numpy.bincount(indices, weights=values, minlength=len(chosen))
        palette[:, channel] = sums / numpy.maximum(total, 1)
    rows = numpy.zeros((height, width + 1), numpy.uint8)
    rows[:, 1:] = indices.reshape(height, width)
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)),
              (b"PLTE", palette.round().astype(numpy.uint8).tobytes()),
              (b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b"")]
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in chunks:
            file.write(struct.pack(">I", len(data)) + kind + data
                       + struct.pack(">I", zlib.crc32(kind + data)))
