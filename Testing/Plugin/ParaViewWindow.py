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
import re
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
    """An entry of a menu or of its submenu, by their names in Qt. Submenus come with the menu."""
    bar = "pqClientMainWindow/menubar"
    if not submenu:
        return event(f"{bar}/{name}", "activate", action)
    return event(bar, "activate", name) + "\n" + event(f"{bar}/{name}/{submenu}", "activate", action)


def apply():
    return event(f"{PANEL}/Accept", "activate")


def macro(name):
    return menu("menu_Macros", name)


def picture(name):
    """The screen after all that was asked for before has been drawn."""
    return pause(700) + "\n" + macro(f"Picture {name}")


def paraview_version():
    """Of the program that is started: 5.11.0. Its companion says it without a display."""
    environment = dict(os.environ)
    environment.pop("LD_LIBRARY_PATH", None)
    text = subprocess.run(["pvpython", "--version"], env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=60).stdout
    return re.search(r"\d+\.\d+\.\d+", text).group()


class Window:
    """One run of ParaView after another, each with settings of its own and an empty pipeline."""

    def __init__(self, plugin, macros=(), size=(1200, 800)):
        self.plugin = pathlib.Path(plugin)
        self.macros = [str(folder) for folder in macros]
        self.size = size
        self.log = ""

    def play(self, events, names=(), code=None, timeout=120):
        """The pictures `names` by name. `code` has the Python code of more macros by their names.
        RuntimeError with what ParaView printed if a step fails."""
        with tempfile.TemporaryDirectory() as scratch:
            scratch = pathlib.Path(scratch)
            display = self.start_display(scratch)
            try:
                self.write_macros(scratch / "macros", scratch, names, code or {})
                self.run(events, scratch, display[1], timeout)
            finally:
                display[0].terminate()
                display[0].wait()
            return {name: crop(read_framebuffer(scratch / f"{name}.raw")) for name in names}

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

    def write_macros(self, folder, scratch, names, code):
        folder.mkdir()
        for name in names:
            (folder / f"Picture {name}.py").write_text(MACRO.format(
                framebuffer=str(scratch / "Xvfb_screen0"), raw=str(scratch / f"{name}.raw")))
        for name, text in code.items():
            (folder / f"{name}.py").write_text(text)

    def run(self, events, scratch, display, timeout):
        settings = scratch / "home" / ".config" / "ParaView"
        settings.mkdir(parents=True)
        text = SETTINGS.format(width=self.size[0], height=self.size[1])
        (settings / f"ParaView{paraview_version()}.ini").write_text(text)
        script = scratch / "script.xml"
        script.write_text('<?xml version="1.0" ?>\n<pqevents>\n' + "\n".join(events) + "\n</pqevents>\n")
        environment = dict(os.environ, HOME=str(scratch / "home"), DISPLAY=f":{display}",
                           QT_QPA_PLATFORM="xcb", PV_MACRO_PATH=":".join(self.macros + [str(scratch / "macros")]),
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


def crop(pixels):
    """The window alone: without the black of the display around it."""
    lit = pixels.max(axis=2) > 0
    rows, columns = lit.any(axis=1).nonzero()[0], lit.any(axis=0).nonzero()[0]
    return pixels[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]


def choose_palette(keys, counts, colors):
    """Half of it the colors that occur most, half those that are farthest from all before."""
    chosen = list(numpy.argsort(-counts, kind="stable")[:colors // 2])
    distance = numpy.full(len(keys), numpy.inf)
    for place in range(min(colors, len(keys))):
        if place >= len(chosen):
            chosen.append(distance.argmax())
        distance = numpy.minimum(distance, ((keys - keys[chosen[place]]) ** 2).sum(axis=1))
    return keys[chosen]


def write_png(path, pixels, colors=256):
    """A PNG with a palette of so many colors; each other one by the nearest of them."""
    height, width, _ = pixels.shape
    coarse = (pixels.astype(int) >> 2).reshape(-1, 3) @ [4096, 64, 1]
    keys, places, counts = numpy.unique(coarse, return_inverse=True, return_counts=True)
    keys = numpy.stack([keys >> 12, (keys >> 6) & 63, keys & 63], axis=1)
    chosen = choose_palette(keys, counts, colors)
    nearest = numpy.array([((chosen - key) ** 2).sum(axis=1).argmin() for key in keys])
    indices = nearest[places.reshape(-1)].astype(numpy.uint8)
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


def read_png(path):
    """What write_png has written."""
    data = pathlib.Path(path).read_bytes()
    chunks, place = {}, 8
    while place < len(data):
        size, = struct.unpack(">I", data[place:place + 4])
        kind = data[place + 4:place + 8]
        chunks[kind] = chunks.get(kind, b"") + data[place + 8:place + 8 + size]
        place += size + 12
    width, height = struct.unpack(">II", chunks[b"IHDR"][:8])
    rows = numpy.frombuffer(zlib.decompress(chunks[b"IDAT"]), numpy.uint8).reshape(height, width + 1)
    palette = numpy.frombuffer(chunks[b"PLTE"], numpy.uint8).reshape(-1, 3)
    return palette[rows[:, 1:]]
