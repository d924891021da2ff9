# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How the scripts beside this folder take their arguments, and how they end."""

import argparse
import sys

from .Structures import FormatError


def parser_of(arguments, usage, help_text):
    """A parser whose help is the docstring of the script. Prints that, and ends, if it is asked for;
    without arguments it is an error."""
    if {"-h", "--help"}.intersection(arguments):
        print(help_text)
        sys.exit(0)
    if not arguments:
        sys.exit(help_text)
    return argparse.ArgumentParser(usage=usage, add_help=False)


def status_of(work):
    """The exit status of a script that does this: 1, with a sentence for the user, if something that
    it reads cannot be used."""
    try:
        work()
        return 0
    except (FormatError, RuntimeError) as error:
        print(error, file=sys.stderr)
        return 1
