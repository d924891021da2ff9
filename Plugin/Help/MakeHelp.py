# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Help pages for ParaView's help window, made from what ParaView itself reads: the plugin's XML.

    python3 MakeHelp.py NAME FOLDER PICTURES XML...

Writes into FOLDER a page for each filter, an index of them, the pictures that they show (copies of
those in the folder PICTURES) and NAME.qhp, of which qhelpgenerator makes NAME.qch. The help button of
a filter opens the page GROUP.FILTER.html of the name space NAME.org. So texts are written once, in the
XML; only the pictures below are named here.
"""

import html
import os
import re
import shutil
import sys
from xml.etree import ElementTree

# Pictures of each filter with their captions, in the order in which they are shown.
FIGURES = {
    "OrthogonalSliceReconstruction": [
        ("inputs.png", "The three inputs, as the dialog asks for them."),
        ("surface.png", "The surface after Apply, and its other outputs in the pipeline browser."),
        ("inspect.png", "The macro Inspect Slices: where contours disagree, how much each slice does, "
                        "and the worst slice as it was drawn and as the others have it."),
    ],
    "ParallelSliceReconstruction": [
        ("stack.png", "A stack of contours, and the surface through them."),
    ],
    "OrthogonalSlicer": [
        ("slicer.png", "A model, and its contours on the planes of three axes."),
    ],
}

WIDTH = 680  # of pictures: what the help window has room for when it opens
STYLE = ("body { font-family: sans-serif; margin: 1em; } h1 { font-size: x-large; } "
         "h2 { font-size: large; } td, th { padding: 4px; vertical-align: top; text-align: left; }")


def paragraphs(text):
    """The paragraphs of an indented text, each in one line."""
    return [" ".join(part.split()) for part in re.split(r"\n\s*\n", text or "") if part.strip()]


def as_html(text):
    return "".join(f"<p>{html.escape(part)}</p>\n" for part in paragraphs(text))


def documentation(element):
    found = element.find("Documentation")
    return found.text if found is not None else ""


def label_of(element):
    """The label that the panel shows: that of the XML, or the name with its words apart."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", element.get("name"))
    return element.get("label") or words


def properties_of(proxy):
    return [element for element in proxy if element.tag.endswith("VectorProperty")
            and element.get("panel_visibility") != "never"
            and element.get("information_only") != "1"]


def property_groups(proxy):
    """Pairs of a heading and the properties below it, as the panel has them."""
    named = {element.get("name"): element for element in properties_of(proxy)}
    groups = []
    for group in proxy.findall("PropertyGroup"):
        members = [named.pop(child.get("name")) for child in group if child.get("name") in named]
        groups.append((group.get("label"), members))
    return ([("Properties", list(named.values()))] if named else []) + groups


def property_row(element):
    choices = [entry.get("text") for entry in element.findall("EnumerationDomain/Entry")]
    text = as_html(documentation(element))
    if choices:
        text += f"<p>Choices: <i>{html.escape(', '.join(choices))}</i>.</p>\n"
    advanced = " *" if element.get("panel_visibility") == "advanced" else ""
    return f"<tr><td><b>{html.escape(label_of(element))}</b>{advanced}</td><td>{text}</td></tr>\n"


def table(rows):
    return f'<table border="1" cellspacing="0">\n{"".join(rows)}</table>\n'


def page(title, body):
    return (f'<html><head><meta charset="utf-8"/><title>{html.escape(title)}</title>'
            f"<style>{STYLE}</style></head><body>\n<h1>{html.escape(title)}</h1>\n{body}</body></html>\n")


def page_of(proxy):
    """What the filter does, what goes in and comes out, and each property of its panel."""
    body = [as_html(documentation(proxy))]
    for picture, caption in FIGURES.get(proxy.get("name"), []):
        body.append(f'<p><img src="{picture}" width="{WIDTH}"/><br/><i>{html.escape(caption)}</i></p>\n')
    inputs = [element for element in proxy.findall("InputProperty")
              if element.get("panel_visibility") != "never"]
    body.append("<h2>Inputs</h2>\n" + table(map(property_row, inputs)))
    for heading, members in property_groups(proxy):
        body.append(f"<h2>{html.escape(heading)}</h2>\n" + table(map(property_row, members)))
    body.append("<p>* advanced: shown by the cogwheel of the panel.</p>\n")
    ports = "".join(f"<li>{html.escape(port.get('name'))}</li>" for port in proxy.findall("OutputPort"))
    body.append(f"<h2>Outputs</h2>\n<ol>{ports}</ol>\n" if ports else "")
    body.append('<p><a href="index.html">All filters of the plugin</a></p>\n')
    return page(label_of(proxy), "".join(body))


def index_of(files):
    rows = [f'<li><a href="{name}">{html.escape(label)}</a>: {html.escape(short)}</li>\n'
            for name, label, short in files]
    return page("Orthogonal Slices", f"<ul>\n{''.join(rows)}</ul>\n")


def project_of(name, files, all_files):
    """The project of qhelpgenerator: contents, and the files that go into the archive."""
    sections = "".join(f'<section title="{html.escape(label)}" ref="{file}"/>\n'
                       for file, label, _ in files)
    listed = "".join(f"<file>{file}</file>\n" for file in all_files)
    return (f'<?xml version="1.0" encoding="UTF-8"?>\n<QtHelpProject version="1.0">\n'
            f"<namespace>{name}.org</namespace>\n<virtualFolder>{name}</virtualFolder>\n"
            f"<filterSection>\n<toc>\n"
            f'<section title="Orthogonal Slices" ref="index.html">\n{sections}</section>\n</toc>\n'
            f"<files>\n{listed}</files>\n</filterSection>\n</QtHelpProject>\n")


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)


def main(name, folder, pictures, *sources):
    os.makedirs(folder, exist_ok=True)
    files, all_files = [], ["index.html"]
    for source in sources:
        for group in ElementTree.parse(source).getroot().findall("ProxyGroup"):
            for proxy in group.findall("SourceProxy"):
                file = f"{group.get('name')}.{proxy.get('name')}.html"
                write(folder, file, page_of(proxy))
                short = proxy.find("Documentation").get("short_help")
                files.append((file, label_of(proxy), short))
                for picture, _ in FIGURES.get(proxy.get("name"), []):
                    shutil.copy(os.path.join(pictures, picture), folder)
                    all_files.append(picture)
    write(folder, "index.html", index_of(files))
    all_files += [file for file, _, _ in files]
    write(folder, f"{name}.qhp", project_of(name, files, all_files))


if __name__ == "__main__":
    main(*sys.argv[1:])
